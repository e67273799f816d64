// SPDX-License-Identifier: BSD-3-Clause
// View samples: what the camera sees at each pixel, as a plane, from a depth prepass.
#ifndef rtwViewSampler_h
#define rtwViewSampler_h

#include "rtwBuffer.h"
#include "rtwDrawing.h"
#include "rtwFramebuffer.h"
#include "rtwLastFrame.h"
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
  std::string GetLog() const;

  /// Draws the receivers of the store; without `own`, which Build() has to have allowed, it only clears.
  bool Render(const View& view, const GeometryStore& store, bool own);
  /// Takes the samples from a frame that has been drawn, one for each square of so many pixels a side.
  bool Resample(const LastFrame& frame, int stride);
  /// Makes the samples' target that of drawing again, for what VTK's mappers have to add.
  bool BindTarget();

  /// Draws them as depth, a little farther than they are, into the target and viewport that are bound. `farther` is a distance that
  /// rounding doesn't exceed.
  void PrimeDepth(double farther);
  /// Gives a program the samples.
  void Bind(const Program& program) const;
  /// And what rtwSampleDepth.glsl needs to make them depth, farther by that distance or, below 0,
  /// nearer, and by a share of theirs.
  void BindDepth(const Program& program, double farther) const;
  const View& GetView() const { return this->Viewed; }
  int GetWidth() const { return this->Current->GetWidth(); }
  int GetHeight() const { return this->Current->GetHeight(); }
  /// How a mapper's window-space depth becomes what a sample holds of it: scale and offset.
  static glm::dvec2 DepthToSample(const View& view);
  /// From pixel to pixel in view coordinates at distance 1 (anywhere in a parallel view), and there depth a unit.
  static glm::dvec3 RayStep(const View& view);
  std::size_t GetMemory() const;
  void Release();
  void Abandon();

private:
  void Cull(const GeometryStore& store, bool receiving);
  void Draw(const GeometryStore& store, bool receiving);
  void DrawThin(const GeometryStore& store);

  View Viewed;
  Texture Depth, Samples, Resampled;
  const Texture* Current = &Samples;
  Framebuffer Target, ResamplingTarget;
  Program Culling, Drawing, Priming, Resampling;
  Buffer Matrices, Commands;
  MeshArray Array;
  ScreenTriangle Triangle;
};
}

#endif
