// SPDX-License-Identifier: BSD-3-Clause
// What raw calls change of that OpenGL state of which VTK keeps no record: whatever is bound, and a few settings. The
// functions below are the only ones that change it, and note what was there before, so that it can be given back
// without anybody's knowing beforehand which units, targets and buffers a stage uses.
#ifndef rtwStateRecord_h
#define rtwStateRecord_h

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rtw
{
class StateRecord
{
public:
  StateRecord() = default;
  StateRecord(const StateRecord&) = delete;
  StateRecord& operator=(const StateRecord&) = delete;

  /// While the innermost one lives, this thread's changes are noted in its record, or nowhere where that is null: then
  /// whoever makes one gives it back himself. Which texture unit is active is as before when it goes.
  class Scope
  {
  public:
    explicit Scope(StateRecord* record);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    StateRecord* Outer;
    int ActiveUnit;
  };

  /// Gives back all that has changed, and forgets it. What was deleted meanwhile stays unbound.
  void GiveBack();
  /// Gives back what was bound, but leaves the settings.
  void GiveBackBindings();

  enum class Kind
  {
    Texture,
    Sampler,
    Buffer,
    IndexedBuffer,
    Capability,
    PixelStore
  };
  struct Piece
  {
    Kind What;
    unsigned int Name; ///< OpenGL's name of the target or the setting
    unsigned int Index;
    std::int64_t Value, Offset, Bytes;
  };
  /// Notes what is there, unless that is done already, and tells what was there before all changes.
  const Piece& Note(Kind what, unsigned int name, unsigned int index = 0);

private:
  bool HasSamplers();

  std::optional<bool> KnowsSamplers;
  std::vector<Piece> Pieces;
};

/// Guards one operation that may stand anywhere: where nobody takes note of changes, its own are
/// given back when it ends.
class BriefChange
{
public:
  BriefChange();
  ~BriefChange();
  BriefChange(const BriefChange&) = delete;
  BriefChange& operator=(const BriefChange&) = delete;

private:
  StateRecord Own;
  std::optional<StateRecord::Scope> Taking;
};

/// A texture unit for what is done to a texture itself; no program of ours looks there.
constexpr int WorkUnit = 15;

/// Binds a texture and no sampler, which would stand above the texture's own settings.
void BindTexture(int unit, unsigned int target, unsigned int texture);
/// Binds a buffer; not for GL_ELEMENT_ARRAY_BUFFER, which belongs to a vertex array.
void BindBuffer(unsigned int target, unsigned int buffer);
void BindBufferBase(unsigned int target, unsigned int index, unsigned int buffer);
void BindBufferRange(unsigned int target, unsigned int index, unsigned int buffer,
  std::size_t offset, std::size_t bytes);
/// Switches a capability; only for those of which vtkOpenGLState keeps no record, or which it
/// doesn't give back.
void SetEnabled(unsigned int capability, bool enabled);
/// Sets the pixel store so that images of floats are read into memory without gaps.
void PackTightly();
/// Sets the pixel store so that images without data can be made.
void UnpackNothing();
}

#endif
