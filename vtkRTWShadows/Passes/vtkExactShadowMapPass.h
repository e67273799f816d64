// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkExactShadowMapPass
 * @brief   exact hard shadows: each pixel is tested against each triangle that could shadow it
 *
 * No shadow map: a grid on the light plane whose texels hold the view samples that fall on them (an
 * irregular z-buffer: G. Johnson, J. Lee, C. Burns, W. Mark, The Irregular Z-Buffer, 2005). A warp
 * evens out how many each texel holds; by itself that of vtkRectilinearShadowMapWarp, which takes
 * the least time. A triangle goes down a pyramid over the grid, whose squares know where their
 * samples lie on the light plane and how deep, to the few that it may shadow; the test itself knows
 * neither warp nor texels: it is the triangle's edges and plane, at the sample. Resolution is the
 * grid's, but for no more than a texel for each four pixels: it decides how fast the shadows are,
 * never what they are.
 *
 * Exact are the shadows that meshes cast on opaque receivers. In windows with 2 to 8 samples a
 * pixel each sample is tested, on the surface that it shows, and each surface takes the shadows of
 * its samples. Translucent receivers, which have no view samples, and windows with more samples
 * look up maps with the same warp, and so do receivers with view samples of the previous frame.
 * What only VTK's own mappers can draw (glyphs, imposters, cut-outs, clipped meshes) casts by a
 * map, too, on receivers whose other shadows are exact. Lines and points cast no shadow. Below
 * OpenGL 4.3 all shadows are those of a conventional map. Filter, FilterRadius, DepthTest and
 * Rasterization concern maps only.
 *
 * @sa vtkAdaptiveShadowMapPass vtkRectilinearShadowMapWarp vtkNonOrthogonalShadowMapWarp
 */
#ifndef vtkExactShadowMapPass_h
#define vtkExactShadowMapPass_h

#include "vtkAdaptiveShadowMapPass.h"

class vtkRectilinearShadowMapWarp;

class VTKRTWSHADOWS_EXPORT vtkExactShadowMapPass : public vtkAdaptiveShadowMapPass
{
public:
  static vtkExactShadowMapPass* New();
  vtkTypeMacro(vtkExactShadowMapPass, vtkAdaptiveShadowMapPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The warp that the pass begins with. It stays the same object when another warp is set.
   */
  vtkRectilinearShadowMapWarp* GetRectilinearWarp();

  ///@{
  /**
   * How many points of a pixel are tested: 1, 4 or 8, where rasterizers have them, on the surface
   * that the pixel shows; anything else is refused with an error. With more than one the edges of
   * shadows are antialiased: the mask is the share of points in the light. A window with several
   * samples a pixel has its own tested instead (vtkRenderWindow::SetMultiSamples()). Default: 1.
   */
  virtual void SetSamplesPerPixel(int samples);
  vtkGetMacro(SamplesPerPixel, int);
  ///@}

  ///@{
  /**
   * Kilobytes of GPU memory for the queue of triangles and grid squares that are still to be
   * tested. Where that is too little, the frame's mask is looked up in maps after all, which a
   * warning says once, and the next frame has twice as much, up to the greatest bound. Clamped to
   * 16 to 98304. Default: 24576.
   */
  virtual void SetMemoryBound(int kilobytes);
  vtkGetMacro(MemoryBound, int);
  ///@}

  ///@{
  /**
   * Whether each frame counts the lengths of lists, for GetLongestList() and the others, which it
   * waits for the GPU to do. Default: off.
   */
  virtual void SetCountLists(bool count);
  vtkGetMacro(CountLists, bool);
  vtkBooleanMacro(CountLists, bool);
  ///@}

  ///@{
  /**
   * How long the lists of view samples in the texels of a light's grid were in the last frame: the
   * longest; the length that 99 in a hundred of the texels with any samples don't exceed; and all
   * lengths together. 0 for a light that there isn't, and where CountLists is off.
   */
  int GetLongestList(int light);
  int GetListPercentile99(int light);
  int GetNumberOfListedSamples(int light);
  ///@}

protected:
  vtkExactShadowMapPass();
  ~vtkExactShadowMapPass() override;

  int SamplesPerPixel = 1;
  int MemoryBound = 24576;
  bool CountLists = false;

private:
  vtkExactShadowMapPass(const vtkExactShadowMapPass&) = delete;
  void operator=(const vtkExactShadowMapPass&) = delete;

  class Exact;
  Exact* Source; ///< that the pipeline owns
  vtkNew<vtkRectilinearShadowMapWarp> Rectilinear;
};

#endif
