// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPerspectiveShadowMapWarp
 * @brief   a perspective projection of the light plane along the view
 *
 * D. B. Lloyd, D. Tuft, S. Yoon, D. Manocha, Warping and Partitioning for Low Error Shadow Maps,
 * 2006: perspective, light-space perspective and trapezoidal shadow maps differ in one number, the
 * distance n' from the centre of projection to the near end of what is seen. Here n and f, the near
 * and far ends, are those of view samples that the light reaches, found on the GPU; f is where the
 * map's far end would be along the view. For a light that isn't overhead n' is divided by the sine
 * of the angle between view and light (M. Wimmer, D. Scherzer, W. Purgathofer, Light Space
 * Perspective Shadow Maps, 2004), so that the warp comes to nothing by itself as the light nears
 * the line of sight, from behind or in front. The projection lies in the light plane, so that there
 * is no singularity at any n': what is behind its centre is cut off, exactly.
 *
 * The map's t axis lies along the view, whatever the pass's LightPlaneTurn. There is no warp in a
 * parallel view, which has no perspective, for an eye behind a spot, and without the pass's
 * FocusOnView, as a map that reaches behind the viewer would gain nothing.
 *
 * @sa vtkPerspectiveShadowMapPass vtkRectilinearShadowMapWarp vtkNonOrthogonalShadowMapWarp
 */
#ifndef vtkPerspectiveShadowMapWarp_h
#define vtkPerspectiveShadowMapWarp_h

#include "vtkRTWShadowsModule.h" // for the export macro
#include "vtkShadowMapWarp.h"

