#include "GL/rtwBuffer.h"

#include "GL/rtwOpenGL.h"
#include "GL/rtwStateRecord.h"

#include <algorithm>

namespace rtw
{
// The handle of a buffer that nobody released went with its context.
Buffer::~Buffer() = default;

void Buffer::Reserve(std::size_t bytes, bool keep)
{
  bytes = std::max<std::size_t>(bytes, 16);
  if (this->Id && this->Size >= bytes)
  {
    return;
  }
  const BriefChange change;
  const std::size_t size = keep ? std::max(bytes, this->Size + this->Size / 2) : bytes;
  GLuint id = 0;
  glGenBuffers(1, &id);
  BindBuffer(GL_COPY_WRITE_BUFFER, id);
  glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(size), nullptr, GL_DYNAMIC_DRAW);
  if (this->Id)
  {
    if (keep)
    {
      BindBuffer(GL_COPY_READ_BUFFER, this->Id);
      glCopyBufferSubData(
        GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(this->Size));
    }
    glDeleteBuffers(1, &this->Id);
  }
  this->Id = id;
  this->Size = size;
}

void Buffer::Write(std::size_t offset, const void* data, std::size_t bytes)
{
  if (bytes == 0)
  {
    return;
  }
  const BriefChange change;
  BindBuffer(GL_COPY_WRITE_BUFFER, this->Id);
  glBufferSubData(
    GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

void Buffer::Copy(std::size_t to, const Buffer& other, std::size_t from, std::size_t bytes)
{
  const BriefChange change;
  BindBuffer(GL_COPY_READ_BUFFER, other.Id);
  BindBuffer(GL_COPY_WRITE_BUFFER, this->Id);
  glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(from),
    static_cast<GLintptr>(to), static_cast<GLsizeiptr>(bytes));
}

void Buffer::Read(std::size_t offset, void* data, std::size_t bytes) const
{
  const BriefChange change;
  BindBuffer(GL_COPY_READ_BUFFER, this->Id);
  glGetBufferSubData(
    GL_COPY_READ_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

void Buffer::Clear()
{
  const BriefChange change;
  BindBuffer(GL_COPY_WRITE_BUFFER, this->Id);
  // Without a value, Mesa doesn't look at the pixel store; with one it would skip as that says.
  glClearBufferData(GL_COPY_WRITE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void Buffer::BindStorage(unsigned int binding) const
{
  BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, this->Id);
}

void Buffer::BindUniforms(unsigned int binding, std::size_t offset, std::size_t bytes) const
{
  BindBufferRange(GL_UNIFORM_BUFFER, binding, this->Id, offset, bytes);
}

void Buffer::Bind(unsigned int target) const
{
  BindBuffer(target, this->Id);
}

void Buffer::Release()
{
  if (this->Id)
  {
    glDeleteBuffers(1, &this->Id);
  }
  this->Abandon();
}
}
