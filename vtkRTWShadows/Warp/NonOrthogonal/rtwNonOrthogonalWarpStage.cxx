// SPDX-License-Identifier: BSD-3-Clause
#include "Warp/NonOrthogonal/rtwNonOrthogonalWarpStage.h"

#include "Frame/rtwSamplePlace.h"
#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Importance/rtwAnalysisInput.h"
#include "Importance/rtwImportance.h"
#include "Importance/rtwImportanceStage.h"
#include "Importance/rtwUserFunction.h"
#include "Layers/rtwLayerBlocks.h"
#include "Layers/rtwLayerInterval.h"
#include "Layers/rtwLayerTable.h"
#include "Layers/rtwSampleBlocks.h"
#include "Layers/rtwSampleOfLayer.h"
#include "Layers/rtwVisitSamples.h"
#include "Layers/rtwWarpFocus.h"
#include "Light/rtwBackwardSample.h"
#include "Light/rtwLightUniforms.h"
#include "Light/rtwLitSample.h"
#include "Warp/NonOrthogonal/rtwBendNonOrthogonal.h"
#include "Warp/NonOrthogonal/rtwBuildGrid.h"
#include "Warp/NonOrthogonal/rtwCoarseGrid.h"
#include "Warp/NonOrthogonal/rtwCollectGrid.h"
#include "Warp/NonOrthogonal/rtwGridCentres.h"
#include "Warp/NonOrthogonal/rtwGridPyramid.h"
#include "Warp/NonOrthogonal/rtwGridTiles.h"
#include "Warp/NonOrthogonal/rtwNonOrthogonalWarp.h"
#include "Warp/NonOrthogonal/rtwSlopeNonOrthogonal.h"
#include "Warp/NonOrthogonal/rtwSmoothGrid.h"
#include "Warp/NonOrthogonal/rtwSmoothingCandidates.h"
#include "Warp/NonOrthogonal/rtwSmoothingCost.h"
#include "Warp/NonOrthogonal/rtwSmoothingRadius.h"
#include "Warp/NonOrthogonal/rtwWarpNonOrthogonal.h"
#include "Warp/Rectilinear/rtwRectilinearWarp.h"

#include <cmath>
#include <cstdint>
#include <utility>

