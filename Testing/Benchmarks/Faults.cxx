// SPDX-License-Identifier: BSD-3-Clause
#include "Faults.h"

#include "rtwAdaptiveTechnique.h"
#include "Warp/rtwWarpStage.h"

#include <vtkObjectFactory.h>
#include <vtkRectilinearShadowMapWarp.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRTWShadowMapPass.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <stdexcept>

namespace
{
// A warp whose function looks one cell too far; its inverse does not.
class ShiftedStage : public rtw::WarpStage
{
public:
  explicit ShiftedStage(std::unique_ptr<rtw::WarpStage> stage)
    : Whole(std::move(stage))
    , Function(this->Whole->GetShape().Function)
  {
    const std::string right = "rtwWarpEntry(row, cell)";
    const std::size_t at = this->Function.find(right);
    if (at == std::string::npos)
    {
      throw std::logic_error("the fault \"warp\" does not know this warp's shader any more");
    }
    this->Function.replace(at, right.size(), "rtwWarpEntry(row, min(cell + 1, rtwWarpSize.x - 1))");
  }

  rtw::WarpShape GetShape() const override
  {
    const rtw::WarpShape whole = this->Whole->GetShape();
    return { "rectilinear-shifted", this->Function.c_str(), whole.Bend, whole.Slope };
  }
  bool NeedsViewSamples() const override { return this->Whole->NeedsViewSamples(); }
  int GetCells() const override { return this->Whole->GetCells(); }
  bool Build() override { return this->Whole->Build(); }
  std::string GetLog() const override { return this->Whole->GetLog(); }
  int GetLightImageSize() const override { return this->Whole->GetLightImageSize(); }
  void Follow(const rtw::WarpFrame& frame, const rtw::LayerTable& table) override
  {
    this->Whole->Follow(frame, table);
  }
  bool IsSettled() const override { return this->Whole->IsSettled(); }
  void Run(const std::vector<rtw::LightFrame>& frames, const rtw::AnalysisInput& input,
    const rtw::LayerTable& table) override
  {
    this->Whole->Run(frames, input, table);
  }
  glm::dvec2 ReadGreatestDensity(int layer) const override
  {
    return this->Whole->ReadGreatestDensity(layer);
  }
  void Dispose(rtw::Disposal dispose) override { dispose(*this->Whole); }

private:
  std::unique_ptr<rtw::WarpStage> Whole;
  std::string Function;
};

class ShiftedWarp : public vtkRectilinearShadowMapWarp
{
public:
  static ShiftedWarp* New();
  vtkTypeMacro(ShiftedWarp, vtkRectilinearShadowMapWarp);
  std::unique_ptr<rtw::WarpStage> MakeStage() override
  {
    return std::make_unique<ShiftedStage>(this->Superclass::MakeStage());
  }
};
vtkStandardNewMacro(ShiftedWarp);

std::unique_ptr<rtw::Technique> MakeShifted(const rtw::TechniqueSettings& settings)
{
  vtkNew<vtkRTWShadowMapPass> pass;
  vtkNew<ShiftedWarp> warp;
  pass->SetWarp(warp);
  return std::make_unique<rtw::AdaptiveTechnique>(pass, settings);
}

std::unique_ptr<rtw::Technique> MakeBiased(const rtw::TechniqueSettings& settings)
{
  vtkNew<vtkRTWShadowMapPass> pass;
  pass->SetDepthTestToConstantBias();
  pass->SetConstantBias(0.02);
  return std::make_unique<rtw::AdaptiveTechnique>(pass, settings);
}

// Takes 30 % more time than it needs.
class SlowTechnique : public rtw::AdaptiveTechnique
{
public:
  using AdaptiveTechnique::AdaptiveTechnique;

  void Install(vtkRenderer* renderer) override
  {
    this->Renderer = renderer;
    AdaptiveTechnique::Install(renderer);
  }

  void PrepareFrame() override { this->Start = Clock::now(); }

  void FinishFrame() override
  {
    this->Renderer->GetRenderWindow()->WaitForCompletion();
    const Clock::duration taken = Clock::now() - this->Start;
    while (Clock::now() < this->Start + taken + taken * 3 / 10)
    {
    }
  }

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point Start;
  vtkRenderer* Renderer = nullptr;
};

std::unique_ptr<rtw::Technique> MakeSlow(const rtw::TechniqueSettings& settings)
{
  vtkNew<vtkRTWShadowMapPass> pass;
  return std::make_unique<SlowTechnique>(pass, settings);
}

struct Entry
{
  const char* Name;
  const char* Description;
  std::unique_ptr<rtw::Technique> (*Make)(const rtw::TechniqueSettings& settings);
};

const Entry ENTRIES[] = {
  { "warp", "the warp looks one cell too far", MakeShifted },
  { "bias", "a constant depth bias that is ten times too large", MakeBiased },
  { "slow", "a frame takes 30 % longer than it needs", MakeSlow },
};

const Entry& Find(const std::string& name)
{
  return *std::find_if(std::begin(ENTRIES), std::end(ENTRIES) - 1,
    [&](const Entry& entry) { return name == entry.Name; });
}
}

std::vector<std::string> FaultNames()
{
  std::vector<std::string> names;
  for (const Entry& entry : ENTRIES)
  {
    names.push_back(entry.Name);
  }
  return names;
}

std::string FaultDescription(const std::string& fault)
{
  return Find(fault).Description;
}

std::unique_ptr<rtw::Technique> MakeFaulty(
  const std::string& fault, const rtw::TechniqueSettings& settings)
{
  return Find(fault).Make(settings);
}
