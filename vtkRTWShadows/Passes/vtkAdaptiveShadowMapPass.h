// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveShadowMapPass
 * @brief   shadows by shadow maps that adapt to the view
 *
 * A vtkShadowMapPass that takes VTK's place: in the classic chain of baker and pass, or, for a
 * whole frame with translucency, volumes and overlays, in a vtkShadowRenderStepsPass. Directional
 * lights and spots (cones below 90°) cast shadows; all other lights shine as usual.
 *
 * A technique is a point in a space of independent axes: how what a light shines on is divided into
 * layers (SetPartition), and how the texels of a layer are spread (SetWarp). Subclasses are presets
 * that name one. This class by itself has one layer without a warp.
 *
 * There is nothing to tune: Resolution is the one number that trades time and memory for accuracy.
 *
 * @sa vtkUniformShadowMapPass vtkRTWShadowMapPass vtkShadowRenderStepsPass
 */
#ifndef vtkAdaptiveShadowMapPass_h
#define vtkAdaptiveShadowMapPass_h

#include "vtkConfigurableShadowMapPass.h"
#include "vtkNew.h"                // for the partition
#include "vtkRTWShadowsModule.h"   // for the export macro
#include "vtkSmartPointer.h"       // for the axes
#include "vtkTimeStamp.h"          // for the shader stage

#include <memory> // for the internals
#include <string> // for shader code

class vtkAdaptiveShadowMapBakerPass;
class vtkInformationIntegerKey;
class vtkLight;
class vtkMatrix4x4;
class vtkProp;
class vtkRenderer;
class vtkShadowMapPartition;
class vtkShadowMapWarp;

namespace rtw
{
struct LightFrame;
struct LookupOptions;
class MaskSource;
}

