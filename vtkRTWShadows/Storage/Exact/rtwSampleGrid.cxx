// SPDX-License-Identifier: BSD-3-Clause
#include "Storage/Exact/rtwSampleGrid.h"

#include "Frame/rtwPointOfPixel.h"
#include "Frame/rtwSampleOfPixel.h"
#include "Frame/rtwViewSampleAccess.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"
#include "Layers/rtwWarpFocus.h"
#include "Storage/Exact/rtwBoundGrid.h"
#include "Storage/Exact/rtwCountSamples.h"
#include "Storage/Exact/rtwExactState.h"
#include "Storage/Exact/rtwItemOfDispatch.h"
#include "Storage/Exact/rtwListSamples.h"
#include "Storage/Exact/rtwSampleGridAccess.h"
#include "Storage/Exact/rtwSampleNormal.h"
#include "Storage/Exact/rtwSumGrid.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rtw
{
namespace
{
constexpr std::size_t NodeBytes = 32;
constexpr std::size_t NodeCountAt = 6; // the place of GridNode::count, in 4-byte words
constexpr double LeastSamples = 4;     // least samples of a texel, in the mean
constexpr int GroupsInRow = 1024;

// The error of coordinates after meshes, matrices and view samples became floats, as shares of the
// scene's diagonal and of the distance from the view's origin: 2^-23 is 1.2e-7.
constexpr double AlongLight = 2e-6;
constexpr double AcrossLight = 2.5e-7;
constexpr double AcrossLightOfDistance = 5e-7;

// The patterns of 4 and 8 samples that rasterizers have.
constexpr float Four[] = { -2, -6, 6, -2, -6, 2, 2, 6 };
constexpr float Eight[] = { 1, -3, -1, 3, 5, 1, -3, -5, -5, 5, -7, -1, 3, 7, 7, -7 };

void DispatchItems(std::size_t items)
{
  const int groups = Groups(static_cast<int>(items), 64);
  Dispatch(std::min(groups, GroupsInRow), Groups(groups, GroupsInRow));
}
}

std::vector<glm::vec2> PointsOfPixel(const ViewSampler& samples, int points)
{
  if (samples.GetSamplesAPixel() > 1 || points == 1)
  {
    return samples.GetOffsets();
  }
  std::vector<glm::vec2> offsets;
  for (int i = 0; i < points; ++i)
  {
    const float* const sixteenths = (points == 4 ? Four : Eight) + 2 * i;
    offsets.push_back(glm::vec2(sixteenths[0], sixteenths[1]) / 16.f);
  }
  return offsets;
}

void SetPoints(const Program& program, const std::vector<glm::vec2>& points)
{
  program.Set("rtwSamplesAPixel", static_cast<int>(points.size()));
  glUniform2fv(
    program.Location("rtwOffsets"), static_cast<GLsizei>(points.size()), &points.front().x);
}

const char* PointCode(bool many)
{
  return many ? rtwSampleOfPixel : rtwPointOfPixel;
}

// Floats are no coarser at a distance w than 1e-7 w, as they would be from the spot itself, while
// the reference is at least half of any w.
double ExactReference(const LightFrame& frame, const glm::dvec3& origin)
{
  if (frame.Light.Kind != LightKind::Spot)
  {
    return 0;
  }
  const double seen = glm::dot(origin - frame.Light.Position, frame.Light.Direction);
  return std::clamp(seen, 0.5 * frame.FarthestDistance, frame.FarthestDistance);
}

glm::dmat4 WorldToExactPlane(const LightFrame& frame, const glm::dvec3& origin)
{
  const double reference = ExactReference(frame, origin);
  const glm::dvec3& along = frame.Light.Direction;
  const glm::dvec4 depth = reference > 0
    ? reference * glm::dvec4(along, -glm::dot(frame.Light.Position, along) - reference)
    : glm::dvec4(along, -glm::dot(origin, along));
  return glm::row(frame.WorldToLight, 2, depth);
}

bool SampleGrid::Build(const WarpShape& warp, TableAccess access, bool many)
{
  if (this->Warp != warp.Name || this->Access != access || this->Many != many)
  {
    this->Counting.Release();
    this->Many = many;
    this->Warp = warp.Name;
    this->Access = access;
  }
  return this->Counting.Build({ { GL_COMPUTE_SHADER,
           { LayerTable::DefinitionOf(access), rtwWarpFocus, warp.Function, rtwViewSampleAccess,
             PointCode(many), rtwSampleGridAccess, rtwExactState, rtwSampleNormal,
             rtwCountSamples } } }) &&
    this->Summing.Build(
      { { GL_COMPUTE_SHADER, { rtwSampleGridAccess, rtwItemOfDispatch, rtwSumGrid } } }) &&
    this->Listing.Build({ { GL_COMPUTE_SHADER,
      { rtwSampleGridAccess, rtwItemOfDispatch, rtwExactState, rtwListSamples } } }) &&
    this->Bounding.Build(
      { { GL_COMPUTE_SHADER, { rtwSampleGridAccess, rtwItemOfDispatch, rtwBoundGrid } } });
}

std::string SampleGrid::GetLog() const
{
  return this->Counting.GetLog() + this->Summing.GetLog() + this->Listing.GetLog() +
    this->Bounding.GetLog();
}

void SampleGrid::Allocate(const GridInput& input)
{
  const std::size_t pixels = std::size_t(input.Samples.GetWidth()) * input.Samples.GetHeight();
  this->Points = PointsOfPixel(input.Samples, input.SamplesAPixel);
  const std::size_t samples = pixels * this->Points.size();
  // More texels than that take more time than they save.
  const int most =
    std::min(1 << FinestTopLevel, int(std::ceil(std::sqrt(double(samples) / LeastSamples))));
  this->Side = std::min(input.Table.GetResolution(), most);
  this->TopLevel = 0;
  while (1 << this->TopLevel < this->Side)
  {
    ++this->TopLevel;
  }
  this->NumberOfSamples = static_cast<int>(samples);
  this->Found.Reserve(16 * samples);
  this->Places.Reserve(8 * samples);
  this->Listed.Reserve(16 * samples);
  this->Owners.Reserve(4 * samples);
  this->States.Reserve(4 * pixels);
  this->Nodes.Reserve(NodeBytes * (4 * this->NodesOfLevel(0) - 1) / 3);
  this->Nodes.Clear();
}

void SampleGrid::Bind(const Program& program) const
{
  this->Nodes.BindStorage(NodeBinding);
  program.Set("rtwGridSide", this->Side);
  program.Set("rtwTopLevel", this->TopLevel);
}

void SampleGrid::BindList(unsigned int listed, unsigned int owners) const
{
  this->Listed.BindStorage(listed);
  this->Owners.BindStorage(owners);
}

void SampleGrid::Count(const GridInput& input)
{
  const View& view = input.Samples.GetView();
  const glm::mat4 toPlane(WorldToExactPlane(input.Frame, view.Origin) * view.ViewToWorld);
  const LightFrame& frame = input.Frame;
  this->Counting.Use();
  input.Samples.Bind(this->Counting);
  input.Table.Bind(this->Counting);
  input.Table.BindLayer(input.Layer);
  this->Bind(this->Counting);
  this->Found.BindStorage(0);
  this->Places.BindStorage(1);
  this->BindStates();
  this->Counting.Set("rtwLayer", input.Layer);
  this->Counting.SetMatrix("rtwViewToPlane", glm::value_ptr(toPlane));
  glUniform4f(this->Counting.Location("rtwCone"), float(frame.ConeCentre.x),
    float(frame.ConeCentre.y), float(frame.ConeTangent), 0.f);
  this->Counting.Set("rtwTolerance", float(AlongLight * input.SceneSize),
    float(AcrossLight * input.SceneSize), float(AcrossLightOfDistance));
  this->Counting.Set("rtwReference", float(ExactReference(frame, view.Origin)));
  SetPoints(this->Counting, this->Points);
  Dispatch(Groups(input.Samples.GetWidth(), 8), Groups(input.Samples.GetHeight(), 8));
}

void SampleGrid::List()
{
  this->Summing.Use();
  this->Bind(this->Summing);
  for (int level = 1; level <= this->TopLevel; ++level)
  {
    this->Summing.Set("rtwLevel", level);
    this->Summing.Set("rtwDown", 0);
    DispatchItems(this->NodesOfLevel(level));
  }
  this->Summing.Set("rtwDown", 1);
  for (int level = this->TopLevel; level >= 0; --level)
  {
    this->Summing.Set("rtwLevel", level);
    DispatchItems(this->NodesOfLevel(level));
  }
  this->Listing.Use();
  this->Bind(this->Listing);
  this->Found.BindStorage(0);
  this->Places.BindStorage(1);
  this->BindList(4, 5);
  this->Listing.Set("rtwNumberOfSamples", this->NumberOfSamples);
  this->Listing.Set("rtwSamplesAPixel", static_cast<int>(this->Points.size()));
  DispatchItems(this->NumberOfSamples);
}

void SampleGrid::Bound()
{
  this->Bounding.Use();
  this->Bind(this->Bounding);
  this->Listed.BindStorage(4);
  for (int level = 0; level <= this->TopLevel; ++level)
  {
    this->Bounding.Set("rtwLevel", level);
    DispatchItems(this->NodesOfLevel(level));
  }
}

void SampleGrid::Fill(const GridInput& input)
{
  this->Allocate(input);
  this->Count(input);
  this->List();
  this->Bound();
}

std::vector<unsigned int> SampleGrid::ReadCounts(int resolution) const
{
  std::vector<std::uint32_t> nodes(NodeBytes / 4 * this->NodesOfLevel(0));
  this->Nodes.Read(0, nodes.data(), 4 * nodes.size());
  const auto spread = [](unsigned int x) {
    unsigned int bits = 0;
    for (unsigned int k = 0; k < FinestTopLevel; ++k)
    {
      bits |= (x >> k & 1) << (2 * k);
    }
    return bits;
  };
  std::vector<unsigned int> counts;
  for (int y = 0; y < resolution; ++y)
  {
    for (int x = 0; x < resolution; ++x)
    {
      counts.push_back(
        nodes[NodeBytes / 4 * std::size_t(spread(x) | spread(y) << 1) + NodeCountAt]);
    }
  }
  return counts;
}

ListLengths SampleGrid::ReadLengths() const
{
  ListLengths lengths;
  if (this->Nodes.GetId() == 0)
  {
    return lengths;
  }
  std::vector<unsigned int> counts = this->ReadCounts(1 << this->TopLevel);
  counts.erase(std::remove(counts.begin(), counts.end(), 0u), counts.end());
  for (const unsigned int count : counts)
  {
    lengths.Samples += count;
  }
  lengths.Texels = static_cast<unsigned int>(counts.size());
  if (!counts.empty())
  {
    const auto most = counts.begin() + static_cast<std::ptrdiff_t>(99 * counts.size() / 100);
    std::nth_element(counts.begin(), most, counts.end());
    lengths.Percentile99 = *most;
    lengths.Longest = *std::max_element(counts.begin(), counts.end());
  }
  return lengths;
}

std::array<Program*, 4> SampleGrid::Programs()
{
  return { &this->Counting, &this->Summing, &this->Listing, &this->Bounding };
}

std::array<Buffer*, 6> SampleGrid::Buffers()
{
  return { &this->Found, &this->Places, &this->States, &this->Nodes, &this->Listed, &this->Owners };
}

std::array<const Buffer*, 6> SampleGrid::Buffers() const
{
  return { &this->Found, &this->Places, &this->States, &this->Nodes, &this->Listed, &this->Owners };
}

std::size_t SampleGrid::GetMemory() const
{
  std::size_t memory = 0;
  for (const Buffer* buffer : this->Buffers())
  {
    memory += buffer->GetSize();
  }
  return memory;
}

void SampleGrid::Dispose(Disposal dispose)
{
  dispose(this->Programs(), this->Buffers());
}
}
