// SPDX-License-Identifier: BSD-3-Clause
#include "Light/rtwTurnStage.h"

#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "GL/rtwReadback.h"
#include "GL/rtwTexture.h"
#include "Light/rtwLightUniforms.h"
#include "Light/rtwLitSample.h"
#include "Light/rtwShadowEdge.h"
#include "Light/rtwTurnErrors.h"
#include "Light/rtwTurnSamples.h"

#include <algorithm>
#include <cmath>

namespace rtw
{
namespace
{
// Enough to tell turns apart by a few percent; rtwTurnErrors.glsl adds so many up.
constexpr int Side = 128;
constexpr int Slots = Side * Side;
constexpr std::size_t BytesOfHeader = 16, BytesOfSample = 32, BytesOfEdge = 48;
// How often edges are looked for along an axis from one listed sample to the next.
constexpr int LooksForEdges = 4;
constexpr int MaskUnit = 1;

void SetRectangles(
  const Program& program, const char* uniform, const std::vector<Rectangle>& rectangles)
{
  constexpr double Farthest = 1e30; // stands for infinity: a float holds it well
  std::vector<float> values;
  for (const Rectangle& r : rectangles)
  {
    for (const double value : { r.Low.x, r.Low.y, r.High.x, r.High.y })
    {
      values.push_back(float(std::clamp(value, -Farthest, Farthest)));
    }
  }
  glUniform4fv(program.Location(uniform), static_cast<GLsizei>(rectangles.size()), values.data());
}
}

bool TurnStage::Build()
{
  const std::string definitions = "#define RTW_TURNS " + std::to_string(MostTurns) + "\n";
  return this->Listing.Build({ { GL_COMPUTE_SHADER,
           { rtwViewSampleAccess, rtwLitSample, rtwShadowEdge, rtwTurnSamples } } }) &&
    this->Comparing.Build(
      { { GL_COMPUTE_SHADER, { definitions.c_str(), rtwShadowEdge, rtwTurnErrors } } });
}

std::string TurnStage::GetLog() const
{
  return this->Listing.GetLog() + this->Comparing.GetLog();
}

void TurnStage::Start(
  const std::vector<TurnedLight>& lights, const TurnInput& input, Readback& answer)
{
  std::size_t turns = 0;
  for (const TurnedLight& light : lights)
  {
    turns += light.By.size();
  }
  this->Errors.Reserve(turns * sizeof(float));
  int first = 0;
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    this->List(lights[i].Frame, static_cast<int>(i), input);
    this->Compare(lights[i], first, input);
    first += static_cast<int>(lights[i].By.size());
  }
  answer.Start(this->Errors, turns * sizeof(float));
}

void TurnStage::List(const LightFrame& frame, int light, const TurnInput& input)
{
  const int width = input.Samples.GetWidth(), height = input.Samples.GetHeight();
  // Samples a side are no more than there are slots a side, nor than the analysis itself takes.
  int step = std::max(input.Stride, 1);
  while ((width / step) * (height / step) > Slots)
  {
    ++step;
  }
  this->Samples.Reserve(BytesOfHeader + Slots * (BytesOfSample + BytesOfEdge));
  const unsigned int none[2] = { 0, 0 };
  this->Samples.Write(0, none, sizeof(none));
  this->Samples.BindStorage(0);
  this->Listing.Use();
  input.Samples.Bind(this->Listing);
  BindLight(this->Listing, frame, input.Samples.GetView(), input.Stride);
  if (input.Mask)
  {
    input.Mask->Bind(MaskUnit);
  }
  this->Listing.Set("rtwMask", MaskUnit);
  this->Listing.Set("rtwHasMask", input.Mask ? 1 : 0);
  this->Listing.Set("rtwLight", light);
  this->Listing.Set("rtwStep", step);
  this->Listing.Set("rtwFineStep", std::max(step / LooksForEdges, 1));
  this->Listing.Set("rtwSlots", Slots);
  Dispatch(Groups((width + step - 1) / step, 16), Groups((height + step - 1) / step, 16));
}

void TurnStage::BindList(const Program& program) const
{
  this->Samples.BindStorage(0);
  program.Set("rtwSlots", Slots);
}

void TurnStage::Compare(const TurnedLight& light, int first, const TurnInput& input)
{
  std::vector<float> turns;
  for (const double by : light.By)
  {
    turns.push_back(float(std::cos(by)));
    turns.push_back(float(std::sin(by)));
  }
  this->Comparing.Use();
  this->BindList(this->Comparing);
  this->Errors.BindStorage(1);
  glUniform2fv(
    this->Comparing.Location("rtwTurns"), static_cast<GLsizei>(light.By.size()), turns.data());
  SetRectangles(this->Comparing, "rtwKept", light.Kept);
  SetRectangles(this->Comparing, "rtwBounds", light.Bounds);
  this->Comparing.Set("rtwFirstError", first);
  this->Comparing.Set("rtwAdapts", input.Adapts ? 1 : 0);
  this->Comparing.Set("rtwTexels", float(input.Texels));
  this->Comparing.Set("rtwAreas", input.Areas ? 1 : 0);
  Dispatch(static_cast<int>(light.By.size()));
}

void TurnStage::Dispose(Disposal dispose)
{
  dispose(this->Listing, this->Comparing, this->Samples, this->Errors);
}
}