class VTKRTWSHADOWS_EXPORT vtkAdaptiveShadowMapPass : public vtkConfigurableShadowMapPass
{
public:
  static vtkAdaptiveShadowMapPass* New();
  vtkTypeMacro(vtkAdaptiveShadowMapPass, vtkConfigurableShadowMapPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The two axes of a technique. Neither may be null: that is refused with an error. Defaults: a vtkShadowMapPartition of
   * one layer and a vtkIdentityShadowMapWarp; presets set their own.
   */
  virtual void SetPartition(vtkShadowMapPartition* partition);
  virtual vtkShadowMapPartition* GetPartition();
  virtual void SetWarp(vtkShadowMapWarp* warp);
  virtual vtkShadowMapWarp* GetWarp();
  ///@}

  ///@{
  /**
   * Keys for the property keys of a prop (vtkProp::SetPropertyKeys()): whether it casts and whether
   * it receives shadows, 0 or 1. Default, for a prop without the key: 1.
   */
  static vtkInformationIntegerKey* CASTS_SHADOW();
  static vtkInformationIntegerKey* RECEIVES_SHADOW();
  ///@}

  ///@{
  /**
   * Counts of the last frame: lights with shadows; lights that are on and need no shadows, because
   * they are black, shine from the eye, or their shadows weigh nothing; layers drawn; and layers
   * kept because nothing had changed.
   */
  int GetNumberOfShadowLights();
  int GetNumberOfLightsSkipped();
  int GetNumberOfLayersDrawn();
  int GetNumberOfLayersReused();
  ///@}

  ///@{
  /**
   * Clusters of triangles that were drawn into a layer, and that were left out because they can't
   * reach what it holds, in the last frame in which the light's layers were drawn; without `layer`
   * the sum over all layers of the light. Waits for the GPU. 0 for a light or layer that there
   * isn't.
   */
  int GetNumberOfCastersDrawn(int light);
  int GetNumberOfCastersCulled(int light);
  int GetNumberOfCastersDrawn(int light, int layer);
  int GetNumberOfCastersCulled(int light, int layer);
  ///@}

  /**
   * A light's number among those with shadows in the last frame, which is how the methods of this
   * class count them. -1 for one that casts none, of which there are no shadows, before the first
   * frame, and for null. Lights are numbered in the renderer's order, so that the number may change
   * from frame to frame. What takes a number takes a vtkLight as well, and says of one that casts
   * no shadow what it says of a number that there isn't.
   */
  int GetShadowLightIndex(vtkLight* light);

  ///@{
  /**
   * The same as the methods of those names that take a light's number: see GetShadowLightIndex().
   */
  int GetNumberOfCastersDrawn(vtkLight* light);
  int GetNumberOfCastersCulled(vtkLight* light);
  int GetNumberOfCastersDrawn(vtkLight* light, int layer);
  int GetNumberOfCastersCulled(vtkLight* light, int layer);
  int GetNumberOfLightLayers(vtkLight* light);
  bool GetLayerDepthRange(vtkLight* light, int layer, double range[2]);
  double GetMaximumEffectiveResolution(vtkLight* light, int axis);
  vtkImageData* GetShadowMask(vtkLight* light);
  vtkImageData* GetShadowMapImage(vtkLight* light, int layer = 0);
  vtkImageData* GetWarpImage(vtkLight* light, int layer = 0);
  vtkImageData* GetImportanceImage(vtkLight* light, int layer = 0);
  vtkImageData* GetAliasingErrorImage(vtkLight* light);
  double GetPredictedError(vtkLight* light);
  bool GetLightPlaneMatrix(vtkLight* light, int layer, vtkMatrix4x4* worldToPlane);
  ///@}

  /**
   * Layers that a light has in the last frame: those of the partition or, where an OpenGL context
   * can't analyse the view, 1. 0 for a light that there isn't.
   */
  int GetNumberOfLightLayers(int light);

  /**
   * The distances along the view direction, in world units, from and up to which receivers were
   * looked up in a light's layer in the last frame. The first layer begins, and the last ends,
   * beyond all that can be seen. False, and nothing is changed, for a light or layer that there
   * isn't. Waits for the GPU.
   */
  bool GetLayerDepthRange(int light, int layer, double range[2]);

  /**
   * Bytes of GPU memory that shadow maps, warping maps and view samples take: in stereo, of both eyes. What else is asked
   * of the last frame is of the eye that was drawn last.
   */
  vtkTypeInt64 GetShadowMemory();

  /**
   * How often a mapper built a shader with this pass's code since it was made. A steady frame builds none.
   */
  vtkGetMacro(NumberOfShaderBuilds, int);

  /**
   * Texels that a side of a conventional map of everything a light shines on needs to be as fine as
   * this one at its finest (Rosen 2012, section 6): along s (axis 0) or t (1); of several layers,
   * the finest one's. 0 for a light or axis that there isn't. Waits for the GPU.
   */
  double GetMaximumEffectiveResolution(int light, int axis);

  ///@{
  /**
   * Whether the GPU's time is taken, stage by stage; results are those of the newest frame that the
   * GPU had finished when the last one began. Default: off.
   */
  void SetTimeStages(bool time);
  bool GetTimeStages();
  int GetNumberOfStages();
  const char* GetStageName(int stage); ///< null for a stage that there isn't
  double GetStageMilliseconds(int stage);
  ///@}

  /**
   * The shadow of a light, by its number among those with shadows, on each pixel of the last frame: 0 to 127 in
   * shadow, 129 to 255 lit, 128 where nothing opaque is, or what is there is turned away from the light or out of its reach.
   * The image is made anew for each call and belongs to the pass. Null before the first frame or for a light that
   * there isn't. Waits for the GPU.
   */
  vtkImageData* GetShadowMask(int light);

  /**
   * A light's shadow map, as depths of one float from 0, the near end of the scene, to 1. Null and lifetime as for
   * GetShadowMask.
   */
  vtkImageData* GetShadowMapImage(int light, int layer = 0);

  /**
   * A light's warping maps: a row of values at the borders of the cells along s, one along t. A
   * vtkNonOrthogonalShadowMapWarp gives two slices of such rows: a function along s for each row of
   * the light plane, and one along t for each column of the result. A vtkPerspectiveShadowMapWarp
   * gives its 3 x 3 matrix, row by row, which takes (s, t, 1) to homogeneous map coordinates. Null
   * and lifetime as for GetShadowMask.
   */
  vtkImageData* GetWarpImage(int light, int layer = 0);

  vtkImageData* GetImportanceImage(int light, int layer = 0) override;
  vtkImageData* GetAliasingErrorImage(int light) override;
  double GetPredictedError(int light) override;

  /**
   * The matrix from world coordinates to a light's map as it is before the warp of GetWarpImage(): s and t from 0 to 1
   * over the layer's focus, and depth. False, and nothing is changed, before the first frame or for a light or layer that
   * there isn't. Waits for the GPU.
   */
  bool GetLightPlaneMatrix(int light, int layer, vtkMatrix4x4* worldToPlane);

  /**
   * The baker has to be a vtkAdaptiveShadowMapBakerPass of no other pass; anything else is refused with an error.
   */
  void SetShadowMapBakerPass(vtkShadowMapBakerPass* baker) override;

  /**
   * Renders the opaque sequence with the shadows that the baker has prepared.
   */
  void Render(const vtkRenderState* s) override;

  /**
   * Renders another pass with those shadows on all props of the state.
   */
  void RenderShadowed(const vtkRenderState* s, vtkRenderPass* delegate);

  /**
   * Frees the OpenGL objects that were made for that window. The next frame makes new ones.
   */
  void ReleaseGraphicsResources(vtkWindow* w) override;

  ///@{
  /**
   * Called by mappers: puts the shadow lookup into their shaders, before and after VTK's own code.
   */
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  ///@}

  /**
   * Called by mappers: gives their shaders the parameters of the shadow lookup.
   */
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  /**
   * When the code that mappers' shaders get last changed: mappers built before build theirs anew.
   */
  vtkMTimeType GetShaderStageMTime() override;

protected:
  vtkAdaptiveShadowMapPass();
  ~vtkAdaptiveShadowMapPass() override;

#ifndef __VTK_WRAP__
  /**
   * The storage axis, for subclasses: what fills the mask instead of maps.
   */
  void SetMaskSource(std::unique_ptr<rtw::MaskSource> source);
#endif

  int NumberOfShaderBuilds = 0;
  vtkSmartPointer<vtkShadowMapPartition> Partition;
  vtkSmartPointer<vtkShadowMapWarp> Warp;

private:
  vtkAdaptiveShadowMapPass(const vtkAdaptiveShadowMapPass&) = delete;
  void operator=(const vtkAdaptiveShadowMapPass&) = delete;

  friend class vtkAdaptiveShadowMapBakerPass;
  class Internals;

  rtw::LookupOptions MakeLookupOptions();
  void Bake(const vtkRenderState* s);
  void UseEye(vtkRenderer* renderer);
  void UseEye(bool right);
  void DropRightEye(vtkWindow* w);
  void WarnOnce();
  void WarnOfProps();
  void WarnOfMaskSource();
  void RenderLit(const vtkRenderState* s, vtkRenderPass* delegate);
  int ChooseDebugLight();
  void PaintDebugView(vtkRenderer* renderer);
  void DrawCasters(vtkRenderer* renderer, int layer, const rtw::LightFrame& frame);
  void DrawViewSamples(vtkRenderer* renderer);

  std::unique_ptr<Internals> Shadows;  ///< of the eye that is drawn, or was drawn last
  std::unique_ptr<Internals> OtherEye; ///< while the window is in stereo
  vtkTimeStamp StageTime;
};

#endif
