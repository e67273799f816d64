// SPDX-License-Identifier: BSD-3-Clause
#include "rtwImages.h"

#include "rtwDenseLayers.h"
#include "rtwStateGuard.h"
#include "rtwView.h"
#include "rtwWarpTable.h"

#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <vector>

namespace rtw
{
namespace
{
constexpr float Nothing = 128.f / 255.f;

void DrawOpaque(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (prop->GetVisibility())
    {
      prop->RenderOpaqueGeometry(renderer);
    }
  }
}
}

vtkSmartPointer<vtkImageData> MaskRenderer::Render(vtkRenderer* renderer, const View& view)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  window->MakeCurrent();
  StateGuard guard(window);
  this->Colour.Allocate(Format::Bytes4, view.Width, view.Height);
  this->Depth.Allocate(Format::Depth, view.Width, view.Height);
  StateGuard::PrepareDepthDrawing(false);
  if (!this->Target.Bind(this->Depth, &this->Colour))
  {
    return nullptr;
  }
  Framebuffer::Clear(Nothing);
  guard.DrawWithVTK([&] { DrawOpaque(renderer); });
  std::vector<float> values(std::size_t(4) * view.Width * view.Height);
  this->Colour.ReadFloats(0, values.data());
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(view.Width, view.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < values.size() / 4; ++i)
  {
    bytes[i] = static_cast<unsigned char>(255 * values[4 * i] + 0.5f);
  }
  return image;
}

void MaskRenderer::Release(vtkOpenGLRenderWindow* window)
{
  if (this->Colour.GetId())
  {
    window->MakeCurrent();
    this->Colour.Release();
    this->Depth.Release();
    this->Target.Release();
  }
}

vtkSmartPointer<vtkImageData> ReadShadowMap(const DenseLayers& layers, int layer)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(layers.GetResolution(), layers.GetResolution(), 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  layers.GetDepths().ReadFloats(layer, static_cast<float*>(image->GetScalarPointer()));
  return image;
}

vtkSmartPointer<vtkImageData> ReadWarp(const WarpTable& table, int layer)
{
  const std::vector<float> all = table.Read();
  const std::size_t row = 2 * std::size_t(table.GetTexture().GetWidth());
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(table.GetCells() + 1, 2, 1);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (int axis = 0; axis < 2; ++axis)
  {
    const float* from = all.data() + row * (WarpTable::RowsPerLayer * layer + axis);
    for (int i = 0; i < table.GetCells(); ++i)
    {
      *values++ = from[2 * i];
    }
    *values++ = from[2 * table.GetCells() - 1];
  }
  return image;
}
}
