// SPDX-License-Identifier: BSD-3-Clause
// Where the coordinates of a frame begin: of the view, of each light, and how its plane is turned.
#include "Passes/rtwShadowPipeline.h"

#include "Frame/rtwFramedView.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rtw
{
LightFrame ShadowPipeline::MakeFrame(
  const FrameScene& scene, const ShadowLight& light, double turn) const
{
  const auto extent = [&](const glm::dvec3& direction) {
    glm::dvec2 along = this->Store.Extent(direction);
    for (const glm::dvec3& corner : scene.PropCorners)
    {
      along.x = std::min(along.x, glm::dot(corner, direction));
      along.y = std::max(along.y, glm::dot(corner, direction));
    }
    return along;
  };
  return MakeLightFrame(light, extent, this->Viewed.Origin, turn);
}

// What its bounds and the view have in common lies between two distances.
View ShadowPipeline::FrameView(const View& view, const FrameScene& scene)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!view.IsUsable() || !scene.HasBounds)
  {
    return view;
  }
  glm::dvec2 range(infinity, -infinity);
  for (const glm::dvec3& p :
    VisibleCorners(view.ViewToWorld * view.ClipToView, scene.Low, scene.High))
  {
    const double distance = glm::dot(p - view.Eye, view.Forward);
    range = { std::min(range.x, distance), std::max(range.y, distance) };
  }
  // What only mappers can draw may be larger than its bounds are.
  const double share = scene.Props.empty() ? 1e-3 : 0.5;
  const double width = 2 / view.ViewToClip[0][0] * (view.Parallel ? 1 : range.y);
  const double margin = share *
    std::max(range.y - range.x, std::min(std::abs(width), glm::length(scene.High - scene.Low)));
  return Framed(view, { range.x - margin, range.y + margin });
}

void ShadowPipeline::MakeFrames(const FrameScene& scene, const std::vector<ShadowLight>& lights)
{
  this->Frames.clear();
  this->LayerFrames.clear();
  this->SceneSize = glm::length(scene.High - scene.Low);
  this->DrawnTurns = this->Turns.GetTurns();
  const int parts = this->CountParts(lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    this->Frames.push_back(this->MakeFrame(scene, lights[i], this->DrawnTurns[i]));
    this->Frames.back().Faces = this->CountFaces(parts);
    for (int part = 0; part < parts; ++part)
    {
      LightFrame frame = this->Frames.back();
      frame.Parts = parts;
      frame.Layer = this->CountLayers();
      this->LayerFrames.push_back(frame);
    }
  }
}

std::vector<double> ShadowPipeline::FindMinimalFrusta(
  const FrameScene& scene, const std::vector<ShadowLight>& lights, Turning turn)
{
  this->Minimal.assign(lights.size(), {});
  if (turn != Turning::MinimalFrustum && turn != Turning::LeastArea)
  {
    return {};
  }
  const std::vector<glm::dvec3> corners =
    VisibleCorners(this->Viewed.ViewToWorld * this->Viewed.ClipToView, scene.Low, scene.High);
  std::vector<double> turns;
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const auto minimal = MinimalFrustum(this->MakeFrame(scene, lights[i], 0), corners);
    turns.push_back(minimal ? minimal->Turn : 0);
    if (minimal)
    {
      // A spot's origin on its plane isn't everywhere the same one, turned.
      this->Minimal[i] =
        BoundsOnLightPlane(this->MakeFrame(scene, lights[i], minimal->Turn), corners);
    }
  }
  return turns;
}

Turning ShadowPipeline::TurningOf(const PipelineOptions& options) const
{
  if (this->OwnDrawing && this->Warp->LiesAlongView())
  {
    return Turning::AlongView;
  }
  if (this->OwnDrawing && options.FocusOnView && options.Turn == Turning::MinimalFrustum)
  {
    return Turning::LeastArea;
  }
  return this->OwnDrawing || options.Turn != Turning::Automatic ? options.Turn : Turning::Off;
}
}
