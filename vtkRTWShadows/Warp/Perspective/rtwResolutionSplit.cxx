// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/Perspective/rtwResolutionSplit.h"

#include "Frame/rtwFramedView.h"
#include "Light/rtwMinimalFrustum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtw
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Extreme = 16; // a ratio beyond which maps would be but lines
constexpr int Shortest = 8;    // side, in texels, unless the square's is shorter
// Share of a step that a ratio has to change by; half a step would do without hysteresis.
constexpr double Hold = 0.75;
constexpr double ClearlyBetter = 0.98;
// Pixels by which edges are misplaced besides, whatever the ratio.
constexpr double Unseen = 50;
constexpr std::int64_t Lasting = 8; // frames that a viewer is remembered for

double DepthOf(const View& viewed, const glm::dvec3& p)
{
  return glm::dot(p - viewed.Eye, viewed.Forward);
}

// The inverse of the projection of a view that reaches from one depth to another.
glm::dmat4 ClipToWorldBetween(const View& seen, double from, double to)
{
  const View viewed = AtEye(seen);
  glm::dmat4 toClip = viewed.ViewToClip;
  const double extent = to - from;
  toClip[0][2] = toClip[1][2] = 0;
  toClip[2][2] = viewed.Parallel ? -2 / extent : -(to + from) / extent;
  toClip[3][2] = viewed.Parallel ? -(to + from) / extent : -2 * to * from / extent;
  return viewed.ViewToWorld * glm::inverse(toClip);
}

// The corners of a convex part that the light reaches, and, since a spot's rim may cut it, points
// on that rim.
std::vector<glm::dvec3> InReach(const LightFrame& frame, const std::vector<glm::dvec3>& corners)
{
  if (frame.Light.Kind == LightKind::Directional)
  {
    return corners;
  }
  const Rectangle& b = frame.Bounds;
  const glm::dvec4 planes[] = { { 1, 0, 0, -b.Low.x }, { -1, 0, 0, b.High.x },
    { 0, 1, 0, -b.Low.y }, { 0, -1, 0, b.High.y }, { 0, 0, 0, 1 } };
  const auto distance = [&](const glm::dvec3& p, const glm::dvec4& plane) {
    const glm::dvec4 h = frame.WorldToLight * glm::dvec4(p, 1);
    return glm::dot(plane, h) - (plane.w == 1 ? frame.NearestDistance : 0);
  };
  std::vector<glm::dvec3> points = corners;
  for (const glm::dvec4& plane : planes)
  {
    for (const glm::dvec3& from : corners)
    {
      for (const glm::dvec3& to : corners)
      {
        const double a = distance(from, plane), c = distance(to, plane);
        if (a < 0 && c > 0)
        {
          points.push_back(from + a / (a - c) * (to - from));
        }
      }
    }
  }
  const auto isBeyond = [&](const glm::dvec3& p) {
    return std::any_of(std::begin(planes), std::end(planes),
      [&](const glm::dvec4& plane) { return distance(p, plane) < -1e-9 * frame.FarthestDistance; });
  };
  points.erase(std::remove_if(points.begin(), points.end(), isBeyond), points.end());
  return points;
}

// A point of a view on the light plane, and the width of a beam of the image there.
struct Beam
{
  glm::dvec2 Place;
  double Width;
};

std::vector<Beam> BeamsAt(
  const LightFrame& frame, const View& viewed, const std::vector<glm::dvec3>& points)
{
  std::vector<Beam> beams;
  for (const glm::dvec3& p : points)
  {
    const double depth = viewed.Parallel ? 1 : DepthOf(viewed, p);
    const bool isSpot = frame.Light.Kind == LightKind::Spot;
    const double away = isSpot ? glm::dot(p - frame.Light.Position, frame.Light.Direction) : 1;
    if (depth > 0)
    {
      beams.push_back({ glm::dvec2(frame.Project(p)), depth / away });
    }
  }
  return beams;
}
}

glm::dvec2 SplitResolution(double texels, double ms, double mt)
{
  return { std::sqrt(texels * ms / mt), std::sqrt(texels * mt / ms) };
}

glm::ivec2 SplitTexels(int side, double ratio, int most)
{
  if (!(ratio > 0) || ratio == 1 || side >= most)
  {
    return glm::ivec2(side);
  }
  const double texels = double(side) * side;
  const glm::dvec2 split = SplitResolution(texels, std::clamp(ratio, 1 / Extreme, Extreme), 1);
  const int longer = split.x > split.y ? 0 : 1;
  const double longest = std::min(double(most), texels / std::min(side, Shortest));
  glm::ivec2 size;
  size[longer] = static_cast<int>(std::min(std::round(split[longer]), longest));
  size[1 - longer] = static_cast<int>(texels / size[longer]);
  return size;
}

