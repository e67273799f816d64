// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/rtwFocus.h"

#include "Frame/rtwViewSampler.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Layers/rtwFocusBounds.h"
#include "Layers/rtwFocusBoxes.h"
#include "Layers/rtwFocusWrite.h"
#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwOrdered.h"
#include "Layers/rtwPlacedOnPlane.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwLightUniforms.h"
#include "Light/rtwLitSample.h"

#include <cstdint>
#include <cstring>

namespace rtw
{
namespace
{
constexpr float Margin = 1e-4f; // a share of the focus' extent, for rounding

// The unsigned integer of rtwOrdered.glsl, which are in the order of the floats.
std::uint32_t Ordered(double value)
{
  const auto x = static_cast<float>(value);
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return bits & 0x80000000u ? ~bits : bits | 0x80000000u;
}

void SetWholeBounds(const Program& program, const LightFrame& frame)
{
  const Rectangle& b = frame.Bounds;
  glUniform4f(program.Location("rtwWholeBounds"), float(b.Low.x), float(b.Low.y), float(b.High.x),
    float(b.High.y));
}
}

bool FocusStage::Build()
{
  return this->Samples.Build(rtwPlacedOnPlane) &&
    this->BoxAdding.Build({ { GL_COMPUTE_SHADER,
      { rtwWarpFocus, rtwLayerInterval, rtwLitSample, rtwOrdered, rtwFocusBounds,
        rtwFocusBoxes } } }) &&
    this->Writing.Build({ { GL_COMPUTE_SHADER, { rtwWarpFocus, rtwOrdered, rtwFocusWrite } } });
}

std::string FocusStage::GetLog() const
{
  return this->Samples.GetLog() + this->BoxAdding.GetLog() + this->Writing.GetLog();
}

// Adds to the bounds of each layer the part of boxes in its depths; their corners are in view
// coordinates.
void FocusStage::AddBoxes(const std::vector<LightFrame>& frames,
  const std::vector<glm::dvec3>& corners, const View& view, const FilterReach& filter,
  const LayerTable& table)
{
  std::vector<glm::vec4> inView;
  for (const glm::dvec3& corner : corners)
  {
    inView.emplace_back(view.WorldToView * glm::dvec4(corner, 1));
  }
  const int edges = 12 * static_cast<int>(corners.size()) / 8;
  this->Boxes.Assign(inView);
  this->BoxAdding.Use();
  table.Bind(this->BoxAdding);
  this->Bounds.BindStorage(0);
  this->Boxes.BindStorage(1);
  this->BoxAdding.Set("rtwNumberOfEdges", edges);
  this->BoxAdding.Set("rtwFilterWidth", float(filter.World));
  for (const LightFrame& frame : frames)
  {
    BindLight(this->BoxAdding, frame, view, 1);
    SetWholeBounds(this->BoxAdding, frame);
    this->BoxAdding.Set("rtwLayer", frame.Layer);
    Dispatch(Groups(edges, 64));
  }
}

void FocusStage::Bound(
  const std::vector<LightFrame>& lights, const BoundedSamples& input, int parts)
{
  this->Samples.Start(input, static_cast<int>(lights.size()), parts);
  for (std::size_t light = 0; light < lights.size(); ++light)
  {
    this->Samples.Bound(input, lights[light], static_cast<int>(light), lights[light].Bounds);
  }
}

void FocusStage::Reduce(const std::vector<LightFrame>& frames, const std::vector<Rectangle>& also,
  const std::vector<glm::dvec3>& boxes, const BoundedSamples& input, const FilterReach& filter)
{
  std::vector<std::uint32_t> start;
  for (std::size_t layer = 0; layer < frames.size(); ++layer)
  {
    const Rectangle& r = also[layer];
    const bool any = r.Low.x <= r.High.x && frames[layer].Parts == 1;
    for (int k = 0; k < 2; ++k)
    {
      start.push_back(any ? Ordered(r.Low[k]) : 0xffffffffu);
    }
    for (int k = 0; k < 2; ++k)
    {
      start.push_back(any ? Ordered(r.High[k]) : 0u);
    }
    start.insert(start.end(), { 0xffffffffu, 0xffffffffu, 0u, 0u });
  }
  this->Bounds.Assign(start);
  this->Blocks.Start(static_cast<int>(frames.size()), input.Samples, input.Stride);
  const int parts = frames.front().Parts;
  for (std::size_t layer = 0; layer < frames.size(); layer += parts)
  {
    this->Samples.Unite(input, frames[layer], frames[layer].Number(), parts, frames[layer].Bounds,
      this->Bounds, &this->Blocks);
  }
  if (parts > 1 && !boxes.empty())
  {
    this->AddBoxes(frames, boxes, input.Samples.GetView(), filter, input.Table);
  }
  this->Writing.Use();
  input.Table.Bind(this->Writing);
  this->Bounds.BindStorage(0);
  input.Table.GetValues().BindStorage(1);
  for (std::size_t layer = 0; layer < frames.size(); ++layer)
  {
    SetWholeBounds(this->Writing, frames[layer]);
    this->Writing.Set("rtwParts", frames[layer].Parts);
    this->Writing.Set("rtwLayer", static_cast<int>(layer));
    this->Writing.Set("rtwMargin", Margin + float(filter.Share));
    Dispatch(1);
  }
}

void FocusStage::Dispose(Disposal dispose)
{
  dispose(this->Samples, this->BoxAdding, this->Boxes, this->Writing, this->Bounds, this->Blocks);
}
}
