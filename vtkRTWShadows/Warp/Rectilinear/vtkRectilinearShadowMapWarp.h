// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRectilinearShadowMapWarp
 * @brief   rectilinear texture warping: rows and columns as wide as what the view needs
 *
 * P. Rosen, Rectilinear Texture Warping for Fast Adaptive Shadow Mapping, 2012. What the camera
 * sees is projected onto the light plane (backward analysis, section 4.1), each sample with an
 * importance; columns and rows collect it, are blurred, and get a share of the map in proportion to
 * it. What a light sees can be looked at too (forward and hybrid analysis).
 *
 * @sa vtkRTWShadowMapPass
 */
#ifndef vtkRectilinearShadowMapWarp_h
#define vtkRectilinearShadowMapWarp_h

#include "vtkShadowMapWarp.h"

#include <string> // for the user's function

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
    DESIRED_VIEW = 1, ///< what the camera sees, and nothing else (section 5.1); part of all others
    DISTANCE_TO_EYE = 2,     ///< one over the depth in the view (section 5.2)
    SURFACE_NORMAL = 4,      ///< more where a surface faces the viewer (section 5.4)
    SQRT_DEMAND = 8,         ///< the square root of the texels that pixels ask for
    SHADOW_EDGE = 16,        ///< a thousandth where there is no shadow edge (section 5.3)
    CENTRE_OF_INTEREST = 32, ///< more in a sphere, or in the middle of the view
    USER_FUNCTION = 64,      ///< what UserFunction gives
    FOOTPRINT = 128,         ///< the texels a side that give a pixel one texel
    SAMPLE_COUNT = 256       ///< the number of samples (Milet et al. 2015, section 3)
  };

  /**
   * What the importance is found from (section 4.1).
   */
  enum Analyses
  {
    FORWARD = 0,  ///< a depth image from the light, looked back into the view
    BACKWARD = 1, ///< what the camera sees, projected onto the light plane
    HYBRID = 2    ///< what the camera sees, and for shadow edges a depth image from the light
  };

  /**
   * What the CENTRE_OF_INTEREST is the centre of.
   */
  enum Interests
  {
    VIEW = 0,  ///< the picture
    SPHERE = 1 ///< a sphere in the scene
  };

  ///@{
  /**
   * Which importance functions to multiply: a sum of ImportanceFunctions. The largest importance in
   * a column or row counts, as published (section 4.2); with SAMPLE_COUNT their sum does, and with
   * SQRT_DEMAND the root of their sum.
   *
   * SHADOW_EDGE times SQRT_DEMAND is demand at shadow edges alone, with 2 % of the plain one spread
   * below it. Edges are those of the light's depth image in a FORWARD or HYBRID analysis, and in a
   * BACKWARD one those of the last frame's shadow mask: all is an edge in a first frame, what just
   * came into view, and in windows with multisampling, which have no mask.
   *
   * A value that names no function is refused with an error and changes nothing. Default:
   * SQRT_DEMAND.
   */
  virtual void SetImportance(int functions);
  vtkGetMacro(Importance, int);
  ///@}

  ///@{
  /**
   * One of Analyses. FORWARD knows neither what hides what from the camera, nor what lies in the
   * light behind the first surface, so that it has more error. FORWARD, and HYBRID with
   * SHADOW_EDGE, draw the casters once more each frame. Any other value is refused with an error.
   * Default: BACKWARD.
   */
  virtual void SetAnalysis(int analysis);
  vtkGetMacro(Analysis, int);
  void SetAnalysisToForward() { this->SetAnalysis(FORWARD); }
  void SetAnalysisToBackward() { this->SetAnalysis(BACKWARD); }
  void SetAnalysisToHybrid() { this->SetAnalysis(HYBRID); }
  ///@}

  ///@{
  /**
   * Texels a side of the light's depth image, which covers the focus evenly (section 6); it has to
   * show the smallest feature of interest. Clamped to 16 to 8192. Default: 512.
   */
  vtkSetClampMacro(LightImageResolution, int, 16, 8192);
  vtkGetMacro(LightImageResolution, int);
  ///@}

  ///@{
  /**
   * How far the depths of two neighbouring texels of the light's image are apart, along the light,
   * if an edge lies between them, as a share of the diagonal of the scene's bounds. The paper takes
   * its shadow bias for it (section 5.3); here the slopes of the two surfaces are taken off first,
   * so that it can be small. Clamped to 0 to 1; at 0 all is an edge. A value that is not a number
   * is refused with an error. Default: 0.001.
   */
  virtual void SetEdgeThreshold(double share);
  vtkGetMacro(EdgeThreshold, double);
  ///@}

  ///@{
  /**
   * How much more important a surface is that faces the viewer: SURFACE_NORMAL is 1 + bonus ·
   * clamp(−normal · view direction, 0, 1) (section 5.4, β). Clamped to 0 to 1000. A value that is
   * not a number is refused with an error. Default: 2.
   */
  virtual void SetSurfaceNormalBonus(double bonus);
  vtkGetMacro(SurfaceNormalBonus, double);
  ///@}

  ///@{
  /**
   * What is of interest: one of Interests; any other value is refused with an error. Default: VIEW.
   */
  virtual void SetInterest(int interest);
  vtkGetMacro(Interest, int);
  void SetInterestToView() { this->SetInterest(VIEW); }
  void SetInterestToSphere() { this->SetInterest(SPHERE); }
  ///@}

  ///@{
  /**
   * Centre of the SPHERE, in world coordinates. Values that are not finite are refused with an
   * error. Default: the origin.
   */
  virtual void SetInterestCentre(double x, double y, double z);
  void SetInterestCentre(const double centre[3]) VTK_SIZEHINT(3);
  vtkGetVector3Macro(InterestCentre, double);
  ///@}

  ///@{
  /**
   * Radius of the SPHERE, in world units. Clamped to at least 1e-30. A value that is not finite is
   * refused with an error. Default: 1.
   */
  virtual void SetInterestRadius(double radius);
  vtkGetMacro(InterestRadius, double);
  ///@}

  ///@{
  /**
   * Radius of what is of interest in the VIEW, as a share of half the picture's smaller side.
   * Clamped to 0.001 to 10. A value that is not a number is refused with an error. Default: 0.5.
   */
  virtual void SetInterestViewRadius(double share);
  vtkGetMacro(InterestViewRadius, double);
  ///@}

  ///@{
  /**
   * How much more important the CENTRE_OF_INTEREST is: 1 + bonus in it, 1 from twice its radius on,
   * and smooth between. Clamped to 0 to 1000. A value that is not a number is refused with an
   * error. Default: 4.
   */
  virtual void SetInterestBonus(double bonus);
  vtkGetMacro(InterestBonus, double);
  ///@}

  ///@{
  /**
   * The user's own importance function: a GLSL expression, or a function's body with a return in
   * it, of type float, over
   *
   *  - vec3 position: of a sample, in view coordinates (the eye in the origin, the view along −z),
   * in world units;
   *  - vec3 normal: of the surface there, in view coordinates, towards the viewer, of length 1;
   *  - float depth: distance along the view's direction, in world units;
   *  - float luminance: what this light alone, without its shadow, colour and falloff, gives a
   * white matte surface: the cosine between the normal and the way to the light, 0 to 1. (Shaded
   * pixels don't exist yet when samples are looked at.);
   *  - vec2 footprint: what a pixel takes along the two axes of the light plane, as a share of what
   * the map covers.
   *
   * What is negative or not a number counts as 0, and what exceeds 2^20 as that; values near 1 keep
   * most precision in sums. It is compiled in the next frame that is drawn. If that fails an error
   * is reported, once, with the compiler's messages; they name source 0 and this function's own
   * lines. The last function that did compile stays in force until then; 1 if there was none. Empty
   * is 1. Default: empty.
   */
  virtual void SetUserFunction(const char* glsl);
  const char* GetUserFunction() const { return this->UserFunction.c_str(); }
  ///@}

  ///@{
  /**
   * Number of cells of each warping map (super-cells, section 3). Clamped to 16 to 2048. Default:
   * 512.
   */
  vtkSetClampMacro(ImportanceResolution, int, 16, 2048);
  vtkGetMacro(ImportanceResolution, int);
  ///@}

  ///@{
  /**
   * Standard deviation of the Gaussian blur of the importance, in cells (section 4.2). Clamped to 0
   * to 64; 0 is no blur. Default: 3.
   */
  virtual void SetBlurSigma(double sigma);
  vtkGetMacro(BlurSigma, double);
  ///@}

  ///@{
  /**
   * The least importance of a cell, as a share of the mean, so that nothing starves that the
   * samples missed. Clamped to 0.0001 to 1; at 1 no cell gets less than half of what it would get
   * without a warp. Default: 0.01.
   */
  virtual void SetImportanceFloor(double share);
  vtkGetMacro(ImportanceFloor, double);
  ///@}

  ///@{
  /**
   * Whether columns and rows in which the camera sees nothing get no more of the map than keeps the
   * warp invertible in single precision, a millionth, instead of the ImportanceFloor. Columns and
   * rows as near to what is seen as the blur and the filter reach are spared. All are, where
   * receivers may be seen that no view sample is of: with multisampling, and with view samples of
   * the previous frame. It counts with a high ImportanceFloor; with the default one it is a
   * hundredth of the map at most. Default: off.
   */
  vtkSetMacro(CullEmptyCells, bool);
  vtkGetMacro(CullEmptyCells, bool);
  vtkBooleanMacro(CullEmptyCells, bool);
  ///@}

  ///@{
  /**
   * The share of the last frame's warping functions that is kept, so that they change slowly. The
   * focus stays as with Snapping: in a deep view it is several times larger in one frame than in
   * the next. A frame starts anew after a cut (a turn of more than 3 degrees, a move of more than a
   * hundredth of the scene's diagonal, a zoom by more than a twentieth), in a window of another
   * size, when the light has moved, with another number of lights, and when anything has been set
   * otherwise. In a still view maps are drawn until the functions are within a quarter of a texel
   * of what the view wants, 12 frames at 0.5 and 1024 texels. Texels crawl less, but do crawl;
   * Snapping keeps them in place. Clamped to 0 to 0.99; 0 is none. A value that is not a number is
   * refused with an error. Default: 0.
   */
  virtual void SetTemporalBlending(double share);
  vtkGetMacro(TemporalBlending, double);
  ///@}

  ///@{
  /**
   * Whether texels stay where they are in the world while the camera moves by a little, so that
   * shadow edges don't crawl: the focus and the warping functions of the last frame are kept as
   * long as the focus holds what is seen, and the error that the function predicts (as that of
   * SQRT_DEMAND) is at most a tenth above the least. A focus that changes gets some room to spare.
   * With TemporalBlending, it is the blended functions that are kept. A frame starts anew as it
   * does there. Default: off.
   */
  vtkSetMacro(Snapping, bool);
  vtkGetMacro(Snapping, bool);
  vtkBooleanMacro(Snapping, bool);
  ///@}

