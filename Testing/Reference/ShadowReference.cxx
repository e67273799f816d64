// SPDX-License-Identifier: BSD-3-Clause
#include "rtwReference.h"

#include "rtwCollect.h"
#include "rtwTracer.h"
#include "rtwViewRays.h"

#include <vtkCamera.h>
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

class PixelTracer
{
public:
  // `eye` is where the view's rays are relative to, in the coordinates of Geometry.
  PixelTracer(const Tracer& tracer, double diagonal, const ViewRays& view, const dvec3& eye,
    const LightRays& light, bool sharp, double clearance = 1)
    : Rays(tracer)
    , Diagonal(diagonal)
    , View(view)
    , Eye(eye)
    , Light(light)
    , IsSharp(sharp)
    , Clearance(clearance)
  {
  }

  /// A point in pixels.
  Look operator()(const glm::dvec2& point) const
  {
    const std::optional<Seen> seen = this->Find(point.x, point.y);
    return seen
      ? Look{ this->Shade(*seen), this->View.WindowDepth(seen->Surface.Position - this->Eye) }
      : Look{};
  }

  /// But for the index, and only where the light is faced.
  std::optional<ViewSample> Sample(int x, int y) const
  {
    const std::optional<Seen> seen = this->Find(x + 0.5, y + 0.5);
    if (!seen || !this->FacesLight(*seen))
    {
      return std::nullopt;
    }
    const SurfacePoint& at = seen->Surface;
    const dvec3 origin = this->Rays.Scene().Origin;
    return ViewSample{ 0, at.Position + origin, this->Moves(x, y, { 1, 0 }, at),
      this->Moves(x, y, { 0, 1 }, at) };
  }

private:
  struct Seen
  {
    SurfacePoint Surface; // its normal is turned to the viewer
    Primitive What;
  };

  Ray RayAt(double x, double y) const
  {
    Ray ray = this->View.At(x, y);
    ray.Origin += this->Eye;
    return ray;
  }

  std::optional<Seen> Find(double x, double y) const
  {
    const Ray ray = this->RayAt(x, y);
    const std::optional<Hit> hit = this->Rays.First(ray);
    if (!hit)
    {
      return std::nullopt;
    }
    SurfacePoint surface = Meet(this->Rays.Scene(), hit->What, ray, hit->Distance);
    if (glm::dot(surface.Normal, ray.Direction) > 0)
    {
      surface.Normal = -surface.Normal;
    }
    return Seen{ surface, hit->What };
  }

  // How far a ray's meeting point with the tangent plane moves for a pixel, measured over a
  // fraction of one: a whole one may be beyond the plane's horizon.
  dvec3 Moves(int x, int y, const glm::dvec2& pixel, const SurfacePoint& at) const
  {
    const double fraction = 1.0 / 64;
    const auto meet = [&](double share) {
      const Ray ray = this->RayAt(x + 0.5 + share * pixel.x, y + 0.5 + share * pixel.y);
      return ray.At(
        glm::dot(at.Position - ray.Origin, at.Normal) / glm::dot(ray.Direction, at.Normal));
    };
    return (meet(fraction) - meet(-fraction)) / (2 * fraction);
  }

  bool FacesLight(const Seen& seen) const
  {
    const SurfacePoint& at = seen.Surface;
    // So that it also turns away a degenerate triangle, whose normal is not a number.
    const bool isFacing = -glm::dot(at.Normal, this->Light.Towards(at.Position)) > 1e-3;
    return isFacing && this->Light.Reaches(at.Position) &&
      Traits(this->Rays.Scene(), seen.What).Receives;
  }

