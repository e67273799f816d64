// SPDX-License-Identifier: BSD-3-Clause
#include "Inspect/rtwImages.h"

#include "GL/rtwTexture.h"
#include "Layers/rtwDenseLayers.h"
#include "Layers/rtwLayerTable.h"
#include "Warp/rtwWarpStage.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace rtw
{
vtkSmartPointer<vtkImageData> ReadMask(const Texture& mask, int layer)
{
  std::vector<float> values(std::size_t(mask.GetWidth()) * mask.GetHeight());
  mask.ReadFloats(layer, values.data());
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(mask.GetWidth(), mask.GetHeight(), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    bytes[i] = static_cast<unsigned char>(255 * values[i] + 0.5f);
  }
  return image;
}

vtkSmartPointer<vtkImageData> ReadShadowMap(const DenseLayers& layers, int layer)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(layers.GetSize().x, layers.GetSize().y, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  layers.GetDepths().ReadFloats(layer, static_cast<float*>(image->GetScalarPointer()));
  return image;
}

namespace
{
vtkSmartPointer<vtkImageData> ReadGrid(const LayerTable& table, int layer)
{
  const std::size_t cells = table.GetCells();
  const std::vector<float> grid = table.ReadGrid(layer);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(table.GetCells() + 1, table.GetCells(), 2);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (std::size_t line = 0; line < 2 * cells; ++line)
  {
    const float* from = &grid[2 * cells * line];
    for (std::size_t i = 0; i < cells; ++i)
    {
      *values++ = from[2 * i];
    }
    *values++ = from[2 * cells - 1];
  }
  return image;
}

// The 3 x 3 matrix of a perspective warp, from its four numbers in the table
// (rtwWarpPerspective.glsl).
vtkSmartPointer<vtkImageData> MakeHomography(float low, float high, float strength, float eye)
{
  const float scale = 1 / (high - low);
  const float rows[] = { scale, (eye - low) * strength * scale, -low * scale, 0, 1 + strength, 0, 0,
    strength, 1 };
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 3, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::copy(std::begin(rows), std::end(rows), static_cast<float*>(image->GetScalarPointer()));
  return image;
}
}

vtkSmartPointer<vtkImageData> ReadWarp(const LayerTable& table, int layer, WarpKind kind)
{
  if (layer < table.GetGridLayers())
  {
    return ReadGrid(table, layer);
  }
  std::vector<float> all = table.Read();
  const std::size_t row = 2 * std::size_t(table.GetRowLength());
  if (kind == WarpKind::Projective)
  {
    const float* const s = all.data() + row * LayerTable::RowsPerLayer * layer;
    return MakeHomography(s[0], s[1], s[row], s[row + 1]);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(table.GetCells() + 1, 2, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (int axis = 0; axis < 2; ++axis)
  {
    float* from = all.data() + row * (LayerTable::RowsPerLayer * layer + axis);
    if (table.GetCells() == 1)
    {
      // A function of one cell is no warp: nothing reads it, and so nothing writes it.
      from[0] = 0;
      from[1] = 1;
    }
    for (int i = 0; i < table.GetCells(); ++i)
    {
      *values++ = from[2 * i];
    }
    *values++ = from[2 * table.GetCells() - 1];
  }
  return image;
}

vtkSmartPointer<vtkImageData> ReadAliasing(const Texture& error)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(error.GetWidth(), error.GetHeight(), 1);
  image->AllocateScalars(VTK_FLOAT, 2);
  error.ReadFloats(0, static_cast<float*>(image->GetScalarPointer()));
  return image;
}

vtkSmartPointer<vtkImageData> MakeImportanceImage(const std::vector<float>& values, bool isGrid)
{
  if (values.empty())
  {
    return nullptr;
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int cells = static_cast<int>(values.size() / 4); // of both axes
  const int side = static_cast<int>(std::lround(std::sqrt(double(cells))));
  image->SetDimensions(isGrid ? side : cells, isGrid ? side : 2, isGrid ? 2 : 1);
  image->AllocateScalars(VTK_FLOAT, 2);
  std::copy(values.begin(), values.end(), static_cast<float*>(image->GetScalarPointer()));
  return image;
}
}
