// SPDX-License-Identifier: BSD-3-Clause
#include "GL/rtwStateRecord.h"

#include "GL/rtwOpenGL.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace rtw
{
namespace
{
using Kind = StateRecord::Kind;
using Piece = StateRecord::Piece;

thread_local StateRecord* Current = nullptr;

struct Binding
{
  GLenum Target;
  GLenum Query;
};

constexpr Binding TextureBindings[] = {
  { GL_TEXTURE_1D, GL_TEXTURE_BINDING_1D },
  { GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D },
  { GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D },
  { GL_TEXTURE_1D_ARRAY, GL_TEXTURE_BINDING_1D_ARRAY },
  { GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY },
  { GL_TEXTURE_RECTANGLE, GL_TEXTURE_BINDING_RECTANGLE },
  { GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER },
  { GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP },
  { GL_TEXTURE_CUBE_MAP_ARRAY, GL_TEXTURE_BINDING_CUBE_MAP_ARRAY },
  { GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE },
  { GL_TEXTURE_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY },
};

constexpr Binding BufferBindings[] = {
  { GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING },
  { GL_ATOMIC_COUNTER_BUFFER, GL_ATOMIC_COUNTER_BUFFER_BINDING },
  { GL_COPY_READ_BUFFER, GL_COPY_READ_BUFFER_BINDING },
  { GL_COPY_WRITE_BUFFER, GL_COPY_WRITE_BUFFER_BINDING },
  { GL_DISPATCH_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER_BINDING },
  { GL_DRAW_INDIRECT_BUFFER, GL_DRAW_INDIRECT_BUFFER_BINDING },
  { GL_PIXEL_PACK_BUFFER, GL_PIXEL_PACK_BUFFER_BINDING },
  { GL_PIXEL_UNPACK_BUFFER, GL_PIXEL_UNPACK_BUFFER_BINDING },
  { GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_BINDING },
  { GL_TEXTURE_BUFFER, GL_TEXTURE_BUFFER_BINDING },
  { GL_TRANSFORM_FEEDBACK_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING },
  { GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING },
};

// Where an indexed target's parts begin and how long they are.
constexpr struct
{
  GLenum Target;
  GLenum Start;
  GLenum Size;
} BufferParts[] = {
  { GL_ATOMIC_COUNTER_BUFFER, GL_ATOMIC_COUNTER_BUFFER_START, GL_ATOMIC_COUNTER_BUFFER_SIZE },
  { GL_SHADER_STORAGE_BUFFER, GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE },
  { GL_TRANSFORM_FEEDBACK_BUFFER, GL_TRANSFORM_FEEDBACK_BUFFER_START,
    GL_TRANSFORM_FEEDBACK_BUFFER_SIZE },
  { GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE },
};

template <std::size_t Size>
GLenum QueryOf(const Binding (&bindings)[Size], GLenum target)
{
  const auto* found = std::find_if(std::begin(bindings), std::end(bindings),
    [&](const Binding& binding) { return binding.Target == target; });
  assert(found != std::end(bindings));
  return found->Query;
}

GLint Get(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

int GetActiveUnit()
{
  return Get(GL_ACTIVE_TEXTURE) - GL_TEXTURE0;
}

void Activate(unsigned int unit)
{
  glActiveTexture(GL_TEXTURE0 + unit);
}

bool IsBinding(Kind what)
{
  return what < Kind::Capability;
}

// Reads what is bound or set; for a texture or a sampler its unit has to be active.
void Read(Piece& piece)
{
  switch (piece.What)
  {
    case Kind::Texture:
      piece.Value = Get(QueryOf(TextureBindings, piece.Name));
      break;
    case Kind::Sampler:
      piece.Value = Get(GL_SAMPLER_BINDING);
      break;
    case Kind::Buffer:
      piece.Value = Get(QueryOf(BufferBindings, piece.Name));
      break;
    case Kind::IndexedBuffer:
    {
      const auto* parts = std::find_if(std::begin(BufferParts), std::end(BufferParts),
        [&](const auto& found) { return found.Target == piece.Name; });
      assert(parts != std::end(BufferParts));
      GLint buffer = 0;
      GLint64 offset = 0, bytes = 0;
      glGetIntegeri_v(QueryOf(BufferBindings, piece.Name), piece.Index, &buffer);
      glGetInteger64i_v(parts->Start, piece.Index, &offset);
      glGetInteger64i_v(parts->Size, piece.Index, &bytes);
      piece.Value = buffer;
      piece.Offset = offset;
      piece.Bytes = bytes;
      break;
    }
    case Kind::Capability:
      piece.Value = glIsEnabled(piece.Name);
      break;
    case Kind::PixelStore:
      piece.Value = Get(piece.Name);
      break;
  }
}

// A name that is no object's any more can't be bound.
GLuint Alive(GLuint name, GLboolean (*exists)(GLuint))
{
  return name != 0 && exists(name) ? name : 0;
}

GLuint AliveBuffer(std::int64_t name)
{
  return Alive(static_cast<GLuint>(name), [](GLuint id) -> GLboolean { return glIsBuffer(id); });
}

void Write(const Piece& piece)
{
  switch (piece.What)
  {
    case Kind::Texture:
      Activate(piece.Index);
      glBindTexture(piece.Name, Alive(static_cast<GLuint>(piece.Value),
                                  [](GLuint id) -> GLboolean { return glIsTexture(id); }));
      break;
    case Kind::Sampler:
      if (piece.Value != 0) // else it still is
      {
        glBindSampler(piece.Index, Alive(static_cast<GLuint>(piece.Value),
                                     [](GLuint id) -> GLboolean { return glIsSampler(id); }));
      }
      break;
    case Kind::Buffer:
      glBindBuffer(piece.Name, AliveBuffer(piece.Value));
      break;
    case Kind::IndexedBuffer:
      if (const GLuint buffer = piece.Bytes > 0 ? AliveBuffer(piece.Value) : 0)
      {
        glBindBufferRange(piece.Name, piece.Index, buffer, static_cast<GLintptr>(piece.Offset),
          static_cast<GLsizeiptr>(piece.Bytes));
      }
      else
      {
        glBindBufferBase(piece.Name, piece.Index, AliveBuffer(piece.Value));
      }
      break;
    case Kind::Capability:
      (piece.Value ? glEnable : glDisable)(piece.Name);
      break;
    case Kind::PixelStore:
      glPixelStorei(piece.Name, static_cast<GLint>(piece.Value));
      break;
  }
}

void Note(Kind what, unsigned int name, unsigned int index = 0)
{
  assert(Current && "a StateGuard is missing: nobody would give this back");
  if (Current)
  {
    Current->Note(what, name, index);
  }
}
}

StateRecord::Scope::Scope(StateRecord* record)
  : Outer(Current)
  , ActiveUnit(record ? GetActiveUnit() : -1)
{
  Current = record;
}

StateRecord::Scope::~Scope()
{
  if (this->ActiveUnit >= 0)
  {
    Activate(static_cast<unsigned int>(this->ActiveUnit));
  }
  Current = this->Outer;
}

const StateRecord::Piece& StateRecord::Note(Kind what, unsigned int name, unsigned int index)
{
  const auto known =
    std::find_if(this->Pieces.begin(), this->Pieces.end(), [&](const Piece& piece) {
      return piece.What == what && piece.Name == name && piece.Index == index;
    });
  if (known != this->Pieces.end())
  {
    return *known;
  }
  this->Pieces.push_back({ what, name, index, 0, 0, 0 });
  if (what != Kind::Sampler || this->HasSamplers())
  {
    Read(this->Pieces.back());
  }
  return this->Pieces.back();
}

// Samplers came with OpenGL 3.3.
bool StateRecord::HasSamplers()
{
  if (!this->KnowsSamplers)
  {
    this->KnowsSamplers = glBindSampler && 10 * Get(GL_MAJOR_VERSION) + Get(GL_MINOR_VERSION) >= 33;
  }
  return *this->KnowsSamplers;
}

void StateRecord::GiveBackBindings()
{
  const int unit = GetActiveUnit();
  // Gives back the last change first: a target of several parts was noted before them, and binding
  // a part binds it too.
  std::for_each(this->Pieces.rbegin(), this->Pieces.rend(), [](const Piece& piece) {
    if (IsBinding(piece.What))
    {
      Write(piece);
    }
  });
  this->Pieces.erase(std::remove_if(this->Pieces.begin(), this->Pieces.end(),
                       [](const Piece& piece) { return IsBinding(piece.What); }),
    this->Pieces.end());
  Activate(static_cast<unsigned int>(unit));
}

void StateRecord::GiveBack()
{
  if (this->Pieces.empty())
  {
    return;
  }
  this->GiveBackBindings();
  std::for_each(this->Pieces.begin(), this->Pieces.end(), Write);
  this->Pieces.clear();
}

BriefChange::BriefChange()
{
  if (!Current)
  {
    this->Taking.emplace(&this->Own);
  }
}

BriefChange::~BriefChange()
{
  this->Own.GiveBack();
}

void BindTexture(int unit, unsigned int target, unsigned int texture)
{
  const unsigned int index = static_cast<unsigned int>(unit);
  Activate(index);
  Note(Kind::Texture, target, index);
  if (Current && Current->Note(Kind::Sampler, 0, index).Value != 0)
  {
    glBindSampler(index, 0);
  }
  glBindTexture(target, texture);
}

void BindBuffer(unsigned int target, unsigned int buffer)
{
  Note(Kind::Buffer, target);
  glBindBuffer(target, buffer);
}

void BindBufferBase(unsigned int target, unsigned int index, unsigned int buffer)
{
  Note(Kind::Buffer, target);
  Note(Kind::IndexedBuffer, target, index);
  glBindBufferBase(target, index, buffer);
}

void BindBufferRange(unsigned int target, unsigned int index, unsigned int buffer,
  std::size_t offset, std::size_t bytes)
{
  Note(Kind::Buffer, target);
  Note(Kind::IndexedBuffer, target, index);
  glBindBufferRange(target, index, buffer, static_cast<GLintptr>(offset),
    static_cast<GLsizeiptr>(bytes));
}

void SetEnabled(unsigned int capability, bool enabled)
{
  Note(Kind::Capability, capability);
  (enabled ? glEnable : glDisable)(capability);
}

void PackTightly()
{
  BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  for (const auto& [name, value] :
    { std::pair<GLenum, GLint>(GL_PACK_ALIGNMENT, 1), { GL_PACK_ROW_LENGTH, 0 },
      { GL_PACK_IMAGE_HEIGHT, 0 }, { GL_PACK_SKIP_PIXELS, 0 }, { GL_PACK_SKIP_ROWS, 0 },
      { GL_PACK_SKIP_IMAGES, 0 }, { GL_PACK_SWAP_BYTES, 0 } })
  {
    Note(Kind::PixelStore, name);
    glPixelStorei(name, value);
  }
}

void UnpackNothing()
{
  BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}
}
