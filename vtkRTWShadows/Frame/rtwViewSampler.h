// SPDX-License-Identifier: BSD-3-Clause
// View samples: what the camera sees, as depth and its slope on the screen, from a depth prepass.
#ifndef rtwViewSampler_h
#define rtwViewSampler_h

#include "rtwBuffer.h"
#include "rtwDrawing.h"
#include "rtwFramebuffer.h"
#include "rtwProgram.h"
#include "rtwTexture.h"
#include "rtwView.h"

namespace rtw
{
class GeometryStore;

class ViewSampler
{
public:
  /// Compiles; false, with the reason in GetLog(), where the driver can't.
  bool Build();
  const std::string& GetLog() const;

  /// Draws the receivers of the store, every stride-th pixel of the view along both axes.
  bool Render(const View& view, const GeometryStore& store, int stride);
  /// Makes the samples' target that of drawing again, for what VTK's mappers have to add.
  bool BindTarget();

  /// Gives an analysis the samples.
  void Bind(const Program& program) const;
  const View& GetView() const { return this->Viewed; }
  int GetStride() const { return this->Stride; }
  int GetWidth() const { return this->Depth.GetWidth(); }
  int GetHeight() const { return this->Depth.GetHeight(); }
  std::size_t GetMemory() const;
  void Release();
  void Abandon();

private:
  void Cull(const GeometryStore& store);

  View Viewed;
  int Stride = 1;
  Texture Depth, Slope;
  Framebuffer Target;
  Program Culling, Drawing;
  Buffer Matrices, Commands;
  MeshArray Array;
};
}

#endif
