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
   * What the distance n' of the centre of projection is, given the near and far ends n and f of
   * what is seen (Lloyd et al. 2006, section 4.1), as
   * vtkPerspectiveShadowMapWarp::Parameterizations.
   */
  enum Parameterizations
  {
    PSM = 0,      ///< n: perspective shadow maps, η = 1
    LISPSM = 1,   ///< n + √(f n): light-space perspective shadow maps, η = 0
    TSM = 2,      ///< trapezoidal shadow maps: the FocusPoint comes to lie at 80 % of the map
    UNWARPED = 3, ///< infinite: no warp, η = -1
    BY_ETA = 4,   ///< the one that belongs to Eta
    BY_NEAR_DISTANCE = 5 ///< NearDistance
  };

  /**
   * How the texels of a map are divided between s and t, of which t goes along the view, as
   * vtkPerspectiveShadowMapWarp::ResolutionSplits.
   */
  enum ResolutionSplits
  {
    SPLIT_SQUARE = 0,    ///< as many along both
    SPLIT_CRITICAL = 1,  ///< in the ratio of the critical resolution (equations 13 and 14)
    SPLIT_AUTOMATIC = 2, ///< in the ratio that the least error is predicted for
    SPLIT_BY_RATIO = 3   ///< in the ratio ResolutionRatio
  };

  ///@{
  /**
   * How the distance n' from the centre of projection to the near end of what is seen is
   * chosen (Lloyd et al. 2006, section 4.1): one of Parameterizations; any other value is
   * refused with an error. Default: LISPSM. Like all settings below, it is one of the warp
   * that the pass begins with, and stays with that warp when another is set.
   */
  void SetParameterization(int parameterization);
  void SetParameterizationToPSM() { this->SetParameterization(PSM); }
  void SetParameterizationToLiSPSM() { this->SetParameterization(LISPSM); }
  void SetParameterizationToTSM() { this->SetParameterization(TSM); }
  void SetParameterizationToUnwarped() { this->SetParameterization(UNWARPED); }
  void SetParameterizationToByEta() { this->SetParameterization(BY_ETA); }
  void SetParameterizationToByNearDistance() { this->SetParameterization(BY_NEAR_DISTANCE); }
  int GetParameterization();
  ///@}

  ///@{
  /**
   * η of Lloyd et al. 2006, equation 11, which gives n': from -1 (no warp) over 0 (LISPSM) to
   * 1 (PSM). Setting it sets Parameterization to BY_ETA. A value outside that range or not a
   * number is refused with an error. Default: 0.
   */
  void SetEta(double eta);
  double GetEta();
  ///@}

  ///@{
  /**
   * n' for a light overhead, in world units, above 0; infinity is no warp, and less than the
   * distance n of the nearest view sample is drawn as n. Setting it sets Parameterization to
   * BY_NEAR_DISTANCE. A value of 0 or less, or not a number, is refused with an error.
   * Default: 1.
   */
  void SetNearDistance(double distance);
  double GetNearDistance();
  ///@}

  ///@{
  /**
   * Where the focus point of TSM lies between the near end (0) and the far end (1) of what is
   * seen, along the view; what is nearer takes 80 % of the map. Above 0, up to 1; anything
   * else is refused with an error. Default: 0.1.
   */
  void SetFocusPoint(double share);
  double GetFocusPoint();
  ///@}

  ///@{
  /**
   * How the texels of a map are divided between its axes s and t: one of ResolutionSplits; any
   * other value is refused with an error (Lloyd et al. 2006, section 4.2). Default:
   * SPLIT_AUTOMATIC.
   */
  void SetResolutionSplit(int split);
  void SetResolutionSplitToSquare() { this->SetResolutionSplit(SPLIT_SQUARE); }
  void SetResolutionSplitToCritical() { this->SetResolutionSplit(SPLIT_CRITICAL); }
  void SetResolutionSplitToAutomatic() { this->SetResolutionSplit(SPLIT_AUTOMATIC); }
  void SetResolutionSplitToByRatio() { this->SetResolutionSplit(SPLIT_BY_RATIO); }
  int GetResolutionSplit();
  ///@}

  ///@{
  /**
   * The number of texels along s over that along t. Setting it sets ResolutionSplit to
   * SPLIT_BY_RATIO. From 1/16 to 16; anything else is refused with an error. Default: 1.
   */
  void SetResolutionRatio(double ratio);
  double GetResolutionRatio();
  ///@}

  /**
   * The warp that the pass begins with, which holds the settings above. It stays the same object
   * when another warp is set.
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
