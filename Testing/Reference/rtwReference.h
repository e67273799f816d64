// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwReference_h
#define rtwReference_h

#include <functional>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

class vtkLight;
class vtkProp;
class vtkRenderer;

namespace rtw
{
/// The values of a mask.
enum MaskValue : unsigned char
{
  MASK_SHADOW = 0,
  MASK_BACKGROUND = 64, // nothing is seen
  MASK_AVERTED = 128,   // faces away from the light, is out of its cone, or receives no shadows
  MASK_LIT = 255
};

/// The exact picture of one light's shadows. Rows are in VTK's order: the lowest comes first.
struct Truth
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Mask; // MaskValue
  std::vector<double> Depth;       // as in a depth buffer: 0 on the near plane, 1 behind it all
};

/// What a pixel that faces the light sees, in world coordinates.
struct ViewSample
{
  size_t Pixel; // its index in Truth::Mask
  glm::dvec3 Position;
  glm::dvec3
    ToRight; // where the next pixel's ray would meet the tangent plane, but for perspective
  glm::dvec3 ToAbove;
};

/// What one ray of the view meets.
struct Look
{
  MaskValue Mask = MASK_BACKGROUND;
  double Depth = 1; ///< as in Truth
};

struct ReferenceOptions
{
  /// Whether a prop throws shadows; all do if empty. It is asked for a renderer's view props, and
  /// for each actor in an assembly as well.
  std::function<bool(vtkProp*)> Casts;
  /// Whether shadows fall on it; on all if empty.
  std::function<bool(vtkProp*)> Receives;
  /// Whether rays to the light start at the surface itself, and meet nothing that is less high
  /// above it than rounding may be. Otherwise they start a little off it, which moves edges of
  /// shadows by up to a fifth of a pixel: too much beside what is exact itself.
  bool Sharp = false;
  /// Told the share that is done, now and then, on the thread that called Trace().
  std::function<void(double)> Progress;
  /// 0 for as many as the machine has.
  unsigned Threads = 0;
};

/// Shadows by exact rays, one a pixel, to compare others with.
///
/// A pixel is what a ray through its centre hits first. It faces the light if N·L > 0.001, with the
/// geometric normal turned to the viewer, and, under a spot light, if it is within 0.97 of the
/// tangent of the cone's angle. It is in shadow if anything but the primitive itself lies between
/// it and the light.
class ShadowReference
{
public:
  /// Takes a copy of everything visible in the renderer: triangles of surfaces, composite data,
  /// assemblies and glyphs, and the true spheres and cylinders of sphere and stick mappers. Of
  /// translucent props only the shadow is seen. Left out: lines, points and volumes.
  explicit ShadowReference(vtkRenderer* renderer, const ReferenceOptions& options = {});
  ~ShadowReference();
  ShadowReference(ShadowReference&&) noexcept;

  /// Through the renderer's present camera, for a directional, a spot or a point light. The camera
  /// may have moved, as far as the scene is large; whatever else has changed is seen as it was.
  Truth Trace(vtkLight* light, int width, int height) const;

  /// As Trace() sees a point of that picture, which is given in pixels from its lower left corner.
  /// `clearance` times as far above a surface as Trace() has it do rays to the light begin to meet
  /// anything, where they are sharp.
  Look At(
    vtkLight* light, int width, int height, const glm::dvec2& point, double clearance = 1) const;

  /// The pixels that Trace() says are lit or in shadow, in their order.
  std::vector<ViewSample> Samples(vtkLight* light, int width, int height) const;

  size_t NumberOfPrimitives() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Inside;
};
}

#endif
