// SPDX-License-Identifier: BSD-3-Clause
// Textures and tables on the GPU as vtkImageData.
#ifndef rtwImages_h
#define rtwImages_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;

namespace rtw
{
class DenseLayers;
class Texture;
class LayerTable;
enum class WarpKind;

/// A layer of the shadow mask, in bytes as they are.
vtkSmartPointer<vtkImageData> ReadMask(const Texture& mask, int layer);
vtkSmartPointer<vtkImageData> ReadShadowMap(const DenseLayers& layers, int layer);
vtkSmartPointer<vtkImageData> ReadWarp(const LayerTable& table, int layer, WarpKind kind);
/// The aliasing error, two floats a pixel as they are.
vtkSmartPointer<vtkImageData> ReadAliasing(const Texture& error);
/// An image of importance: two rows of two floats a cell or, for a grid, two slices of as many rows
/// as cells; null where there are no values.
vtkSmartPointer<vtkImageData> MakeImportanceImage(const std::vector<float>& values, bool isGrid);
}

#endif
