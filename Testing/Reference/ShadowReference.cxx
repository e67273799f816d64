// SPDX-License-Identifier: BSD-3-Clause
#include "rtwReference.h"

#include "rtwCollect.h"
#include "rtwTracer.h"
#include "rtwViewRays.h"

#include <vtkLight.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

namespace rtw
{
namespace
{
// The way light takes, in the coordinates of Geometry.
class LightRays
{
public:
  LightRays(vtkLight* light, const dvec3& origin)
    : IsPositional(light->GetPositional())
  {
    dvec3 focal;
    light->GetTransformedPosition(&this->Position.x);
    light->GetTransformedFocalPoint(&focal.x);
    this->Axis = glm::normalize(focal - this->Position);
    this->Position -= origin;
    if (this->IsPositional && light->GetConeAngle() < 90)
    {
      // Short of the cone's edge, about which pictures need not agree.
      this->Cone = 0.97 * std::tan(glm::radians(light->GetConeAngle()));
    }
  }

  dvec3 Towards(const dvec3& p) const
  {
    return this->IsPositional ? glm::normalize(p - this->Position) : this->Axis;
  }

  double Distance(const dvec3& p) const
  {
    return this->IsPositional ? glm::distance(p, this->Position)
                              : std::numeric_limits<double>::infinity();
  }

  bool Reaches(const dvec3& p) const
  {
    const dvec3 way = p - this->Position;
    const double along = glm::dot(way, this->Axis);
    return this->Cone == 0 ||
      (along > 0 && glm::length(way - along * this->Axis) < this->Cone * along);
  }

private:
  bool IsPositional;
  dvec3 Position{ 0 };
  dvec3 Axis{ 0 };
  double Cone = 0; // a tangent; 0 if there is none
};

struct Pixel
{
  MaskValue Mask = MASK_BACKGROUND;
  double Depth = 1;
};

class PixelTracer
{
public:
  PixelTracer(const Tracer& tracer, double diagonal, const ViewRays& view, const LightRays& light)
    : Rays(tracer)
    , Diagonal(diagonal)
    , View(view)
    , Light(light)
  {
  }

  Pixel operator()(int x, int y) const
  {
    const Ray ray = this->View.At(x + 0.5, y + 0.5);
    const std::optional<Hit> hit = this->Rays.First(ray);
    if (!hit)
    {
      return {};
    }
    SurfacePoint surface = Meet(this->Rays.Scene(), hit->What, ray, hit->Distance);
    if (glm::dot(surface.Normal, ray.Direction) > 0)
    {
      surface.Normal = -surface.Normal;
    }
    return { this->Shade(surface, hit->What), this->View.WindowDepth(surface.Position) };
  }

private:
  MaskValue Shade(const SurfacePoint& at, const Primitive& primitive) const
  {
    const dvec3 light = this->Light.Towards(at.Position);
    // Negated, so that it also turns away a degenerate triangle, whose normal is not a number.
    const bool isAverted = !(-glm::dot(at.Normal, light) > 1e-3);
    if (isAverted || !this->Light.Reaches(at.Position) ||
      !Traits(this->Rays.Scene(), primitive).Receives)
    {
      return MASK_AVERTED;
    }
    // Off the surface by more than its coordinates may be wrong: they were rounded relative to the
    // world's origin, which may be far off, when the mesh was made, and to the camera's position
    // when it was collected.
    const double fromOrigin = glm::length(at.Position + this->Rays.Scene().Origin);
    const double size = std::max(glm::length(at.Position), std::min(fromOrigin, this->Diagonal));
    const double offset = 1e-5 * (size + 0.05 * this->Diagonal);
    const Ray ray{ at.Position + at.Normal * offset, -light, offset,
      this->Light.Distance(at.Position) };
    return this->Rays.IsBlocked(ray, primitive) ? MASK_SHADOW : MASK_LIT;
  }

  const Tracer& Rays;
  double Diagonal;
  const ViewRays& View;
  const LightRays& Light;
};

// Calls work(row) for all rows on some threads, this one among them.
void ForEachRow(int rows, const ReferenceOptions& options, const std::function<void(int)>& work)
{
  std::atomic<int> next{ 0 };
  const auto run = [&](bool tells) {
    for (int row = next++; row < rows; row = next++)
    {
      work(row);
      if (tells && options.Progress)
      {
        options.Progress(double(row + 1) / rows);
      }
    }
  };
  const unsigned threads = options.Threads ? options.Threads : std::thread::hardware_concurrency();
  std::vector<std::thread> others;
  for (unsigned i = 1; i < threads; ++i)
  {
    others.emplace_back(run, false);
  }
  run(true);
  for (std::thread& other : others)
  {
    other.join();
  }
}
}

struct ShadowReference::Internals
{
  vtkSmartPointer<vtkRenderer> Renderer;
  ReferenceOptions Options;
  Tracer Rays;
  double Diagonal;
};

ShadowReference::ShadowReference(vtkRenderer* renderer, const ReferenceOptions& options)
  : Inside(new Internals{ renderer, options, Tracer(Collect(renderer, options)), 0 })
{
  this->Inside->Diagonal = this->Inside->Rays.Scene().Diagonal();
}

ShadowReference::~ShadowReference() = default;
ShadowReference::ShadowReference(ShadowReference&&) noexcept = default;

Truth ShadowReference::Trace(vtkLight* light, int width, int height) const
{
  // Lights that go with the camera are placed by the renderer, at each frame.
  this->Inside->Renderer->UpdateLightsGeometryToFollowCamera();
  const LightRays lightRays(light, this->Inside->Rays.Scene().Origin);
  const ViewRays view(this->Inside->Renderer->GetActiveCamera(), width, height);
  const PixelTracer trace(this->Inside->Rays, this->Inside->Diagonal, view, lightRays);

  Truth truth;
  truth.Width = width;
  truth.Height = height;
  truth.Mask.resize(size_t(width) * height);
  truth.Depth.resize(truth.Mask.size());
  const auto row = [&](int y) {
    for (int x = 0; x < width; ++x)
    {
      const size_t i = size_t(y) * width + x;
      const Pixel pixel = trace(x, y);
      truth.Mask[i] = pixel.Mask;
      truth.Depth[i] = pixel.Depth;
    }
  };
  ForEachRow(height, this->Inside->Options, row);
  return truth;
}

size_t ShadowReference::NumberOfPrimitives() const
{
  const Geometry& scene = this->Inside->Rays.Scene();
  return scene.Triangles.size() + scene.Balls.size() + scene.Sticks.size();
}
}
