// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNonOrthogonalShadowMapWarp
 * @brief   each row and each column of a shadow map warped by a function of its own
 *
 * Non-orthogonal texture warping: T. Milet, J. Navrátil, P. Zemčík, An Improved Non-Orthogonal
 * Texture Warping for Better Shadow Rendering, 2015. Rows of the light plane are warped by what
 * view samples ask for in each, then columns of the result. Unlike in the paper functions change
 * continuously from line to line, and the square root of demand is the default weight.
 *
 * @sa vtkNoTWShadowMapPass vtkRectilinearShadowMapWarp
 */
#ifndef vtkNonOrthogonalShadowMapWarp_h
#define vtkNonOrthogonalShadowMapWarp_h

#include "vtkRTWShadowsModule.h" // for the export macro
#include "vtkShadowMapWarp.h"

class VTKRTWSHADOWS_EXPORT vtkNonOrthogonalShadowMapWarp : public vtkShadowMapWarp
{
public:
  static vtkNonOrthogonalShadowMapWarp* New();
  vtkTypeMacro(vtkNonOrthogonalShadowMapWarp, vtkShadowMapWarp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What the view samples in a cell of the grid add up to, which the map's texels are given out by.
   */
  enum SampleWeights
  {
    COUNT = 0, ///< view samples, so that each texel gets as many (Milet et al. 2015, section 3)
    SQRT_DEMAND = 1 ///< the square root of the sum of one over their footprints: the least error
  };

  ///@{
  /**
   * What cells of the grid count: one of SampleWeights; any other value is refused with an error.
   * Default: SQRT_DEMAND.
   */
  virtual void SetWeights(int weights);
  vtkGetMacro(Weights, int);
  void SetWeightsToCount() { this->SetWeights(COUNT); }
  void SetWeightsToSqrtDemand() { this->SetWeights(SQRT_DEMAND); }
  ///@}

  ///@{
  /**
   * Cells a side of the grid, whatever the map's resolution. Clamped to 64 to 2048.
   * Default: 512.
   */
  vtkSetClampMacro(ImportanceResolution, int, 64, 2048);
  vtkGetMacro(ImportanceResolution, int);
  ///@}

  ///@{
  /**
   * Whether the strength of smoothing is chosen anew for each map, along rows and along columns:
   * the one for which least error is predicted. Texels that neighbouring functions shear count as
   * longer, and where the pass's Rasterization draws bent edges straight, so does how far they
   * stray. (Milet et al. 2015, section 5, leave that open.) Between about 0.01 and 0.4. Default:
   * on.
   */
  vtkSetMacro(AutomaticSmoothing, bool);
  vtkGetMacro(AutomaticSmoothing, bool);
  vtkBooleanMacro(AutomaticSmoothing, bool);
  ///@}

  ///@{
  /**
   * How far what neighbouring lines ask for is averaged (Milet et al. 2015, step 5), unless
   * AutomaticSmoothing is on: σ of a Gaussian, as a share of the focus. More makes lines more
   * alike, in the end those of a rectilinear warp, and bends triangles less, so that they are drawn
   * faster. Clamped to 0 to 1; what is not a number is refused with an error. Default: 0.05.
   */
  virtual void SetSmoothing(double share);
  vtkGetMacro(Smoothing, double);
  ///@}

#ifndef __VTK_WRAP__
  std::unique_ptr<rtw::WarpStage> MakeStage() override;
#endif

protected:
  vtkNonOrthogonalShadowMapWarp();
  ~vtkNonOrthogonalShadowMapWarp() override;

  int Weights = SQRT_DEMAND;
  int ImportanceResolution = 512;
  bool AutomaticSmoothing = true;
  double Smoothing = 0.05;

private:
  vtkNonOrthogonalShadowMapWarp(const vtkNonOrthogonalShadowMapWarp&) = delete;
  void operator=(const vtkNonOrthogonalShadowMapWarp&) = delete;
};

#endif