namespace rtw
{
namespace
{
constexpr int CountUnit = 1024;
constexpr int Passes = 3; // windows that lines are averaged in, one after another
constexpr int Unit = 9;   // of the texture that a program reads besides the table

// Four cells at a time are read.
int LineLengthOf(int cells)
{
  return (cells + 3) / 4 * 4;
}

void BindTexels(const Program& program, const char* name, const TexelBuffer& values)
{
  values.Bind(Unit);
  program.Set(name, Unit);
}

bool BuildCollecting(Program& program, int functions)
{
  const std::string definitions =
    "const int PROFILES = 1;\nconst int FUNCTIONS = " + std::to_string(functions) +
    ";\nconst float COUNT_UNIT = " + std::to_string(CountUnit) + ".0;\n";
  return program.Build({ { GL_COMPUTE_SHADER,
    { definitions.c_str(), rtwWarpFocus, rtwWarpNonOrthogonal, rtwLayerInterval,
      rtwViewSampleAccess, rtwLitSample, rtwSampleOfLayer, rtwUserFunction, "return 1.0;\n}\n",
      rtwImportance, rtwSamplePlace, rtwBackwardSample, rtwSampleBlocks, rtwVisitSamples,
      rtwCollectGrid } } });
}
}

NonOrthogonalWarpStage::NonOrthogonalWarpStage(std::function<NonOrthogonalSettings()> settings)
  : Settings(std::move(settings))
{
}

WarpShape NonOrthogonalWarpStage::GetShape() const
{
  return { "non-orthogonal", rtwWarpNonOrthogonal, rtwBendNonOrthogonal, rtwSlopeNonOrthogonal,
    WarpKind::Grid };
}

bool NonOrthogonalWarpStage::Build()
{
  return BuildCollecting(this->Counting, SampleCount) &&
    BuildCollecting(this->CollectingDemand, SqrtDemand) &&
    this->SmoothingFirst.Build(
      { { GL_COMPUTE_SHADER, { "#define FIRST_PASS\n", rtwSmoothGrid } } }) &&
    this->Smoothing.Build({ { GL_COMPUTE_SHADER, { rtwSmoothGrid } } }) && this->BuildChoosing() &&
    this->Building.Build({ { GL_COMPUTE_SHADER,
      { "#define GROUP 32\n", rtwWarpFocus, rtwWarpNonOrthogonal, rtwBuildGrid } } }) &&
    this->Inverting.Build(
      { { GL_COMPUTE_SHADER, { rtwWarpFocus, rtwWarpNonOrthogonal, rtwGridCentres } } }) &&
    this->Levelling.Build({ { GL_COMPUTE_SHADER,
      { rtwWarpFocus, rtwWarpNonOrthogonal, rtwBendNonOrthogonal, rtwGridPyramid } } }) &&
    this->Tiling.Build({ { GL_COMPUTE_SHADER,
      { rtwWarpFocus, rtwWarpNonOrthogonal, rtwBendNonOrthogonal, rtwGridTiles } } });
}

bool NonOrthogonalWarpStage::BuildChoosing()
{
  const auto define = [](const char* name, const std::string& value) {
    return "#define " + std::string(name) + " " + value + "\n";
  };
  const std::string definitions = define("COARSE_CELLS", std::to_string(SmoothingChoice::Cells)) +
    define("SMOOTHING_CANDIDATES", std::to_string(SmoothingChoice::Candidates)) +
    define("LEAST_SMOOTHING", std::to_string(SmoothingChoice::Least)) +
    define("SHEAR", std::to_string(SmoothingChoice::Shear)) +
    define("CHEAPEST_RANGE", std::to_string(SmoothingChoice::Range));
  const auto build = [&](Program& program, const char* code) {
    return program.Build(
      { { GL_COMPUTE_SHADER, { definitions.c_str(), rtwSmoothingCandidates, code } } });
  };
  return build(this->Coarsening, rtwCoarseGrid) && build(this->Costing, rtwSmoothingCost) &&
    build(this->Choosing, rtwSmoothingRadius);
}

std::string NonOrthogonalWarpStage::GetLog() const
{
  return this->Coarsening.GetLog() + this->Costing.GetLog() + this->Choosing.GetLog() +
    this->Counting.GetLog() + this->CollectingDemand.GetLog() + this->SmoothingFirst.GetLog() +
    this->Smoothing.GetLog() + this->Building.GetLog() + this->Inverting.GetLog() +
    this->Levelling.GetLog() + this->Tiling.GetLog();
}

void NonOrthogonalWarpStage::Run(
  const std::vector<LightFrame>& frames, const AnalysisInput& input, const LayerTable& table)
{
  this->Used = this->Settings();
  this->Cells = table.GetCells();
  this->LineLength = LineLengthOf(this->Cells);
  const std::size_t cells = std::size_t(this->Cells) * this->LineLength;
  this->Layers = static_cast<int>(frames.size());
  this->Collected.AllocateIntegers(4, frames.size() * cells); // two sums each, of both axes
  this->Collected.Clear();
  this->Smoothed.Allocate(4, cells / 2); // two times
  this->Totals.Reserve(frames.size() * 2 * this->Cells * sizeof(float));
  this->Report.Reserve(frames.size() * 2 * sizeof(float));
  this->Report.Clear();
  this->Coarse.Allocate(4, SmoothingChoice::Cells * SmoothingChoice::Cells / 4);
  this->Costs.Reserve(SmoothingChoice::Candidates * sizeof(float));
  this->Radius.Reserve(2 * sizeof(float));
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    const int layer = static_cast<int>(i);
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Collect(frames[i], layer, axis, input, table);
      this->ChooseRadius(layer, axis, table, input.Straight);
      this->Smooth(layer, axis, table);
      this->BuildFunctions(layer, axis, table);
    }
    this->Invert(layer, table);
    this->BuildPyramid(layer, table);
    this->BuildTiles(layer, table);
  }
}

