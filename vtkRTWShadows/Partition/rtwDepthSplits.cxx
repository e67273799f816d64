// SPDX-License-Identifier: BSD-3-Clause
#include "Partition/rtwDepthSplits.h"

#include "Frame/rtwFramedView.h"
#include "Light/rtwMinimalFrustum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtw
{
namespace
{
// Least near end as a share of the far end, since a parallel view may begin at 0.
constexpr double LeastNear = 1e-3;
// A range that is chosen anew goes beyond what it has to hold by these factors, and one that is
// held by no more than those. The near end moves much while the camera moves little, and matters
// little.
constexpr double SpareNear = 2, MostNearer = 16;
constexpr double SpareFar = 1.25, MostFarther = 4;

double RoundedPower(double value, double steps, double (*round)(double))
{
  return std::exp2(round(std::log2(value) * steps) / steps);
}

double Extent(const Rectangle& r, int axis)
{
  return std::max(r.High[axis] - r.Low[axis], 0.0);
}

void Unite(DepthBin& into, const DepthBin& bin)
{
  if (!bin.Any)
  {
    return;
  }
  into.Bounds = into.Any ? Rectangle{ glm::min(into.Bounds.Low, bin.Bounds.Low),
    glm::max(into.Bounds.High, bin.Bounds.High) }
                         : bin.Bounds;
  into.Demand += bin.Demand;
  into.Any = true;
}

double ErrorOf(const DepthBin& run)
{
  return Extent(run.Bounds, 0) * run.Demand.x + Extent(run.Bounds, 1) * run.Demand.y;
}

// The point at a depth on the ray through clip coordinates, in a view whose coordinates begin at
// the eye.
glm::dvec3 OnRay(const View& view, const glm::dvec2& clip, double depth)
{
  const glm::dvec4 h = view.ClipToView * glm::dvec4(clip, 0, 1);
  const glm::dvec3 p = glm::dvec3(h) / h.w;
  return view.Parallel ? glm::dvec3(p.x, p.y, -depth) : p * (depth / -p.z);
}

glm::dvec3 InWorld(const View& view, const glm::dvec3& p)
{
  return glm::dvec3(view.ViewToWorld * glm::dvec4(p, 1));
}

struct Sphere
{
  glm::dvec3 Centre; // in world coordinates
  double Radius;
};

// The sphere around a slice of the view. Its radius doesn't depend on where the camera is, nor on
// rounding.
Sphere SphereOf(const View& seen, const glm::dvec2& depths)
{
  const View view = AtEye(seen);
  std::vector<glm::dvec3> corners;
  for (const double depth : { depths.x, depths.y })
  {
    for (int k = 0; k < 4; ++k)
    {
      corners.push_back(OnRay(view, glm::dvec2(k % 2 ? 1 : -1, k / 2 ? 1 : -1), depth));
    }
  }
  // The centre is as far from near corners as from far ones, if such a point lies between them.
  const glm::dvec3 low = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  const glm::dvec3 high = 0.25 * (corners[4] + corners[5] + corners[6] + corners[7]);
  const double length = std::max(glm::length(high - low), 1e-300);
  const double nearWidth = glm::length(corners[0] - low), farWidth = glm::length(corners[4] - high);
  const double along = std::clamp(
    0.5 * (length * length + farWidth * farWidth - nearWidth * nearWidth) / length, 0.0, length);
  const glm::dvec3 centre = low + (high - low) * (along / length);
  double radius = 0;
  for (const glm::dvec3& corner : corners)
  {
    radius = std::max(radius, glm::length(corner - centre));
  }
  return { InWorld(view, centre), RoundedPower(radius * (1 + 1e-9), 64, std::ceil) };
}
}

std::vector<double> SplitDepths(const glm::dvec2& range, int layers, double lambda)
{
  std::vector<double> borders;
  for (int k = 0; k <= layers; ++k)
  {
    const double share = double(k) / layers;
    const double ratio = range.x * std::pow(range.y / range.x, share);
    borders.push_back(lambda * ratio + (1 - lambda) * (range.x + (range.y - range.x) * share));
  }
  return borders;
}

// Splits bins by dynamic programming: the best layers up to a bin begin with the best up to where
// the last layer begins.
std::vector<int> SplitBins(const std::vector<DepthBin>& bins, int layers)
{
  const int count = static_cast<int>(bins.size());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<std::vector<double>> least(layers + 1, std::vector<double>(count + 1, infinity));
  std::vector<std::vector<int>> begin(layers + 1, std::vector<int>(count + 1, 0));
  least[0][0] = 0;
  for (int layer = 1; layer <= layers; ++layer)
  {
    for (int end = 0; end <= count; ++end)
    {
      DepthBin run;
      least[layer][end] = least[layer - 1][end];
      begin[layer][end] = end;
      for (int first = end - 1; first >= 0; --first)
      {
        Unite(run, bins[first]);
        const double error = least[layer - 1][first] + ErrorOf(run);
        if (error < least[layer][end])
        {
          least[layer][end] = error;
          begin[layer][end] = first;
        }
      }
    }
  }
  std::vector<int> firsts(layers);
  for (int layer = layers, end = count; layer > 0; --layer)
  {
    end = begin[layer][end];
    firsts[layer - 1] = end;
  }
  return firsts;
}

glm::dvec2 SteadyRange(const View& seen, const glm::dvec2& held)
{
  const View view = AtEye(seen);
  const auto depthAt = [&](double z) {
    const glm::dvec4 p = view.ClipToView * glm::dvec4(0, 0, z, 1);
    return -p.z / p.w;
  };
  const double farthest = std::max(depthAt(1), 1e-300);
  const double nearest = std::max(depthAt(-1), LeastNear * farthest);
  const bool holds = held.x <= nearest && held.y >= farthest;
  const bool isWide = nearest > MostNearer * held.x || farthest * MostFarther < held.y;
  return holds && !isWide ? held : glm::dvec2(nearest / SpareNear, farthest * SpareFar);
}

std::vector<glm::dvec3> SliceCorners(const View& seen, double nearest, double farthest)
{
  const View view = AtEye(seen);
  std::vector<glm::dvec3> corners;
  for (int k = 0; k < 8; ++k)
  {
    const glm::dvec2 clip(k % 2 ? 1 : -1, k / 2 % 2 ? 1 : -1);
    corners.push_back(InWorld(view, OnRay(view, clip, k < 4 ? nearest : farthest)));
  }
  return corners;
}

Rectangle SteadyFocus(const LightFrame& frame, const View& view, const glm::dvec2& depths,
  const FilterReach& reach, int resolution)
{
  // Texels for what is seen: a whole texel on either side is spare, and so is what a filter reaches
  // on the map.
  const double inner = std::max((1 - 2 * reach.Share) * resolution - 2, 1.0);
  glm::dvec2 low, origin;
  double side;
  if (frame.Light.Kind == LightKind::Spot)
  {
    // The side is the cone's times a power of a half, because the slice's size on the plane isn't
    // steady.
    const Rectangle seen = BoundsOnLightPlane(frame, SliceCorners(view, depths.x, depths.y));
    const double across = reach.World / frame.NearestDistance;
    const glm::dvec2 from = glm::max(seen.Low - across, frame.Bounds.Low);
    const glm::dvec2 to = glm::min(seen.High + across, frame.Bounds.High);
    const double whole = Extent(frame.Bounds, 0);
    const double needed =
      std::clamp(std::max(to.x - from.x, to.y - from.y) / whole, 1.0 / 65536, 1.0);
    side = whole * RoundedPower(needed, 4, std::ceil);
    low = from;
    origin = frame.ConeCentre;
  }
  else
  {
    const Sphere sphere = SphereOf(view, depths);
    side = 2 * (sphere.Radius + reach.World);
    low = glm::dvec2(frame.WorldToLight * glm::dvec4(sphere.Centre, 1)) - 0.5 * side;
    origin = glm::dvec2(frame.WorldToLight[3]);
  }
  const double texel = side / inner;
  low = glm::floor((low - origin) / texel - reach.Share * resolution) * texel + origin;
  return { low, low + texel * resolution };
}
}
