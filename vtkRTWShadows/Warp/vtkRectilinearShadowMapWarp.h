// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRectilinearShadowMapWarp
 * @brief   rectilinear texture warping: rows and columns as wide as what the view needs
 *
 * P. Rosen, Rectilinear Texture Warping for Fast Adaptive Shadow Mapping, 2012. What the camera sees is projected onto
 * the light plane (backward analysis, section 4.1), each sample with an importance; columns and rows collect it, are
 * blurred, and get a share of the map in proportion to it.
 *
 * @sa vtkRTWShadowMapPass
 */
#ifndef vtkRectilinearShadowMapWarp_h
#define vtkRectilinearShadowMapWarp_h

#include "vtkShadowMapWarp.h"

class VTKRTWSHADOWS_EXPORT vtkRectilinearShadowMapWarp : public vtkShadowMapWarp
{
public:
  static vtkRectilinearShadowMapWarp* New();
  vtkTypeMacro(vtkRectilinearShadowMapWarp, vtkShadowMapWarp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The importance functions; several at once are multiplied.
   */
  enum ImportanceFunctions
  {
    DESIRED_VIEW = 1,    ///< what the camera sees, and nothing else (section 5.1); part of all others
    DISTANCE_TO_EYE = 2, ///< one over the depth in the view (section 5.2)
    SURFACE_NORMAL = 4,  ///< up to three times as much where a surface faces the viewer (section 5.4, β = 2)
    SQRT_DEMAND = 8      ///< the square root of the texels that pixels ask for: the least error
  };

  ///@{
  /**
   * Which importance functions to multiply: a sum of ImportanceFunctions. Without SQRT_DEMAND the largest importance in a
   * column or row counts, as published; with it the root of their sum. A value that names no function is
   * refused with an error and changes nothing. Default: SQRT_DEMAND.
   */
  virtual void SetImportance(int functions);
  vtkGetMacro(Importance, int);
  ///@}

  ///@{
  /**
   * Number of cells of each warping map (super-cells, section 3). Clamped to 16 to 2048. Default: 512.
   */
  vtkSetClampMacro(ImportanceResolution, int, 16, 2048);
  vtkGetMacro(ImportanceResolution, int);
  ///@}

  ///@{
  /**
   * Standard deviation of the Gaussian blur of the importance, in cells (section 4.2). Clamped to 0 to 64; 0 is no
   * blur. Default: 3.
   */
  virtual void SetBlurSigma(double sigma);
  vtkGetMacro(BlurSigma, double);
  ///@}

  ///@{
  /**
   * The least importance of a cell, as a share of the mean, so that nothing starves that the samples missed. Clamped
   * to 0.0001 to 1; at 1 no cell gets less than half of what it would get without a warp. Default: 0.01.
   */
  virtual void SetImportanceFloor(double share);
  vtkGetMacro(ImportanceFloor, double);
  ///@}

#ifndef __VTK_WRAP__
  std::unique_ptr<rtw::WarpStage> MakeStage() override;
#endif

protected:
  vtkRectilinearShadowMapWarp();
  ~vtkRectilinearShadowMapWarp() override;

  int Importance = SQRT_DEMAND;
  int ImportanceResolution = 512;
  double BlurSigma = 3;
  double ImportanceFloor = 0.01;

private:
  vtkRectilinearShadowMapWarp(const vtkRectilinearShadowMapWarp&) = delete;
  void operator=(const vtkRectilinearShadowMapWarp&) = delete;
  void SetFinite(double& member, double value, double low, double high, const char* name);
};

#endif
