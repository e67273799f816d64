// SPDX-License-Identifier: BSD-3-Clause
// View samples: what the camera sees at each pixel, as a plane, from a depth prepass.
#ifndef rtwViewSampler_h
#define rtwViewSampler_h

#include "Frame/rtwLastFrame.h"
#include "Frame/rtwView.h"
#include "GL/rtwBuffer.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwFramebuffer.h"
#include "GL/rtwProgram.h"
#include "GL/rtwResources.h"
#include "GL/rtwTexture.h"

#include <vector>

namespace rtw
{
class GeometryStore;

class ViewSampler
{
public:
  /// Compiles; false, with the reason in GetLog(), where the driver can't.
  bool Build();
  std::string GetLog() const;

  /// Draws the receivers of the store, with `samples` samples a pixel; without `own`, which needs a
  /// successful Build(), it only clears.
  bool Render(const View& view, const GeometryStore& store, bool own, int samples = 1);
  /// Takes the samples from a frame that has been drawn, one for each square of so many pixels a side.
  bool Resample(const LastFrame& frame, int stride);
  /// Makes the samples' target the target of drawing again, for what VTK's mappers have to add.
  bool BindTarget();
  /// Ends drawing: where a pixel has several samples, finds the one that stands for the pixel.
  void Finish();

  /// Draws the samples as depth, a little farther than they are, into the target and viewport that
  /// are bound. `farther` is a distance that rounding doesn't exceed.
  void PrimeDepth(double farther);
  /// Gives a program the samples, one a pixel, and, where pixels have several, all of them as a
  /// second texture.
  void Bind(const Program& program) const;
  /// Gives a program what rtwSampleDepth.glsl needs to turn samples into depths that lie farther by
  /// that distance or, if it is below 0, nearer, and by a share of the sample's own distance.
  void BindDepth(const Program& program, double farther) const;
  /// Samples of each pixel: their number, their places from the pixel's centre, in pixels, and the
  /// texture that holds them.
  int GetSamplesAPixel() const { return static_cast<int>(this->Offsets.size()); }
  const std::vector<glm::vec2>& GetOffsets() const { return this->Offsets; }
  const Texture& GetManySamples() const { return this->Many; }
  const View& GetView() const { return this->Viewed; }
  int GetWidth() const { return this->Current->GetWidth(); }
  int GetHeight() const { return this->Current->GetHeight(); }
  std::size_t GetMemory() const;
  void Dispose(Disposal dispose);

private:
  void Allocate(int samples);
  void FindOffsets(int samples);
  void Cull(const GeometryStore& store, bool receiving);
  void Draw(const GeometryStore& store, bool receiving);
  void DrawThin(const GeometryStore& store);

  View Viewed;
  std::vector<glm::vec2> Offsets{ glm::vec2(0) };
  Texture Depth, Samples, Resampled;
  Texture Many; ///< all samples, where pixels have several
  const Texture* Current = &Samples;
  Framebuffer Target, ScreenTarget;
  Program Culling, Drawing, Priming, Resampling, Resolving;
  Buffer Matrices, Commands;
  MeshArray Array;
  ScreenTriangle Triangle;
};
}

#endif