void NonOrthogonalWarpStage::Collect(
  const LightFrame& frame, int layer, int axis, const AnalysisInput& input, const LayerTable& table)
{
  const Program& program = this->Collecting(this->Used.Demand);
  program.Use();
  this->Collected.BindStorage(0);
  input.Samples.Bind(program);
  table.Bind(program);
  BindLight(program, frame, input.Samples.GetView(), input.Stride);
  program.Set("rtwLayer", layer);
  program.Set("rtwAxis", axis);
  program.Set("rtwFirst", this->FirstOf(layer, axis));
  program.Set("rtwLineLength", this->LineLength);
  input.Blocks.Dispatch(program, input.Samples, input.Stride, layer);
}

float NonOrthogonalWarpStage::Unit() const
{
  return this->Used.Demand ? 1.f : 1.f / CountUnit;
}

int NonOrthogonalWarpStage::FirstOf(int layer, int axis) const
{
  return (2 * layer + axis) * this->Cells * this->LineLength;
}

// Chooses the radius of the windows that lines are averaged in.
void NonOrthogonalWarpStage::ChooseRadius(
  int layer, int axis, const LayerTable& table, double straight)
{
  if (!this->Used.Automatic)
  {
    const double sigma = this->Used.Smoothing * table.GetCells();
    // Windows of 2 r + 1 lines have a variance of about ((2 r + 1)² - 1) / 12 each.
    const auto radius = static_cast<float>(0.5 * (std::sqrt(1 + 12 * sigma * sigma / Passes) - 1));
    this->Radius.Write(0, &radius, sizeof(radius));
    return;
  }
  this->Coarsening.Use();
  table.Bind(this->Coarsening);
  this->Collected.BindStorage(0);
  this->Coarse.BindStorage(1);
  this->Coarsening.Set("rtwUnit", this->Unit());
  this->Coarsening.Set("rtwFirst", this->FirstOf(layer, axis));
  this->Coarsening.Set("rtwLineLength", this->LineLength);
  Dispatch(SmoothingChoice::Cells);
  this->Costing.Use();
  BindTexels(this->Costing, "rtwCoarse", this->Coarse);
  this->Costs.BindStorage(2);
  this->Costing.Set("rtwIsUnderRoot", this->Used.Demand ? 1 : 0);
  this->Costing.Set("rtwFloor", static_cast<float>(this->Used.Floor));
  this->Costing.Set(
    "rtwBendCost", static_cast<float>(SmoothingChoice::BendCost(straight, table.GetResolution())));
  Dispatch(SmoothingChoice::Candidates);
  this->Choosing.Use();
  table.Bind(this->Choosing);
  this->Radius.BindStorage(3);
  this->Choosing.Set("rtwPasses", Passes);
  Dispatch(1);
}

void NonOrthogonalWarpStage::Smooth(int layer, int axis, const LayerTable& table)
{
  this->Smoothed.BindStorage(1);
  this->Radius.BindStorage(2);
  for (int pass = 0; pass < Passes; ++pass)
  {
    const Program& program = pass == 0 ? this->SmoothingFirst : this->Smoothing;
    program.Use();
    table.Bind(program);
    BindTexels(program, pass == 0 ? "rtwCollected" : "rtwSmoothed",
      pass == 0 ? this->Collected : this->Smoothed);
    program.Set("rtwUnit", this->Unit());
    program.Set("rtwPass", pass);
    program.Set("rtwFirst", this->FirstOf(layer, axis));
    Dispatch(Groups(this->LineLength / 4, 16));
  }
}

