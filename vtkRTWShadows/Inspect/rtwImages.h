// SPDX-License-Identifier: BSD-3-Clause
// What lies on the GPU, as images.
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

/// A layer of bytes, as they are.
vtkSmartPointer<vtkImageData> ReadMask(const Texture& mask, int layer);
vtkSmartPointer<vtkImageData> ReadShadowMap(const DenseLayers& layers, int layer);
vtkSmartPointer<vtkImageData> ReadWarp(const LayerTable& table, int layer, WarpKind kind);
/// Two floats a pixel, as they are.
vtkSmartPointer<vtkImageData> ReadAliasing(const Texture& error);
/// Of two rows of two floats a cell or, of a grid, two slices of as many rows as cells; null for
/// none.
vtkSmartPointer<vtkImageData> MakeImportanceImage(const std::vector<float>& values, bool isGrid);
}

#endif
