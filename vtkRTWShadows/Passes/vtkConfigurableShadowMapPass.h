// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkConfigurableShadowMapPass
 * @brief   what can be set of every technique
 *
 * The common properties of all vtkAdaptiveShadowMapPass. None has to be set: the defaults are what is most accurate for its
 * cost, and Resolution is the one number that trades time and memory for accuracy.
 *
 * @sa vtkAdaptiveShadowMapPass
 */
#ifndef vtkConfigurableShadowMapPass_h
#define vtkConfigurableShadowMapPass_h

#include "vtkInspectableShadowMapPass.h"
#include "vtkRTWShadowsModule.h" // for the export macro

class VTKRTWSHADOWS_EXPORT vtkConfigurableShadowMapPass : public vtkInspectableShadowMapPass
{
public:
  vtkAbstractTypeMacro(vtkConfigurableShadowMapPass, vtkInspectableShadowMapPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How the decisions of neighbouring texels become one.
   */
  enum Filters
  {
    NEAREST = 0,  ///< the texel that the receiver falls on
    BILINEAR = 1, ///< the four nearest, weighted by distance
    PCF = 2, ///< those within FilterRadius texels on the map: smooth edges, as fine as the map is
             ///< at each place
    SOFT = 3 ///< those within FilterRadius in the world: penumbras as wide everywhere, however the
             ///< map is warped
  };

  /**
   * How a receiver's depth is compared with a texel's.
   */
  enum DepthTests
  {
    /// Against two planes, with nothing to tune: the texel's depth has to be in front of the
    /// receiver's tangent plane at the texel's centre, and the plane of the occluder, whose depth
    /// gradient the map holds beside the depth, in front of the receiver at the receiver's place.
    /// On convex surfaces the first condition keeps a surface from shadowing itself, on concave
    /// ones the second; the tolerance follows from rounding alone. The second plane is this
    /// module's own addition to RECEIVER_PLANE.
    DUAL = 0,
    /// Against the receiver's tangent plane at the texel's centre (receiver-plane depth bias):
    /// curved surfaces speckle.
    RECEIVER_PLANE = 1,
    /// Against the receiver's depth less ConstantBias, the usual way: acne or detached shadows,
    /// depending on the bias.
    CONSTANT_BIAS = 2
  };

  /**
   * How triangles are drawn whose edges a warp bends.
   */
  enum Rasterizations
  {
    LINEAR = 0,      ///< vertices are warped, edges stay straight: good for small triangles only
    TESSELLATED = 1, ///< bent triangles are cut up until no edge is longer than MaximumEdgeLength (Rosen 2012, section 6.2)
    EXACT = 2,       ///< each fragment of a bent triangle decides on the unwarped light plane
    AUTOMATIC = 3    ///< EXACT where a triangle's bend could be seen, an eighth of a texel, LINEAR where not, chosen for each triangle
  };

  /**
   * What the view is sampled from, for focus and importance.
   */
  enum ViewSampleSources
  {
    PREPASS = 0,       ///< a depth pass of this frame
    PREVIOUS_FRAME = 1 ///< the depth of the last frame, by its camera
  };

  /**
   * How the light plane, in which a map's columns and rows lie, is turned about the light's direction.
   */
  enum LightPlaneTurns
  {
    TURN_OFF = 0,            ///< the same for every view
    TURN_VIEW_ALIGNED = 1,   ///< columns run along what the camera looks along
    TURN_AUTOMATIC = 2,      ///< the turn with the least predicted error
    TURN_MINIMAL_FRUSTUM = 3 ///< that of the smallest map around all that can be seen
  };

  ///@{
  /**
   * Texels a side of each layer. 1 to what the GPU allows (usually 16384); what is beyond that is clamped to it,
   * with a warning, when it is first drawn. 0 is refused. Default: 1024.
   */
  virtual void SetResolution(unsigned int resolution);
  virtual unsigned int GetResolution();
  ///@}

  ///@{
  /**
   * Whether each layer is fitted to what the camera sees in the light, the desired view (Rosen 2012, section 5.1), found by
   * reduction on the GPU, instead of to the whole scene or the whole cone of a spot. Casters outside the view are kept
   * either way. Default: on.
   */
  vtkSetMacro(FocusOnView, bool);
  vtkGetMacro(FocusOnView, bool);
  vtkBooleanMacro(FocusOnView, bool);
  ///@}

  ///@{
  /**
   * How decisions are filtered: one of Filters; any other value is refused with an error. Each
   * texel's decision is made by the DepthTest, whatever the filter, so that wide ones need no bias
   * either. PCF and SOFT (Rosen 2012, section 6.2) weight up to 49 decisions, seven a side, by a
   * Gaussian, against four of BILINEAR. Default: BILINEAR.
   */
  virtual void SetFilter(int filter);
  vtkGetMacro(Filter, int);
  void SetFilterToNearest() { this->SetFilter(NEAREST); }
  void SetFilterToBilinear() { this->SetFilter(BILINEAR); }
  void SetFilterToPCF() { this->SetFilter(PCF); }
  void SetFilterToSoft() { this->SetFilter(SOFT); }
  ///@}

  ///@{
  /**
   * How far PCF and SOFT look around a receiver. For PCF it is in texels, 0 to 8: more is taken for
   * 8, with a warning, when it is first drawn. For SOFT it is in world units, measured across the
   * light's direction where the shadow falls, under a spot too, whose light spreads: a penumbra is
   * twice as wide, or as a texel, if that is more. 0 is BILINEAR. What is negative, not a number,
   * or above 1e30 is refused with an error. A change compiles no shader. Default: 2.
   */
  virtual void SetFilterRadius(double radius);
  vtkGetMacro(FilterRadius, double);
  ///@}

  ///@{
  /**
   * Whether PCF and SOFT displace their taps from pixel to pixel, by a pattern that stays the same
   * from frame to frame. It turns what is left of steps in wide penumbras into grain. PCF of up to
   * 2 texels takes every texel and looks the same. Default: off.
   */
  vtkSetMacro(FilterJitter, bool);
  vtkGetMacro(FilterJitter, bool);
  vtkBooleanMacro(FilterJitter, bool);
  ///@}

  ///@{
  /**
   * How depths are compared: one of DepthTests; any other value is refused with an error. Default:
   * DUAL.
   */
  virtual void SetDepthTest(int test);
  vtkGetMacro(DepthTest, int);
  void SetDepthTestToDual() { this->SetDepthTest(DUAL); }
  void SetDepthTestToReceiverPlane() { this->SetDepthTest(RECEIVER_PLANE); }
  void SetDepthTestToConstantBias() { this->SetDepthTest(CONSTANT_BIAS); }
  ///@}

  ///@{
  /**
   * What the CONSTANT_BIAS test takes off, as a share of the scene's diagonal along the light; the other tests don't use it.
   * Clamped to 0 to 1; what is not a number is refused. Default: 0.002.
   */
  virtual void SetConstantBias(double share);
  vtkGetMacro(ConstantBias, double);
  ///@}

  ///@{
  /**
   * One of Rasterizations; any other value is refused with an error. What only VTK's own mappers can draw (glyphs,
   * imposters, cut-outs, clipped meshes) is not warped at all, whatever this says: it has a layer of its own, which is
   * focused and uniform. Default: AUTOMATIC.
   */
  virtual void SetRasterization(int rasterization);
  vtkGetMacro(Rasterization, int);
  void SetRasterizationToLinear() { this->SetRasterization(LINEAR); }
  void SetRasterizationToTessellated() { this->SetRasterization(TESSELLATED); }
  void SetRasterizationToExact() { this->SetRasterization(EXACT); }
  void SetRasterizationToAutomatic() { this->SetRasterization(AUTOMATIC); }
  ///@}

  ///@{
  /**
   * How long an edge of a tessellated triangle may be on the map, as a share of the map's side; an edge gets no more than 256 pieces.
   * The paper tries 0.05, 0.025 and 0.01 (its Table 3). Clamped to 0.001 to 1; what is not a number is refused with an error. Only
   * TESSELLATED uses it. Default: 0.025.
   */
  virtual void SetMaximumEdgeLength(double share);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /**
   * One of ViewSampleSources; any other value is refused with an error. PREVIOUS_FRAME saves a pass over the receivers; the
   * focus gets a margin of a twentieth, and maps are drawn once more when all stands still. After a cut (the first
   * frame, another size, a camera that has moved by more than a hundredth of the scene's diagonal, turned by more than 3 degrees or
   * zoomed by more than a twentieth), and in windows with several samples a pixel, a prepass takes its place. Default:
   * PREPASS.
   */
  virtual void SetViewSampleSource(int source);
  vtkGetMacro(ViewSampleSource, int);
  void SetViewSampleSourceToPrepass() { this->SetViewSampleSource(PREPASS); }
  void SetViewSampleSourceToPreviousFrame() { this->SetViewSampleSource(PREVIOUS_FRAME); }
  ///@}

  ///@{
  /**
   * One of LightPlaneTurns; any other value is refused with an error. A map whose columns or rows
   * lie along walls, roads and edges of what is seen has less error than one that is turned against
   * them.
   *
   * VIEW_ALIGNED lays the map's t axis along the image that the light has of the view's direction;
   * where the camera looks along the light, within half a degree, it is OFF. AUTOMATIC chooses, for
   * each light, among turns 11.25 degrees apart, of a rectilinear warp all that differ, and
   * VIEW_ALIGNED, by the formula of GetPredictedError(), on some of the samples and for a warp by
   * SQRT_DEMAND. A first frame waits for the GPU once to choose, and may draw its maps twice; after
   * that a better turn is taken a frame or two late, and only where it has a tenth less error, so
   * that it doesn't pop to and fro. When all stands still maps are drawn at most once more.
   * AUTOMATIC is OFF below OpenGL 4.3. MINIMAL_FRUSTUM lays the map along the smallest rectangle
   * around what is seen (Milet et al. 2015, section 3.2). Without FocusOnView that is what the
   * view's frustum and the scene's bounds have in common, as the light sees it: an exact rectangle,
   * found on the CPU with no view samples; where there is none it is OFF. With it, it is what the
   * samples take, of turns 2.8 degrees apart, that rectangle's and OFF: chosen on the GPU as
   * AUTOMATIC is, only where it has a tenth less area, and never where OFF has less. A
   * vtkPerspectiveShadowMapWarp always lies along the view, whatever is set. Default: OFF.
   */
  virtual void SetLightPlaneTurn(int turn);
  vtkGetMacro(LightPlaneTurn, int);
  void SetLightPlaneTurnToOff() { this->SetLightPlaneTurn(TURN_OFF); }
  void SetLightPlaneTurnToViewAligned() { this->SetLightPlaneTurn(TURN_VIEW_ALIGNED); }
  void SetLightPlaneTurnToAutomatic() { this->SetLightPlaneTurn(TURN_AUTOMATIC); }
  void SetLightPlaneTurnToMinimalFrustum() { this->SetLightPlaneTurn(TURN_MINIMAL_FRUSTUM); }
  ///@}

  ///@{
  /**
   * The side, in pixels, of a square of the view that gives one sample for the importance: another of its pixels from square
   * to square, whose demand is spread over what the square covers on the light plane, so that few samples do as well as
   * many. The focus has a sample of every square of 2 x 2 pixels at least, but for samples of the previous frame. Clamped to 1 to
   * 64. Default: 2.
   */
  vtkSetClampMacro(ViewSampleStride, int, 1, 64);
  vtkGetMacro(ViewSampleStride, int);
  ///@}

  ///@{
  /**
   * Whether layers are kept while nothing that they depend on changes. Default: on.
   */
  vtkSetMacro(Caching, bool);
  vtkGetMacro(Caching, bool);
  vtkBooleanMacro(Caching, bool);
  ///@}

  ///@{
  /**
   * Whether casters are left out of a layer that they can't reach, and of one with a non-orthogonal
   * warp those too, part by part, that lie behind all view samples there; not where the filter is
   * SOFT or something is shaded that has no view samples. The picture is the same, but
   * GetShadowMapImage() lacks them. Default: on.
   */
  vtkSetMacro(CullCasters, bool);
  vtkGetMacro(CullCasters, bool);
  vtkBooleanMacro(CullCasters, bool);
  ///@}

protected:
  vtkConfigurableShadowMapPass();
  ~vtkConfigurableShadowMapPass() override;

  bool FocusOnView = true;
  int Filter = BILINEAR;
  double FilterRadius = 2;
  bool FilterJitter = false;
  int DepthTest = DUAL;
  double ConstantBias = 0.002;
  int Rasterization = AUTOMATIC;
  double MaximumEdgeLength = 0.025;
  int LightPlaneTurn = TURN_OFF;
  int ViewSampleSource = PREPASS;
  int ViewSampleStride = 2;
  bool Caching = true;
  bool CullCasters = true;

private:
  vtkConfigurableShadowMapPass(const vtkConfigurableShadowMapPass&) = delete;
  void operator=(const vtkConfigurableShadowMapPass&) = delete;

  void SetShare(double& member, double share, double least, const char* property);
  bool Choose(int& member, int value, bool valid, const char* property, const char* choices);
};

#endif
