// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/rtwLayerTable.h"

#include "GL/rtwOpenGL.h"
#include "GL/rtwProgram.h"

#include <algorithm>

namespace rtw
{
const char* LayerTable::DefinitionOf(TableAccess access)
{
  switch (access)
  {
    case TableAccess::Uniforms:
      return "#define RTW_TABLE_IN_UNIFORMS\n";
    case TableAccess::Storage:
      return "#define RTW_TABLE_IN_STORAGE\n";
    default:
      return "";
  }
}

void LayerTable::Allocate(int cells, int resolution, int layers, int warpedLayers, bool hasGrid)
{
  const int gridLayers = hasGrid ? warpedLayers : 0;
  this->WarpedLayers = warpedLayers;
  this->GridLayers = gridLayers;
  this->Cells = cells;
  this->Resolution = resolution;
  this->MapSize = glm::ivec2(resolution);
  this->BendLevels = 1;
  while (1 << this->BendLevels <= cells)
  {
    ++this->BendLevels;
  }
  this->Rows = RowsPerLayer * layers;
  // Uniforms of the last layer reach behind it.
  this->Table.Allocate(
    2, std::size_t(this->Rows) * this->GetRowLength() + UniformBytes / (2 * sizeof(float)));
  if (gridLayers == 0)
  {
    this->Bends.Allocate(4, std::size_t(cells) * 2 * layers * this->BendLevels);
    return;
  }
  this->Bends.Allocate(4,
    std::size_t(gridLayers) *
      (2 * (this->GetPyramidPlaces().back() + this->GetTilePlaces().back())));
  this->Grid.Allocate(2, gridLayers * this->GetGridLength());
}

int LayerTable::GetTileSide(int level) const
{
  const int texels = 1 << (LeastTileLevel + level);
  return (this->Resolution + texels - 1) / texels;
}

int LayerTable::GetTileLevels() const
{
  int levels = 1;
  while (this->GetTileSide(levels - 1) > 1)
  {
    ++levels;
  }
  return levels;
}

std::vector<int> LayerTable::GetPyramidPlaces() const
{
  std::vector<int> places{ 0 };
  for (int level = 0; level < this->BendLevels; ++level)
  {
    places.push_back(places.back() + this->GetPyramidSide(level) * this->GetPyramidSide(level));
  }
  return places;
}

std::vector<int> LayerTable::GetTilePlaces() const
{
  std::vector<int> places{ 0 };
  for (int level = 0; level < this->GetTileLevels(); ++level)
  {
    places.push_back(places.back() + this->GetTileSide(level) * this->GetTileSide(level));
  }
  return places;
}

std::size_t LayerTable::GetGridLength() const
{
  const std::size_t cells = this->Cells, resolution = this->Resolution;
  return 2 * cells * cells + resolution * resolution;
}

int LayerTable::GetRowLength() const
{
  const int length = std::max(this->Cells + 2, this->Resolution);
  return length + length % 2; // rtwWarpFocus.glsl computes the same
}

void LayerTable::WriteRow(int row, int first, const std::vector<float>& values)
{
  this->Table.Write(
    std::size_t(row) * this->GetRowLength() + first, values.data(), values.size() / 2);
}

void LayerTable::WriteFocus(int layer, const Rectangle& focus)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    this->WriteRow(RowsPerLayer * layer + axis, this->Cells,
      { float(focus.Low[axis]), float(1 / std::max(focus.High[axis] - focus.Low[axis], 1e-30)) });
  }
}

void LayerTable::CopyFocus(const LayerTable& from, int layers, int behind)
{
  for (int layer = 0; layer < layers; ++layer)
  {
    for (int row = RowsPerLayer * layer; row < RowsPerLayer * layer + 2; ++row)
    {
      const std::size_t to = std::size_t(row) + std::size_t(RowsPerLayer) * behind;
      this->Table.CopyElement(to * this->GetRowLength() + this->Cells, from.Table,
        std::size_t(row) * from.GetRowLength() + from.Cells);
    }
  }
}

