// SPDX-License-Identifier: BSD-3-Clause
// What lies on the GPU, as images.
#ifndef rtwImages_h
#define rtwImages_h

#include "rtwFramebuffer.h"
#include "rtwTexture.h"

#include "vtkSmartPointer.h"

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace rtw
{
class DenseLayers;
class WarpTable;
struct View;

/// Draws the opaque props of a renderer once more, in the phase that their shaders are set to, and reads what they write.
class MaskRenderer
{
public:
  vtkSmartPointer<vtkImageData> Render(vtkRenderer* renderer, const View& view);
  void Release(vtkOpenGLRenderWindow* window);

private:
  Texture Colour, Depth;
  Framebuffer Target;
};

vtkSmartPointer<vtkImageData> ReadShadowMap(const DenseLayers& layers, int layer);
vtkSmartPointer<vtkImageData> ReadWarp(const WarpTable& table, int layer);
}

#endif
