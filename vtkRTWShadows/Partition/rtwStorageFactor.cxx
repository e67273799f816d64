// SPDX-License-Identifier: BSD-3-Clause
#include "Partition/rtwStorageFactor.h"

#include "Warp/Perspective/rtwPerspectiveWarp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace rtw
{
namespace
{
// Length of a projected direction below which it is nothing but rounding.
constexpr double LeastLength = 1e-9;
constexpr double Strongest = 1e8;    // (f' - n') / n' in the search
constexpr int Steps = 80;            // steps of the search

// A part of the frustum that has a map, by its corners, from the eye: the beams that count are
// those at them.
struct Part
{
  std::vector<glm::dvec3> Corners;
  glm::dvec3 Along;    ///< the direction of t, before the part along the light is taken off
  double Nearest = 0;  ///< distance along the view
  bool IsFace = false; ///< whether it is a side of the frustum
};

// A part as it lies on the light plane: x across, y along the part's t.
struct Shown
{
  std::vector<glm::dvec2> Corners;
  std::vector<double> Widths; ///< widths of the image beams at the corners
  glm::dvec2 Low, High;
};

// The width of an image beam at p, in the unit of Equations 7 and 8, in which the whole image is 2
// tan θ wide.
double ImageBeam(const StoredView& view, const glm::dvec3& p)
{
  return 2 * std::tan(view.HalfAngle) * -p.z;
}

std::array<glm::dvec3, 4> CornersAt(const StoredView& view, double depth)
{
  const double r = depth * std::tan(view.HalfAngle);
  return { glm::dvec3(-r, -r, -depth), glm::dvec3(r, -r, -depth), glm::dvec3(r, r, -depth),
    glm::dvec3(-r, r, -depth) };
}

double SplitAt(const StoredView& view, int i, int k)
{
  return view.Near * std::pow(view.Far / view.Near, double(i) / k);
}

Shown Show(const StoredView& view, const Part& part, const glm::dvec3& direction)
{
  glm::dvec3 t = part.Along - glm::dot(part.Along, direction) * direction;
  if (glm::length(t) < LeastLength)
  {
    const glm::dvec3 up(0, 1, 0);
    t = up - glm::dot(up, direction) * direction;
  }
  t = glm::normalize(t);
  const glm::dvec3 s = glm::cross(t, direction);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Shown shown{ {}, {}, glm::dvec2(infinity), glm::dvec2(-infinity) };
  for (const glm::dvec3& corner : part.Corners)
  {
    const glm::dvec2 p(glm::dot(corner, s), glm::dot(corner, t));
    shown.Corners.push_back(p);
    shown.Widths.push_back(ImageBeam(view, corner));
    shown.Low = glm::min(shown.Low, p);
    shown.High = glm::max(shown.High, p);
  }
  return shown;
}

// The storage M_s M_t of a map that a warp of that strength, (f' - n') / n', fits to the part
// (Equations 3 and 4).
double StorageOf(const Shown& shown, double strength)
{
  const double extent = shown.High.y - shown.Low.y;
  double low = std::numeric_limits<double>::infinity(), high = -low, s = 0, t = 0;
  for (std::size_t i = 0; i < shown.Corners.size(); ++i)
  {
    const double h = 1 + (extent > 0 ? strength * (shown.Corners[i].y - shown.Low.y) / extent : 0);
    low = std::min(low, shown.Corners[i].x / h);
    high = std::max(high, shown.Corners[i].x / h);
    s = std::max(s, h / shown.Widths[i]);
    t = std::max(t, h * h / ((1 + strength) * shown.Widths[i]));
  }
  return (high - low) * s * extent * t;
}

// The least storage of any strength, by golden section over its logarithm, in which there is one
// minimum.
double LeastStorage(const Shown& shown)
{
  const double ratio = 0.5 * (std::sqrt(5.0) - 1);
  const auto at = [&](double x) { return StorageOf(shown, std::exp(x)); };
  double low = std::log(1 / Strongest), high = std::log(Strongest);
  double a = high - ratio * (high - low), b = low + ratio * (high - low);
  double ofA = at(a), ofB = at(b);
  for (int i = 0; i < Steps; ++i)
  {
    if (ofA <= ofB)
    {
      high = b;
      b = a;
      ofB = ofA;
      a = high - ratio * (high - low);
      ofA = at(a);
    }
    else
    {
      low = a;
      a = b;
      ofA = ofB;
      b = low + ratio * (high - low);
      ofB = at(b);
    }
  }
  return std::min({ StorageOf(shown, 0), ofA, ofB });
}

double StorageOf(const StoredView& view, const Part& part, int warp, const glm::dvec3& direction)
{
  const Shown shown = Show(view, part, direction);
  if (warp == StorageScheme::Best)
  {
    return LeastStorage(shown);
  }
  if (warp == StorageScheme::None)
  {
    return StorageOf(shown, 0);
  }
  // A face's near edge lies that far along t on the light plane, in the mean.
  const double sine = glm::length(glm::cross(glm::normalize(part.Along), direction));
  const double nearest =
    part.IsFace ? 0.5 * (shown.Corners[0].y + shown.Corners[1].y) : part.Nearest;
  return StorageOf(shown,
    PerspectiveStrength({ PerspectiveChoice::Eta, 0 }, { part.IsFace ? 1.0 : sine, 1, 0 }, nearest,
      shown.High.y - shown.Low.y));
}

Part WholePart(const StoredView& view, double from, double to)
{
  Part part{ {}, { 0, 0, -1 }, from };
  for (const double depth : { from, to })
  {
    for (const glm::dvec3& corner : CornersAt(view, depth))
    {
      part.Corners.push_back(corner);
    }
  }
  return part;
}

// Whether a face has a map: the faces that a light beam meets first, if it goes with the view, else
// those that it leaves by, since the image beams that it meets are narrowest there (section 5.1).
bool IsUsed(const glm::dvec3& outward, const glm::dvec3& direction)
{
  const double side = direction.z <= 0 ? -1 : 1;
  return side * glm::dot(outward, direction) > LeastLength;
}

std::vector<Part> FaceParts(const StoredView& view, int partitions, const glm::dvec3& direction)
{
  std::vector<Part> parts;
  if (IsUsed({ 0, 0, 1 }, direction))
  {
    const auto corners = CornersAt(view, view.Near);
    parts.push_back({ { corners.begin(), corners.end() }, { 0, 0, -1 }, view.Near });
  }
  for (int side = 0; side < 4; ++side)
  {
    const auto unit = CornersAt(view, 1);
    const glm::dvec3 a = unit[side], b = unit[(side + 1) % 4];
    if (!IsUsed(glm::normalize(glm::cross(a, b)) *
            (glm::dot(glm::cross(a, b), unit[(side + 2) % 4]) < 0 ? 1.0 : -1.0),
          direction))
    {
      continue;
    }
    for (int i = 0; i < partitions; ++i)
    {
      const double from = SplitAt(view, i, partitions), to = SplitAt(view, i + 1, partitions);
      const auto plane = [&](const glm::dvec3& p) {
        const glm::dvec3 on = p - glm::dot(p, direction) * direction;
        return on / std::max(glm::length(on), LeastLength);
      };
      parts.push_back({ { from * a, from * b, to * a, to * b }, plane(a) + plane(b), from, true });
    }
  }
  return parts;
}
}

double LargestErrorAcross(const StoredView& view, double nearDistance)
{
  const double n = view.Near, f = view.Far;
  return std::isinf(nearDistance) ? f / n : f * nearDistance / (n * (nearDistance + f - n));
}

double LargestErrorAlong(const StoredView& view, double nearDistance)
{
  const double n = view.Near, f = view.Far, farDistance = nearDistance + f - n;
  const double worst = std::isinf(nearDistance)
    ? 1 / n
    : std::max(farDistance / (nearDistance * f), nearDistance / (n * farDistance));
  return (f - n) / (2 * std::tan(view.HalfAngle)) * worst;
}

double StorageOverhead(const StoredView& view, double nearDistance)
{
  return LargestErrorAcross(view, nearDistance) * LargestErrorAlong(view, nearDistance);
}

double StorageOptimal(const StoredView& view)
{
  return std::log(view.Far / view.Near) / (2 * std::tan(view.HalfAngle));
}

double StorageOverheadZPW(const StoredView& view, int k)
{
  return k * (std::pow(view.Far / view.Near, 1.0 / k) - 1) / (2 * std::tan(view.HalfAngle));
}

double StorageOverheadZP(const StoredView& view, int k)
{
  return std::pow(view.Far / view.Near, 1.0 / k) * StorageOverheadZPW(view, k);
}

double StorageBehindZP(const StoredView& view, int k)
{
  return k * std::pow(view.Far / view.Near, 2.0 / k);
}

double StorageBehindFPZPW(const StoredView& view, int k)
{
  const double quarter = std::atan(1.0);
  return 4 * StorageOverheadZPW({ view.Near, view.Far, quarter }, k) + 1;
}

double StorageTrendZP(const StoredView& view, int maps)
{
  return maps * std::pow(view.Far / view.Near, 2.0 / maps);
}

double StorageTrendFPZPW(const StoredView& view, int maps)
{
  return maps * std::pow(view.Far / view.Near, 4.0 / maps);
}

Storage StorageFactor(
  const StoredView& view, const StorageScheme& scheme, const glm::dvec3& direction)
{
  const glm::dvec3 unit = glm::normalize(direction);
  std::vector<Part> parts;
  if (scheme.Faces)
  {
    parts = FaceParts(view, scheme.Partitions, unit);
  }
  else
  {
    for (int i = 0; i < scheme.Partitions; ++i)
    {
      parts.push_back(WholePart(
        view, SplitAt(view, i, scheme.Partitions), SplitAt(view, i + 1, scheme.Partitions)));
    }
  }
  Storage storage;
  for (const Part& part : parts)
  {
    storage.Factor += StorageOf(view, part, scheme.Warp, unit);
    ++storage.Maps;
  }
  return storage;
}
}