glm::dvec2 LargestErrors(const PerspectiveChoice& choice, const LightFrame& frame,
  const View& viewed, const std::vector<glm::dvec3>& corners)
{
  const std::vector<glm::dvec3> points = InReach(frame, corners);
  const std::vector<Beam> beams = BeamsAt(frame, viewed, points);
  glm::dvec2 t(Infinity, -Infinity);
  double nearest = Infinity;
  for (const Beam& beam : beams)
  {
    t = { std::min(t.x, beam.Place.y), std::max(t.y, beam.Place.y) };
  }
  for (const glm::dvec3& p : points)
  {
    nearest = std::min(nearest, std::max(DepthOf(viewed, p), 0.0));
  }
  if (!(t.y > t.x))
  {
    return glm::dvec2(0);
  }
  const ViewOnLight view = LookAtView(frame, viewed.Eye, viewed.Forward, viewed.Parallel);
  const double strength = PerspectiveStrength(choice, view, nearest, t.y - t.x);
  glm::dvec2 s(Infinity, -Infinity), errors(0);
  for (const Beam& beam : beams)
  {
    const double h = 1 + strength * (beam.Place.y - t.x) / (t.y - t.x);
    const double column = view.EyeS + (beam.Place.x - view.EyeS) / h;
    s = { std::min(s.x, column), std::max(s.y, column) };
    errors = glm::max(errors, glm::dvec2(h / beam.Width, h * h / ((1 + strength) * beam.Width)));
  }
  return errors * glm::dvec2(s.y - s.x, t.y - t.x);
}

double CriticalRatio(const PerspectiveChoice& choice, const SplitScene& scene)
{
  const View& viewed = scene.Viewed;
  glm::dvec2 range(Infinity, -Infinity);
  for (const glm::dvec3& p :
    VisibleCorners(viewed.ViewToWorld * viewed.ClipToView, scene.Low, scene.High))
  {
    range = { std::min(range.x, DepthOf(viewed, p)), std::max(range.y, DepthOf(viewed, p)) };
  }
  if (!scene.Focused || !(range.x > 0 || viewed.Parallel) || !(range.y > range.x))
  {
    return 1;
  }
  double sum = 0;
  int count = 0;
  for (const LightFrame& frame : scene.Frames)
  {
    const int depths = frame.Parts / frame.Faces, k = frame.Layer % frame.Parts / frame.Faces;
    const auto border = [&](int i) {
      const double share = double(i) / depths;
      return viewed.Parallel ? range.x + share * (range.y - range.x)
                             : range.x * std::pow(range.y / range.x, share);
    };
    const glm::dvec2 errors = LargestErrors(choice, frame, viewed,
      VisibleCorners(ClipToWorldBetween(viewed, border(k), border(k + 1)), scene.Low, scene.High));
    if (errors.x > 0 && errors.y > 0)
    {
      sum += std::log(errors.x / errors.y);
      ++count;
    }
  }
  const double ratio = count > 0 ? std::exp(sum / count) : 1;
  return std::isfinite(ratio) ? std::clamp(ratio, 1 / Extreme, Extreme) : 1;
}

int LeastErrorStep(const std::vector<std::vector<float>>& errors, const std::optional<int>& inForce)
{
  if (errors.empty())
  {
    return inForce.value_or(0);
  }
  std::vector<double> sums;
  for (int step = -SplitSteps; step <= SplitSteps; ++step)
  {
    // How much longer and wider a texel of a map with that ratio is than one of the square map, in
    // the mean.
    const double longer = std::exp2(0.5 * step / SteadyRatio::StepsAnOctave);
    double sum = Unseen * 0.5 * (longer + 1 / longer);
    for (const std::vector<float>& each : errors)
    {
      sum += each[step + SplitSteps];
    }
    sums.push_back(sum);
  }
  const auto best = std::min_element(sums.begin(), sums.end());
  const int step = static_cast<int>(best - sums.begin()) - SplitSteps;
  const bool stays = inForce && *best >= ClearlyBetter * sums[*inForce + SplitSteps];
  return stays ? *inForce : step;
}

double SteadyRatio::Choose(const void* viewer, double wanted)
{
  ++this->Time;
  this->Wishes[viewer] = { StepsAnOctave * std::log2(wanted), this->Time };
  double sum = 0;
  for (auto wish = this->Wishes.begin(); wish != this->Wishes.end();)
  {
    if (this->Time - wish->second.Time >= Lasting)
    {
      wish = this->Wishes.erase(wish);
      continue;
    }
    sum += wish->second.Steps;
    ++wish;
  }
  const double mean = sum / double(this->Wishes.size());
  if (!this->Held || std::abs(mean - this->Step) > Hold)
  {
    this->Step = static_cast<int>(std::lround(mean));
  }
  this->Held = true;
  return std::exp2(double(this->Step) / StepsAnOctave);
}

void SteadyRatio::Forget()
{
  *this = {};
}
}
