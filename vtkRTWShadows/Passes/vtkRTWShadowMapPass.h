// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRTWShadowMapPass
 * @brief   rectilinear texture warping: one map a light, its rows and columns as wide as the view
 * needs
 *
 * P. Rosen, Rectilinear Texture Warping for Fast Adaptive Shadow Mapping, 2012, with forward,
 * backward and hybrid analysis. The published importance functions are there; the default, the
 * square root of demand, has less error.
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
    SQRT_DEMAND = 8,
    SHADOW_EDGE = 16,
    CENTRE_OF_INTEREST = 32,
    USER_FUNCTION = 64,
    FOOTPRINT = 128,
    SAMPLE_COUNT = 256
  };

  /**
   * As vtkRectilinearShadowMapWarp::Analyses.
   */
  enum Analyses
  {
    FORWARD = 0,
    BACKWARD = 1,
    HYBRID = 2
  };

  /**
   * As vtkRectilinearShadowMapWarp::Interests.
   */
  enum Interests
  {
    VIEW = 0,
    SPHERE = 1
  };

  ///@{
  /**
   * The settings of the pass's warp, for short: see vtkRectilinearShadowMapWarp for units, ranges
   * and defaults. They stay with that warp when another is set.
   */
  void SetImportance(int functions);
  int GetImportance();
  void SetImportanceResolution(int cells);
  int GetImportanceResolution();
  void SetBlurSigma(double cells);
  double GetBlurSigma();
  void SetImportanceFloor(double share);
  double GetImportanceFloor();
  void SetTemporalBlending(double share);
  double GetTemporalBlending();
  void SetSnapping(bool snap);
  bool GetSnapping();
  void SnappingOn() { this->SetSnapping(true); }
  void SnappingOff() { this->SetSnapping(false); }
  void SetCullEmptyCells(bool cull);
  bool GetCullEmptyCells();
  void CullEmptyCellsOn() { this->SetCullEmptyCells(true); }
  void CullEmptyCellsOff() { this->SetCullEmptyCells(false); }
  void SetAnalysis(int analysis);
  void SetAnalysisToForward() { this->SetAnalysis(FORWARD); }
  void SetAnalysisToBackward() { this->SetAnalysis(BACKWARD); }
  void SetAnalysisToHybrid() { this->SetAnalysis(HYBRID); }
  int GetAnalysis();
  void SetLightImageResolution(int texels);
  int GetLightImageResolution();
  void SetEdgeThreshold(double share);
  double GetEdgeThreshold();
  void SetSurfaceNormalBonus(double bonus);
  double GetSurfaceNormalBonus();
  void SetInterest(int interest);
  void SetInterestToView() { this->SetInterest(VIEW); }
  void SetInterestToSphere() { this->SetInterest(SPHERE); }
  int GetInterest();
  void SetInterestRadius(double radius);
  double GetInterestRadius();
  void SetInterestViewRadius(double share);
  double GetInterestViewRadius();
  void SetInterestBonus(double bonus);
  double GetInterestBonus();
  void SetInterestCentre(double x, double y, double z);
  void SetInterestCentre(const double centre[3]) VTK_SIZEHINT(3);
  double* GetInterestCentre() VTK_SIZEHINT(3);
  void SetUserFunction(const char* glsl);
  const char* GetUserFunction();
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