void LayerTable::WriteIdentity(int layer)
{
  std::vector<float> forward, inverse;
  for (int i = 0; i < this->Cells; ++i)
  {
    forward.push_back(float(i) / float(this->Cells));
    forward.push_back(float(i + 1) / float(this->Cells));
  }
  for (int i = 0; i < this->Resolution; ++i)
  {
    inverse.push_back((float(i) + 0.5f) / float(this->Resolution));
    inverse.push_back((float(i) + 1.5f) / float(this->Resolution));
  }
  for (int row = 0; row < RowsPerLayer; ++row)
  {
    this->WriteRow(RowsPerLayer * layer + row, 0, row < 2 ? forward : inverse);
  }
}

void LayerTable::Bind(const Program& program) const
{
  this->Table.BindStorage(StorageBinding);
  this->Table.Bind(Unit);
  this->Bends.Bind(BendUnit);
  program.Set("rtwWarpTable", Unit);
  program.Set("rtwWarpGrid", GridUnit);
  program.Set("rtwWarpedLayers", this->WarpedLayers);
  if (this->GridLayers > 0)
  {
    this->Grid.Bind(GridUnit);
    const std::vector<int> levels = this->GetPyramidPlaces(), tiles = this->GetTilePlaces();
    glUniform1iv(program.Location("rtwLevelPlaces"), int(levels.size()), levels.data());
    glUniform1iv(program.Location("rtwTilePlaces"), int(tiles.size()), tiles.data());
    program.Set("rtwTileLevels", this->GetTileLevels());
  }
  glUniform2i(program.Location("rtwWarpSize"), this->Cells, this->Resolution);
  glUniform2i(program.Location("rtwMapSize"), this->MapSize.x, this->MapSize.y);
  program.Set("rtwBendLevels", this->BendLevels);
  program.SetBlock("WarpForward", UniformBinding);
  program.SetBlock("WarpInverse", UniformBinding + 1);
}

// Bytes of a block of uniforms: two rows of the table.
std::size_t LayerTable::GetBlockBytes() const
{
  return RowsPerLayer / 2 * this->GetRowLength() * 2 * sizeof(float);
}

void LayerTable::BindLayer(int layer) const
{
  if (this->FitsUniforms())
  {
    for (unsigned int block = 0; block < 2; ++block)
    {
      this->Table.BindUniforms(UniformBinding + block,
        (2 * std::size_t(layer) + block) * this->GetBlockBytes(), UniformBytes);
    }
  }
}

Rectangle LayerTable::ReadFocus(int layer) const
{
  const std::vector<float> table = this->Read();
  const std::size_t row = 2 * std::size_t(this->GetRowLength());
  Rectangle focus;
  for (int axis = 0; axis < 2; ++axis)
  {
    const float* values = &table[(RowsPerLayer * layer + axis) * row + 2 * this->Cells];
    focus.Low[axis] = values[0];
    focus.High[axis] = focus.Low[axis] + 1 / double(values[1]);
  }
  return focus;
}

glm::dvec2 LayerTable::ReadInterval(int layer) const
{
  const std::vector<float> table = this->Read();
  const float* values =
    &table[2 * (std::size_t(RowsPerLayer) * layer * this->GetRowLength() + this->Cells + 1)];
  return { values[0], values[1] };
}

void LayerTable::WriteInterval(int layer, const glm::dvec2& interval, double blendStart)
{
  const int row = RowsPerLayer * layer;
  this->WriteRow(row, this->Cells + 1, { float(interval.x), float(interval.y) });
  this->WriteRow(row + 1, this->Cells + 1, { float(blendStart), 0.f });
}

std::vector<float> LayerTable::Read() const
{
  const std::size_t elements = std::size_t(this->Rows) * this->GetRowLength();
  std::vector<float> values(2 * elements);
  this->Table.Read(values.data(), elements);
  return values;
}

std::vector<float> LayerTable::ReadGrid(int layer) const
{
  const std::size_t first = layer * this->GetGridLength();
  const std::size_t functions = 2 * std::size_t(this->Cells) * this->Cells;
  std::vector<float> values(2 * (first + functions));
  this->Grid.Read(values.data(), first + functions);
  return { values.begin() + 2 * first, values.end() };
}

void LayerTable::Dispose(Disposal dispose)
{
  dispose(this->Table, this->Bends, this->Grid);
}
}
