// SPDX-License-Identifier: BSD-3-Clause
// The draw and dispatch calls that our own programs need.
#ifndef rtwDrawing_h
#define rtwDrawing_h

#include <cstddef>
#include <cstdint>

namespace rtw
{
class Buffer;

/// A draw call as OpenGL lays it out in a buffer for indirect draws.
struct DrawCommand
{
  std::uint32_t Count;
  std::uint32_t InstanceCount;
  std::uint32_t FirstIndex;
  std::uint32_t BaseVertex;
  std::uint32_t BaseInstance;
};

enum class Primitive
{
  Triangles,
  Lines,
  Points
};

/// Meshes with 3-float points at attribute 0 and, an instance, a 4 × 4 matrix by its columns at attributes 1 to 4.
class MeshArray
{
public:
  MeshArray() = default;
  MeshArray(const MeshArray&) = delete;
  MeshArray& operator=(const MeshArray&) = delete;

  void Bind(const Buffer& points, const Buffer& indices, const Buffer& matrices);
  void DrawIndirect(const Buffer& commands, int count) const;
  void Draw(Primitive primitive, const DrawCommand& command) const;
  void Release();
  void Abandon() { this->Id = 0; }

private:
  unsigned int Id = 0;
};

/// Primitives whose vertices the shader reads from storage by itself.
class PulledVertices
{
public:
  PulledVertices() = default;
  PulledVertices(const PulledVertices&) = delete;
  PulledVertices& operator=(const PulledVertices&) = delete;

  /// Draws by commands in a buffer; points are as large as the shader says. Commands are of four
  /// numbers each: vertices, instances, first vertex, first instance.
  void DrawIndirect(
    Primitive primitive, const Buffer& commands, std::size_t offset, int count, std::size_t stride);
  void Release();
  void Abandon() { this->Id = 0; }

private:
  unsigned int Id = 0;
};

/// A triangle without points that covers the viewport: rtwScreenVS.glsl makes them.
class ScreenTriangle
{
public:
  ScreenTriangle() = default;
  ScreenTriangle(const ScreenTriangle&) = delete;
  ScreenTriangle& operator=(const ScreenTriangle&) = delete;

  /// Draws colour, with no depth test and no blending.
  void Draw();
  /// Draws depth alone, where it is less.
  void DrawDepth();
  /// Draws colour, blended by its alpha, where depth is less or equal; depth stays.
  void DrawOver();
  void Release();
  void Abandon() { this->Id = 0; }

private:
  void DrawArrays(bool blend = false);

  unsigned int Id = 0;
};

/// The largest size that a point can have, in pixels.
float LargestPointSize();
/// Runs the compute program in use, then makes what it wrote visible to all that follows.
void Dispatch(int groupsX, int groupsY = 1, int groupsZ = 1);
/// Runs the compute program in use like Dispatch(), with the numbers of groups along x, y and z
/// from a buffer.
void DispatchIndirect(const Buffer& groups, std::size_t offset);
/// Makes what programs wrote visible to all that follows, which waits for what they read.
void ShowWhatWasWritten();
/// A number of work groups of that size that covers so many items.
int Groups(int items, int size);
/// Blocks until the GPU has nothing left to do.
void Finish();
}

#endif