void NonOrthogonalWarpStage::BuildFunctions(int layer, int axis, const LayerTable& table)
{
  this->Building.Use();
  table.Bind(this->Building);
  table.GetGrid().BindStorage(1);
  this->Report.BindStorage(2);
  this->Totals.BindStorage(4);
  BindTexels(this->Building, "rtwSmoothed", this->Smoothed);
  this->Building.Set("rtwFirstSmoothed", (Passes - 1) % 2 * this->Cells * this->LineLength / 4);
  this->Building.Set("rtwLayer", layer);
  this->Building.Set("rtwAxis", axis);
  this->Building.Set("rtwIsUnderRoot", this->Used.Demand ? 1 : 0);
  this->Building.Set("rtwSigma", static_cast<float>(this->Used.Sigma));
  this->Building.Set("rtwFloor", static_cast<float>(this->Used.Floor));
  this->Building.Set("rtwLeast", static_cast<float>(LeastShare));
  Dispatch(table.GetCells());
}

void NonOrthogonalWarpStage::Invert(int layer, const LayerTable& table)
{
  this->Inverting.Use();
  table.Bind(this->Inverting);
  table.GetGrid().BindStorage(1);
  this->Inverting.Set("rtwLayer", layer);
  Dispatch(table.GetResolution());
}

void NonOrthogonalWarpStage::BuildPyramid(int layer, const LayerTable& table)
{
  this->Levelling.Use();
  table.Bind(this->Levelling);
  table.GetBends().BindStorage(2);
  this->Levelling.Set("rtwLayer", layer);
  for (int level = 0; level < table.GetBendLevels(); ++level)
  {
    const int groups = Groups(table.GetPyramidSide(level), 8);
    this->Levelling.Set("rtwLevel", level);
    Dispatch(groups, groups, 2);
  }
}

void NonOrthogonalWarpStage::BuildTiles(int layer, const LayerTable& table)
{
  this->Tiling.Use();
  table.Bind(this->Tiling);
  table.GetBends().BindStorage(2);
  this->Tiling.Set("rtwLayer", layer);
  for (int level = 0; level < table.GetTileLevels(); ++level)
  {
    const int groups = Groups(table.GetTileSide(level), 8);
    this->Tiling.Set("rtwLevel", LayerTable::LeastTileLevel + level);
    Dispatch(groups, groups);
  }
}

glm::dvec2 NonOrthogonalWarpStage::ReadGreatestDensity(int layer) const
{
  glm::dvec2 density(1);
  if (layer >= 0 && layer < this->Layers)
  {
    float steepest[2];
    this->Report.Read(layer * sizeof(steepest), steepest, sizeof(steepest));
    density = { steepest[0], steepest[1] };
  }
  return density;
}

std::vector<float> NonOrthogonalWarpStage::ReadImportance(int layer, const LayerTable& table) const
{
  std::vector<float> values;
  if (layer < 0 || layer >= this->Layers)
  {
    return values;
  }
  const std::size_t lines = std::size_t(2) * this->Cells; // of both axes
  std::vector<std::uint32_t> collected(lines * this->LineLength * 2);
  this->Collected.Read(this->FirstOf(layer, 0) / 2, collected.data(), collected.size() / 4);
  std::vector<float> totals(lines);
  const std::size_t bytes = lines * sizeof(float);
  this->Totals.Read(layer * bytes, totals.data(), bytes);
  const std::vector<float> grid = table.ReadGrid(layer);
  values.reserve(2 * lines * this->Cells);
  for (std::size_t line = 0; line < lines; ++line)
  {
    for (int cell = 0; cell < this->Cells; ++cell)
    {
      const std::uint32_t* parts = &collected[2 * (line * this->LineLength + cell)];
      const double sum = this->Unit() * (parts[0] + 4294967296.0 * parts[1]);
      const float* ends = &grid[2 * (line * this->Cells + cell)];
      values.push_back(static_cast<float>(this->Used.Demand ? std::sqrt(sum) : sum));
      values.push_back(totals[line] * (ends[1] - ends[0]));
    }
  }
  return values;
}

void NonOrthogonalWarpStage::Dispose(Disposal dispose)
{
  dispose(this->Counting, this->CollectingDemand, this->SmoothingFirst, this->Smoothing,
    this->Coarsening, this->Costing, this->Choosing, this->Building, this->Inverting,
    this->Levelling, this->Tiling, this->Collected, this->Smoothed, this->Coarse, this->Costs,
    this->Radius, this->Report, this->Totals);
  this->Layers = 0;
}
}