class VTKRTWSHADOWS_EXPORT vtkPerspectiveShadowMapWarp : public vtkShadowMapWarp
{
public:
  static vtkPerspectiveShadowMapWarp* New();
  vtkTypeMacro(vtkPerspectiveShadowMapWarp, vtkShadowMapWarp);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What n' is, given the near and far ends n and f of what is seen (Lloyd et al. 2006,
   * section 4.1).
   */
  enum Parameterizations
  {
    PSM = 0,             ///< n: perspective shadow maps; as dense across as the view, η = 1
    LISPSM = 1,          ///< n + √(f n): light-space perspective shadow maps, η = 0
    TSM = 2,             ///< what puts the focus point at 80 % of the map: trapezoidal shadow maps
    UNWARPED = 3,        ///< infinite, η = -1
    BY_ETA = 4,          ///< the one that belongs to Eta (equation 11)
    BY_NEAR_DISTANCE = 5 ///< NearDistance
  };

  ///@{
  /**
   * One of Parameterizations; any other value is refused with an error. From PSM to LISPSM the
   * greatest errors of the view along the map's axes have the same product. Default: LISPSM, which
   * is the same error at both ends of the view.
   */
  virtual void SetParameterization(int parameterization);
  vtkGetMacro(Parameterization, int);
  void SetParameterizationToPSM() { this->SetParameterization(PSM); }
  void SetParameterizationToLiSPSM() { this->SetParameterization(LISPSM); }
  void SetParameterizationToTSM() { this->SetParameterization(TSM); }
  void SetParameterizationToUnwarped() { this->SetParameterization(UNWARPED); }
  void SetParameterizationToByEta() { this->SetParameterization(BY_ETA); }
  void SetParameterizationToByNearDistance() { this->SetParameterization(BY_NEAR_DISTANCE); }
  ///@}

  ///@{
  /**
   * η of Equation 11, which n' goes by evenly in the greatest error along t: from -1, no warp, over
   * 0, LiSPSM, to 1, PSM. Setting it sets Parameterization to BY_ETA. What is out of that range or
   * not a number is refused with an error, and nothing changes. Default: 0.
   */
  virtual void SetEta(double eta);
  vtkGetMacro(Eta, double);
  ///@}

  ///@{
  /**
   * n' for a light overhead, in world units. Setting it sets Parameterization to BY_NEAR_DISTANCE.
   * Less than n is drawn as n, so that nothing seen can come near the centre of projection;
   * infinity is no warp. What is not above 0 or not a number is refused with an error, and nothing
   * changes. Default: 1.
   */
  virtual void SetNearDistance(double distance);
  vtkGetMacro(NearDistance, double);
  ///@}

  ///@{
  /**
   * Where the focus point of TSM lies between the near and far ends of what is seen, along the
   * view. The part before it takes 80 % of the map; from 0.8 on there is no warp. Above 0, up to 1;
   * anything else is refused with an error. Default: 0.1.
   */
  virtual void SetFocusPoint(double share);
  vtkGetMacro(FocusPoint, double);
  ///@}

  /**
   * How a map's texels are divided between s and t, of which the latter goes along the view.
   */
  enum ResolutionSplits
  {
    SPLIT_SQUARE = 0,    ///< as many along both
    SPLIT_CRITICAL = 1,  ///< in the ratio of the critical resolution: Equations 13 and 14
    SPLIT_AUTOMATIC = 2, ///< in the ratio that the least error is predicted for
    SPLIT_BY_RATIO = 3   ///< in the ratio ResolutionRatio
  };

  ///@{
  /**
   * One of ResolutionSplits; any other value is refused with an error. A map never has more texels
   * than the square of the pass's Resolution, so that all splits are of one memory; all lights' and
   * layers' maps have one size.
   *
   * With SPLIT_CRITICAL the greatest perspective aliasing errors along s and t become equal: those
   * of Equations 9 and 10 in what the view's frustum shows of the scene's bounds, for the light's
   * direction as it is, in the geometric mean of lights and layers. That knows nothing of surfaces:
   * where these stand slantwise in the light, texels are as much too wide on them, and the error
   * may grow. With SPLIT_AUTOMATIC they are taken into account: it is the ratio with the least
   * error predicted, as vtkInspectableShadowMapPass::GetPredictedError has it, from the shadow
   * edges of frames before; the first frame is drawn once more where that helps. Without a mask
   * (multisampling, view samples of the previous frame) maps stay square.
   *
   * Both ratios are powers of the fourth root of 2 that stay until another is clearly better: by
   * three quarters of such a step, or by 2 % of the error, so that nothing pops under a moving
   * camera. Maps of layers that keep still (see vtkDepthSplitShadowMapPartition::SetStable) are
   * square, and a side longer than the GPU's longest is as long as that.
   * Default: SPLIT_AUTOMATIC.
   */
  virtual void SetResolutionSplit(int split);
  vtkGetMacro(ResolutionSplit, int);
  void SetResolutionSplitToSquare() { this->SetResolutionSplit(SPLIT_SQUARE); }
  void SetResolutionSplitToCritical() { this->SetResolutionSplit(SPLIT_CRITICAL); }
  void SetResolutionSplitToAutomatic() { this->SetResolutionSplit(SPLIT_AUTOMATIC); }
  void SetResolutionSplitToByRatio() { this->SetResolutionSplit(SPLIT_BY_RATIO); }
  ///@}

  ///@{
  /**
   * How many times as many texels along s as along t. Setting it sets ResolutionSplit to
   * SPLIT_BY_RATIO. From 1/16 to 16; anything else is refused with an error, and nothing changes.
   * Default: 1.
   */
  virtual void SetResolutionRatio(double ratio);
  vtkGetMacro(ResolutionRatio, double);
  ///@}

#ifndef __VTK_WRAP__
  std::unique_ptr<rtw::WarpStage> MakeStage() override;
#endif

protected:
  vtkPerspectiveShadowMapWarp();
  ~vtkPerspectiveShadowMapWarp() override;

  int Parameterization = LISPSM;
  double Eta = 0;
  double NearDistance = 1;
  double FocusPoint = 0.1;
  int ResolutionSplit = SPLIT_AUTOMATIC;
  double ResolutionRatio = 1;

private:
  vtkPerspectiveShadowMapWarp(const vtkPerspectiveShadowMapWarp&) = delete;
  void operator=(const vtkPerspectiveShadowMapWarp&) = delete;
};

#endif