#ifndef __VTK_WRAP__
  std::unique_ptr<rtw::WarpStage> MakeStage() override;
#endif

protected:
  vtkRectilinearShadowMapWarp();
  ~vtkRectilinearShadowMapWarp() override;

  int Importance = SQRT_DEMAND;
  int Analysis = BACKWARD;
  int LightImageResolution = 512;
  double EdgeThreshold = 0.001;
  double SurfaceNormalBonus = 2;
  int Interest = VIEW;
  double InterestCentre[3] = { 0, 0, 0 };
  double InterestRadius = 1;
  double InterestViewRadius = 0.5;
  double InterestBonus = 4;
  std::string UserFunction;
  int ImportanceResolution = 512;
  double BlurSigma = 3;
  double ImportanceFloor = 0.01;
  double TemporalBlending = 0;
  bool Snapping = false;
  bool CullEmptyCells = false;

private:
  vtkRectilinearShadowMapWarp(const vtkRectilinearShadowMapWarp&) = delete;
  void operator=(const vtkRectilinearShadowMapWarp&) = delete;
  void SetFinite(double& member, double value, double low, double high, const char* name);
  void Choose(int& member, int value, int most, const char* name, const char* expected);
  void Refuse(const std::string& log);

  /// Whether the user's function failed to compile and that has been reported.
  bool IsRefused = false;
};

#endif