  MaskValue Shade(const Seen& seen) const
  {
    if (!this->FacesLight(seen))
    {
      return MASK_AVERTED;
    }
    // Off the surface by more than its coordinates may be wrong: they were rounded relative to the
    // world's origin, which may be far off, when the mesh was made, and to the camera's position
    // when it was collected. By no more than that, or thin things lose their shadows.
    const SurfacePoint& at = seen.Surface;
    const double fromOrigin = glm::length(at.Position + this->Rays.Scene().Origin);
    const double whenMade = 1e-5 * (std::min(fromOrigin, this->Diagonal) + 0.05 * this->Diagonal);
    const double offset = std::max(whenMade, 1e-6 * glm::length(at.Position));
    const Ray ray = this->IsSharp
      ? this->SharpRay(at, 0.3 * this->Clearance * offset)
      : Ray{ at.Position + at.Normal * offset, -this->Light.Towards(at.Position), offset,
          this->Light.Distance(at.Position) };
    return this->Rays.IsBlocked(ray, seen.What) ? MASK_SHADOW : MASK_LIT;
  }

  // Starts at the surface, and meets nothing until it is that high above it.
  Ray SharpRay(const SurfacePoint& at, double height) const
  {
    const dvec3 way = -this->Light.Towards(at.Position);
    return { at.Position, way, height / glm::dot(at.Normal, way),
      this->Light.Distance(at.Position) };
  }

  const Tracer& Rays;
  double Diagonal;
  const ViewRays& View;
  dvec3 Eye;
  const LightRays& Light;
  bool IsSharp;
  double Clearance;
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

  // Calls work(trace) with what traces rays of that picture.
  template <class Work>
  void WithTracer(vtkLight* light, int width, int height, double clearance, Work work) const
  {
    // Lights that go with the camera are placed by the renderer, at each frame.
    this->Renderer->UpdateLightsGeometryToFollowCamera();
    const LightRays lightRays(light, this->Rays.Scene().Origin);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const ViewRays view(camera, width, height);
    const dvec3 eye = EyePosition(camera) - this->Rays.Scene().Origin;
    work(PixelTracer(
      this->Rays, this->Diagonal, view, eye, lightRays, this->Options.Sharp, clearance));
  }

  // Calls work(trace, x, y) for all pixels, row by row.
  template <class Work>
  void ForEachPixel(vtkLight* light, int width, int height, Work work) const
  {
    this->WithTracer(light, width, height, 1, [&](const PixelTracer& trace) {
      const auto row = [&](int y) {
        for (int x = 0; x < width; ++x)
        {
          work(trace, x, y);
        }
      };
      ForEachRow(height, this->Options, row);
    });
  }
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
  Truth truth;
  truth.Width = width;
  truth.Height = height;
  truth.Mask.resize(size_t(width) * height);
  truth.Depth.resize(truth.Mask.size());
  const auto pixel = [&](const PixelTracer& trace, int x, int y) {
    const size_t i = size_t(y) * width + x;
    const Look seen = trace(glm::dvec2(x + 0.5, y + 0.5));
    truth.Mask[i] = seen.Mask;
    truth.Depth[i] = seen.Depth;
  };
  this->Inside->ForEachPixel(light, width, height, pixel);
  return truth;
}

Look ShadowReference::At(
  vtkLight* light, int width, int height, const glm::dvec2& point, double clearance) const
{
  Look look;
  this->Inside->WithTracer(
    light, width, height, clearance, [&](const PixelTracer& trace) { look = trace(point); });
  return look;
}

std::vector<ViewSample> ShadowReference::Samples(vtkLight* light, int width, int height) const
{
  std::vector<std::vector<ViewSample>> rows(height);
  const auto pixel = [&](const PixelTracer& trace, int x, int y) {
    if (std::optional<ViewSample> sample = trace.Sample(x, y))
    {
      sample->Pixel = size_t(y) * width + x;
      rows[y].push_back(*sample);
    }
  };
  this->Inside->ForEachPixel(light, width, height, pixel);
  std::vector<ViewSample> samples;
  for (const std::vector<ViewSample>& row : rows)
  {
    samples.insert(samples.end(), row.begin(), row.end());
  }
  return samples;
}

size_t ShadowReference::NumberOfPrimitives() const
{
  const Geometry& scene = this->Inside->Rays.Scene();
  return scene.Triangles.size() + scene.Balls.size() + scene.Sticks.size();
}
}
