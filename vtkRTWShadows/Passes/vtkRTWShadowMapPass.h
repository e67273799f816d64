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
   * The importance functions, numbered as vtkRectilinearShadowMapWarp::ImportanceFunctions; several
   * at once are multiplied. Sections are those of Rosen 2012.
   */
  enum ImportanceFunctions
  {
    DESIRED_VIEW = 1, ///< what the camera sees, and nothing else (section 5.1); part of all others
    DISTANCE_TO_EYE = 2,     ///< one over the depth in the view (section 5.2)
    SURFACE_NORMAL = 4,      ///< more where a surface faces the viewer (section 5.4)
    SQRT_DEMAND = 8,         ///< the square root of the texels that pixels ask for: the least error
    SHADOW_EDGE = 16,        ///< a thousandth where there is no shadow edge (section 5.3)
    CENTRE_OF_INTEREST = 32, ///< more in a sphere, or in the middle of the view
    USER_FUNCTION = 64,      ///< the value of the UserFunction
    FOOTPRINT = 128,         ///< the texels a side that give a pixel one texel
    SAMPLE_COUNT = 256       ///< the number of view samples (Milet et al. 2015, section 3)
  };

  /**
   * What the importance is found from (Rosen 2012, section 4.1), as
   * vtkRectilinearShadowMapWarp::Analyses.
   */
  enum Analyses
  {
    FORWARD = 0,  ///< a depth image from the light, looked back into the view
    BACKWARD = 1, ///< what the camera sees, projected onto the light plane
    HYBRID = 2    ///< what the camera sees, and for shadow edges a depth image from the light
  };

  /**
   * What the CENTRE_OF_INTEREST is the centre of, as vtkRectilinearShadowMapWarp::Interests.
   */
  enum Interests
  {
    VIEW = 0,  ///< the picture
    SPHERE = 1 ///< a sphere in the scene
  };

  ///@{
  /**
   * Importance functions that are multiplied: a sum of ImportanceFunctions. A value that names
   * no function is refused with an error. Default: SQRT_DEMAND. Like all settings below, it is
   * one of the warp that the pass begins with, and stays with that warp when another is set.
   */
  void SetImportance(int functions);
  int GetImportance();
  ///@}

  ///@{
  /**
   * Number of cells (super-cells: Rosen 2012, section 3) of each warping map. Clamped to 16 to
   * 2048. Default: 512.
   */
  void SetImportanceResolution(int cells);
  int GetImportanceResolution();
  ///@}

  ///@{
  /**
   * Standard deviation of the Gaussian blur of the importance, in cells (Rosen 2012, section
   * 4.2). Clamped to 0 (no blur) to 64. A value that is not a number is refused with an error.
   * Default: 3.
   */
  void SetBlurSigma(double cells);
  double GetBlurSigma();
  ///@}

  ///@{
  /**
   * The least importance of a cell, as a share of the mean. Clamped to 0.0001 to 1. A value
   * that is not a number is refused with an error. Default: 0.01.
   */
  void SetImportanceFloor(double share);
  double GetImportanceFloor();
  ///@}

  ///@{
  /**
   * The share of the last frame's warping functions that is kept in this frame's. Clamped to 0
   * (none) to 0.99. A value that is not a number is refused with an error. Default: 0.
   */
  void SetTemporalBlending(double share);
  double GetTemporalBlending();
  ///@}

  ///@{
  /**
   * Whether texels stay where they are in the world while the camera moves by a little, so
   * that shadow edges do not crawl. Default: off.
   */
  void SetSnapping(bool snap);
  bool GetSnapping();
  void SnappingOn() { this->SetSnapping(true); }
  void SnappingOff() { this->SetSnapping(false); }
  ///@}

  ///@{
  /**
   * Whether columns and rows of the map in which the camera sees nothing get a millionth of it
   * instead of the ImportanceFloor. Default: off.
   */
  void SetCullEmptyCells(bool cull);
  bool GetCullEmptyCells();
  void CullEmptyCellsOn() { this->SetCullEmptyCells(true); }
  void CullEmptyCellsOff() { this->SetCullEmptyCells(false); }
  ///@}

  ///@{
  /**
   * What the importance is found from: one of Analyses; any other value is refused with an
   * error (Rosen 2012, section 4.1). Default: BACKWARD.
   */
  void SetAnalysis(int analysis);
  void SetAnalysisToForward() { this->SetAnalysis(FORWARD); }
  void SetAnalysisToBackward() { this->SetAnalysis(BACKWARD); }
  void SetAnalysisToHybrid() { this->SetAnalysis(HYBRID); }
  int GetAnalysis();
  ///@}

  ///@{
  /**
   * Texels a side of the light's depth image that FORWARD and HYBRID analyses look at. Clamped
   * to 16 to 8192. Default: 512.
   */
  void SetLightImageResolution(int texels);
  int GetLightImageResolution();
  ///@}

  ///@{
  /**
   * Difference in depth, along the light, above which an edge lies between two neighbouring
   * texels of the light's depth image, as a share of the diagonal of the scene's bounds (Rosen
   * 2012, section 5.3). Clamped to 0 (all is an edge) to 1. A value that is not a number is
   * refused with an error. Default: 0.001.
   */
  void SetEdgeThreshold(double share);
  double GetEdgeThreshold();
  ///@}

  ///@{
  /**
   * How much more important a surface is that faces the viewer, for SURFACE_NORMAL (β of Rosen
   * 2012, section 5.4): up to 1 + bonus. Clamped to 0 to 1000. A value that is not a number is
   * refused with an error. Default: 2.
   */
  void SetSurfaceNormalBonus(double bonus);
  double GetSurfaceNormalBonus();
  ///@}

  ///@{
  /**
   * What the CENTRE_OF_INTEREST is the centre of: one of Interests; any other value is refused
   * with an error. Default: VIEW.
   */
  void SetInterest(int interest);
  void SetInterestToView() { this->SetInterest(VIEW); }
  void SetInterestToSphere() { this->SetInterest(SPHERE); }
  int GetInterest();
  ///@}

  ///@{
  /**
   * Radius of the SPHERE of interest, in world units. Clamped to at least 1e-30. A value that
   * is not finite is refused with an error. Default: 1.
   */
  void SetInterestRadius(double radius);
  double GetInterestRadius();
  ///@}

  ///@{
  /**
   * Radius of what is of interest in the VIEW, as a share of half the picture's smaller side.
   * Clamped to 0.001 to 10. A value that is not a number is refused with an error. Default:
   * 0.5.
   */
  void SetInterestViewRadius(double share);
  double GetInterestViewRadius();
  ///@}

  ///@{
  /**
   * How much more important the CENTRE_OF_INTEREST is: 1 + bonus within its radius, 1 from
   * twice the radius on. Clamped to 0 to 1000. A value that is not a number is refused with an
   * error. Default: 4.
   */
  void SetInterestBonus(double bonus);
  double GetInterestBonus();
  ///@}

  ///@{
  /**
   * Centre of the SPHERE of interest, in world coordinates. Values that are not finite are
   * refused with an error. Default: the origin.
   */
  void SetInterestCentre(double x, double y, double z);
  void SetInterestCentre(const double centre[3]) VTK_SIZEHINT(3);
  double* GetInterestCentre() VTK_SIZEHINT(3);
  ///@}

  ///@{
  /**
   * The importance function of USER_FUNCTION: a GLSL expression, or the body of a function
   * that returns a float, over the variables that
   * vtkRectilinearShadowMapWarp::SetUserFunction() lists. If it does not compile, an error
   * with the messages of the compiler is reported when a frame is drawn, and the function
   * before stays in force. Empty is 1. Default: empty.
   */
  void SetUserFunction(const char* glsl);
  const char* GetUserFunction();
  ///@}

  /**
   * The warp that the pass begins with, which holds the settings above. It stays the same object
   * when another warp is set.
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
