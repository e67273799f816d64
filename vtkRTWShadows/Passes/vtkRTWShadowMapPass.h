// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRTWShadowMapPass
 * @brief   rectilinear texture warping: one map a light, its rows and columns as wide as the view needs
 *
 * P. Rosen, Rectilinear Texture Warping for Fast Adaptive Shadow Mapping, 2012, with backward analysis. The published
 * importance functions are there; the default, the square root of demand, has less error.
 *
 * @sa vtkAdaptiveShadowMapPass vtkRectilinearShadowMapWarp
 */
#ifndef vtkRTWShadowMapPass_h
#define vtkRTWShadowMapPass_h

#include "vtkAdaptiveShadowMapPass.h"

class vtkRectilinearShadowMapWarp;

class VTKRTWSHADOWS_EXPORT vtkRTWShadowMapPass : public vtkAdaptiveShadowMapPass
{
public:
  static vtkRTWShadowMapPass* New();
  vtkTypeMacro(vtkRTWShadowMapPass, vtkAdaptiveShadowMapPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * As vtkRectilinearShadowMapWarp::ImportanceFunctions.
   */
  enum ImportanceFunctions
  {
    DESIRED_VIEW = 1,
    DISTANCE_TO_EYE = 2,
    SURFACE_NORMAL = 4,
    SQRT_DEMAND = 8
  };

  ///@{
  /**
   * The settings of the pass's warp, for short: see vtkRectilinearShadowMapWarp for units, ranges and defaults. They stay with
   * that warp when another is set.
   */
  void SetImportance(int functions);
  int GetImportance();
  void SetImportanceResolution(int cells);
  int GetImportanceResolution();
  void SetBlurSigma(double cells);
  double GetBlurSigma();
  void SetImportanceFloor(double share);
  double GetImportanceFloor();
  ///@}

  /**
   * The warp that those settings are of.
   */
  vtkRectilinearShadowMapWarp* GetRectilinearWarp();

protected:
  vtkRTWShadowMapPass();
  ~vtkRTWShadowMapPass() override;

private:
  vtkRTWShadowMapPass(const vtkRTWShadowMapPass&) = delete;
  void operator=(const vtkRTWShadowMapPass&) = delete;

  vtkNew<vtkRectilinearShadowMapWarp> Rectilinear;
};

#endif
