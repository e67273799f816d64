// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPerspectiveShadowMapPass
 * @brief   perspective, light-space perspective and trapezoidal shadow maps: one map a light, under
 * a perspective projection along the view
 *
 * D. B. Lloyd, D. Tuft, S. Yoon, D. Manocha, Warping and Partitioning for Low Error Shadow Maps,
 * 2006. Triangles keep straight edges, so that Rasterization makes no difference.
 *
 * @sa vtkAdaptiveShadowMapPass vtkPerspectiveShadowMapWarp
 */
#ifndef vtkPerspectiveShadowMapPass_h
#define vtkPerspectiveShadowMapPass_h

#include "vtkAdaptiveShadowMapPass.h"

class vtkPerspectiveShadowMapWarp;

class VTKRTWSHADOWS_EXPORT vtkPerspectiveShadowMapPass : public vtkAdaptiveShadowMapPass
{
public:
  static vtkPerspectiveShadowMapPass* New();
  vtkTypeMacro(vtkPerspectiveShadowMapPass, vtkAdaptiveShadowMapPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * As vtkPerspectiveShadowMapWarp::Parameterizations.
   */
  enum Parameterizations
  {
    PSM = 0,
    LISPSM = 1,
    TSM = 2,
    UNWARPED = 3,
    BY_ETA = 4,
    BY_NEAR_DISTANCE = 5
  };

  /**
   * As vtkPerspectiveShadowMapWarp::ResolutionSplits.
   */
  enum ResolutionSplits
  {
    SPLIT_SQUARE = 0,
    SPLIT_CRITICAL = 1,
    SPLIT_AUTOMATIC = 2,
    SPLIT_BY_RATIO = 3
  };

  ///@{
  /**
   * The settings of the pass's warp, for short: see vtkPerspectiveShadowMapWarp for units, ranges
   * and defaults. They stay with that warp when another is set.
   */
  void SetParameterization(int parameterization);
  void SetParameterizationToPSM() { this->SetParameterization(PSM); }
  void SetParameterizationToLiSPSM() { this->SetParameterization(LISPSM); }
  void SetParameterizationToTSM() { this->SetParameterization(TSM); }
  void SetParameterizationToUnwarped() { this->SetParameterization(UNWARPED); }
  void SetParameterizationToByEta() { this->SetParameterization(BY_ETA); }
  void SetParameterizationToByNearDistance() { this->SetParameterization(BY_NEAR_DISTANCE); }
  int GetParameterization();
  void SetEta(double eta);
  double GetEta();
  void SetNearDistance(double distance);
  double GetNearDistance();
  void SetFocusPoint(double share);
  double GetFocusPoint();
  void SetResolutionSplit(int split);
  void SetResolutionSplitToSquare() { this->SetResolutionSplit(SPLIT_SQUARE); }
  void SetResolutionSplitToCritical() { this->SetResolutionSplit(SPLIT_CRITICAL); }
  void SetResolutionSplitToAutomatic() { this->SetResolutionSplit(SPLIT_AUTOMATIC); }
  void SetResolutionSplitToByRatio() { this->SetResolutionSplit(SPLIT_BY_RATIO); }
  int GetResolutionSplit();
  void SetResolutionRatio(double ratio);
  double GetResolutionRatio();
  ///@}

  /**
   * The warp that those settings are of.
   */
  vtkPerspectiveShadowMapWarp* GetPerspectiveWarp();

protected:
  vtkPerspectiveShadowMapPass();
  ~vtkPerspectiveShadowMapPass() override;

private:
  vtkPerspectiveShadowMapPass(const vtkPerspectiveShadowMapPass&) = delete;
  void operator=(const vtkPerspectiveShadowMapPass&) = delete;

  vtkNew<vtkPerspectiveShadowMapWarp> Perspective;
};

#endif
