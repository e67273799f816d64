// SPDX-License-Identifier: BSD-3-Clause
// One way through the house: view samples, light frames, focus, warp, light pass. Owns each stage's
// GPU resources.
#ifndef rtwShadowPipeline_h
#define rtwShadowPipeline_h

#include "Frame/rtwFrameScene.h"
#include "Frame/rtwGeometryStore.h"
#include "Frame/rtwStatistics.h"
#include "Frame/rtwView.h"
#include "Frame/rtwViewSampler.h"
#include "GL/rtwCapabilities.h"
#include "GL/rtwResources.h"
#include "GL/rtwStageTimers.h"
#include "Inspect/rtwDebugStage.h"
#include "Inspect/rtwErrorPrediction.h"
#include "Layers/rtwDenseLayers.h"
#include "Layers/rtwFocus.h"
#include "Layers/rtwLayerTable.h"
#include "Light/rtwLightTurning.h"
#include "Light/rtwMinimalFrustum.h"
#include "LightPass/Culling/rtwDeepestSamples.h"
#include "LightPass/rtwCasterDrawing.h"
#include "LightPass/rtwLightImages.h"
#include "Lookup/rtwMaskStage.h"
#include "Lookup/rtwReceiverShader.h"
#include "Lookup/rtwSplitChoice.h"
#include "Partition/rtwPartitionStage.h"
#include "Storage/rtwMaskSource.h"
#include "Warp/rtwWarpStage.h"

#include "vtkWeakPointer.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;

namespace rtw
{
class StateGuard;

struct PipelineOptions
{
  int Resolution = 1024;
  int ViewSampleStride = 2;
  bool PreviousFrame = false; ///< whether view samples may come from it
  bool FocusOnView = true;
  Turning Turn = Turning::Off;
  const void* Viewer = nullptr; ///< who looks, only compared with others
  bool Caching = true;
  CasterOptions Casters;
  LookupOptions Lookup;
  ReceiverShape Shape;
  int SamplesAPixel = 1;       ///< that view samples have, and the mask knows
  bool Masked = true;          ///< whether the picture takes its shadows from the mask
  std::uint64_t Signature = 0; ///< of all settings, the warp's among them
};

/// What only VTK's mappers can draw, drawn into the target that is bound.
struct MapperDrawing
{
  std::function<void()> ViewSamples;
  std::function<void(int layer, const LightFrame& frame)>
    Casters; ///< layer is that of the warp table
};

class ShadowPipeline
{
public:
  ShadowPipeline();
  /// For another view of what `main` draws in the same context: the two share the scene's meshes and the mask source,
  /// which stay `main`'s. It is to go before `main` releases them, and before that draws in another context.
  explicit ShadowPipeline(const ShadowPipeline* main);
  ~ShadowPipeline();
  ShadowPipeline(const ShadowPipeline&) = delete;
  ShadowPipeline& operator=(const ShadowPipeline&) = delete;

  /// Uses that warp, or that partition, from now on.
  void SetWarp(std::unique_ptr<WarpStage> warp);
  void SetPartition(std::unique_ptr<PartitionStage> partition);
  /// Fills the mask by that, from now on.
  void SetMaskSource(std::unique_ptr<MaskSource> source);
  /// Whether the mask of the last frame is that source's.
  bool IsMaskBySource() const { return this->HasMask && this->MaskedBySource; }
  /// Why it isn't, where the driver refused it.
  const std::string& GetSourceProblem() const { return this->SourceProblem; }
  /// Whether a frame since the last call asked too much of the source.
  bool TakeIncomplete();
  /// Whether it draws in the window's context.
  bool IsOf(vtkOpenGLRenderWindow* window) const;
  /// Takes note of the window's context; all that belonged to another is forgotten. False where
  /// nothing can be drawn.
  bool SetContext(vtkOpenGLRenderWindow* window);
  /// Whether the context can analyse the view and draw casters by our own programs. Where not, why
  /// is in GetProblem().
  bool HasOwnDrawing() const { return this->OwnDrawing; }
  const std::string& GetProblem() const { return this->Problem; }

  /// Brings all layers up to date. False where there is nothing to be shadowed.
  bool Update(const View& view, const FrameScene& scene, const std::vector<ShadowLight>& lights,
    const PipelineOptions& options, const MapperDrawing& mappers);

  /// How many samples each pixel of the target that is bound has, where a mask source can tell them
  /// apart; 1 also where there is one; 0 where the mask can't know them.
  int CountMaskSamples() const;

  /// Keeps the depth of what has been drawn, for the next frame's view samples.
  void CaptureFrame(const PipelineOptions& options);

  /// Lets the view samples stand in for the depth of what is drawn next, where they are complete:
  /// what they hide isn't shaded.
  void PrimeDepth(const FrameScene& scene, const PipelineOptions& options);

  const std::vector<LightFrame>& GetFrames() const { return this->Frames; }
  /// One a layer; those of a light stand together.
  const std::vector<LightFrame>& GetLayerFrames() const { return this->LayerFrames; }
  /// How many layers each of so many lights gets, those of casters that mappers draw aside.
  int CountParts(std::size_t lights) const;
  /// Of so many layers, how many have the same depths.
  int CountFaces(int parts) const;
  bool BlendsLayers() const { return this->Partition->Blends(); }
  const View& GetView() const { return this->Viewed; }
  const DenseLayers& GetLayers() const { return this->Layers; }
  /// Whether the last frame drew the lights' own layers.
  bool HasOwnLayers() const { return this->HasMaps; }
  const LayerTable& GetTable() const { return this->Table; }
  WarpShape GetShape() const;
  /// What a receiver's shaders need to know.
  ReceiverUniforms MakeUniforms(const PipelineOptions& options) const;
  /// Binds the table, and the maps and the mask unless maps are drawn into, to texture units.
  void BindTextures(const ReceiverUniforms& units, bool maps) const;
  /// To the largest maps of so many layers that the GPU allows.
  int ClampResolution(unsigned int resolution, std::size_t layers) const;
  StageTimers& GetTimers() { return this->Timers; }
  /// By how many layers those of casters that mappers draw lie behind the lights' own; 0 where they
  /// share them.
  int GetOtherLayers() const { return this->OtherLayers; }
  /// Of each light, where that is how its plane is turned; it sets the turns.
  /// The turns.
  std::vector<double> FindMinimalFrusta(
    const FrameScene& scene, const std::vector<ShadowLight>& lights, Turning turn);
  /// Whether such layers are needed for a scene.
  int CountOtherLayers(const FrameScene& scene, std::size_t layers) const;
  /// The mask of the last frame; made now, where the picture didn't need it.
  const Texture& GetMask(
    const PipelineOptions& options, const std::function<void()>& mapperSamples);
  /// A debug view of a light over the opaque receivers that are drawn in the target and viewport
  /// that are bound. False, with the reason in GetDebugLog(), where the driver can't.
  bool PaintDebugView(DebugView view, int light, const PipelineOptions& options,
    const std::function<void()>& mapperSamples);
  /// The aliasing error of each pixel of the last frame along s and t. False likewise.
  bool MeasureAliasing(int light, Texture& error, const std::function<void()>& mapperSamples);
  std::string GetDebugLog() const { return this->Debugging.GetLog() + this->Masking.GetLog(); }
  /// Of each cell along s, then along t, as collected and as used; empty where there is none.
  std::vector<float> ReadImportance(int layer) const;
  /// The share of the pixels that face a light, of the last frame, whose shadow is predicted to be
  /// wrong; negative where that is not known. Waits for the GPU.
  double PredictError(
    int light, const PipelineOptions& options, const std::function<void()>& mapperSamples);
  const Statistics& GetStatistics() const { return this->Counted; }
  CasterCounts ReadCasterCounts(int layer) const;
  /// From and up to which distance along the view a layer is looked up. Waits for the GPU.
  glm::dvec2 ReadInterval(int layer) const;
  /// Texels a side along s and t. Waits for the GPU.
  glm::dvec2 ReadMaximumEffectiveResolution(int layer) const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  bool Build();
  Turning TurningOf(const PipelineOptions& options) const;
  bool HasUniformTable() const { return this->Can.FastUniforms && this->Table.FitsUniforms(); }
  void Dispose(Disposal dispose);
  void DisposeOfRetired(Disposal dispose);
  void PlaceReceivers(ReceiverUniforms& uniforms) const;
  static View FrameView(const View& view, const FrameScene& scene);
  LightFrame MakeFrame(const FrameScene& scene, const ShadowLight& light, double turn) const;
  void MakeFrames(const FrameScene& scene, const std::vector<ShadowLight>& lights);
  int CountLayers() const { return static_cast<int>(this->LayerFrames.size()); }
  static Rectangle UnsampledReceivers(
    const FrameScene& scene, const LightFrame& frame, double beyond);
  std::vector<Rectangle> UnsampledReceiversOfAll(const FrameScene& scene, double beyond) const;
  std::uint64_t Sign(const FrameScene& scene, const std::vector<ShadowLight>& lights,
    const PipelineOptions& options) const;
  void Draw(const FrameScene& scene, const std::vector<ShadowLight>& lights,
    const PipelineOptions& options, const MapperDrawing& mappers, bool still);
  void DrawViewSamples(StateGuard& guard, const std::function<void()>& mapperSamples);
  void DrawMask(const PipelineOptions& options);
  void DrawLayers(StateGuard& guard, const FrameScene& scene, const PipelineOptions& options,
    const MapperDrawing& mappers, bool own);
  bool UsesSource(const PipelineOptions& options) const;
  MaskJob MakeJob(const ReceiverLights& lights, const PipelineOptions& options) const;
  bool PaintLists(int light, const PipelineOptions& options);
  bool DrawMaskBySource(StateGuard& guard, const FrameScene& scene, const PipelineOptions& options,
    const MapperDrawing& mappers);
  void CompleteViewSamples(const std::function<void()>& mapperSamples);
  MapOfLight MapOf(int light) const;
  void DrawMaps(StateGuard& guard, const FrameScene& scene, const PipelineOptions& options,
    const MapperDrawing& mappers, const Texture* lastMask, bool still);
  void AskForTurns(const FrameScene& scene, const PipelineOptions& options, const Texture* mask);
  Rectangle WithoutSamples(std::size_t light, const FilterReach& reach) const;
  FilterReach GetReach(const PipelineOptions& options) const;
  BoundedSamples GetBounded(const PipelineOptions& options) const;
  void BoundSamples(const PipelineOptions& options);
  PartitionInput MakePartitionInput(const PipelineOptions& options) const;
  void Split(const PipelineOptions& options);
  void FindFocus(const FrameScene& scene, const PipelineOptions& options);
  bool DrawLightImages(
    StateGuard& guard, const PipelineOptions& options, const MapperDrawing& mappers);
  void RunWarp(const FrameScene& scene, const PipelineOptions& options, bool hasImages,
    const Texture* lastMask);
  const DeepestSamples* FindDeepest(
    const LightFrame& frame, const FrameScene& scene, const PipelineOptions& options);
  void DrawLayer(StateGuard& guard, int layer, const FrameScene& scene,
    const PipelineOptions& options, const MapperDrawing& mappers, bool own);
  bool CanSplit(const PipelineOptions& options) const;
  glm::ivec2 ChooseMapSize(const FrameScene& scene, const PipelineOptions& options) const;
  void AllocateMaps(const FrameScene& scene, const PipelineOptions& options);
  void AskForSplit(const PipelineOptions& options);
  bool NeedsViewSamples(const PipelineOptions& options) const;
  bool ResampleLastFrame(const PipelineOptions& options);
  /// Of the samples in use: resampling leaves out the others.
  static constexpr double DepthRounding = 2e-6; // of the scene's size
  // At most of the samples that the focus looks at: one that misses nothing between sparse samples is
  // much too wide in deep views.
  static constexpr int FocusStride = 2;
  int GetStride(const PipelineOptions& options) const
  {
    const int kept = this->Resampled ? std::min(options.ViewSampleStride, FocusStride) : 1;
    return options.ViewSampleStride / kept;
  }

  int GetFocusStride(const PipelineOptions& options) const
  {
    return this->Resampled ? 1 : std::min(options.ViewSampleStride, FocusStride);
  }

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  std::uint64_t ContextTime = 0;
  bool Stale = true; ///< whether programs have to be built
  Capabilities Can;
  bool OwnDrawing = false;
  std::string Problem;
  std::unique_ptr<WarpStage> Warp, Fallback;
  std::unique_ptr<PartitionStage> Partition;
  std::shared_ptr<MaskSource> Source; ///< none where maps fill the mask
  std::string SourceProblem;
  /// Stages that others have replaced, for their context to be current again. They are run no more:
  /// who answered for their settings may be gone.
  std::vector<std::shared_ptr<ResourceOwner>> Retired;
  bool MaskedBySource = false;
  bool Incomplete = false;
  bool HasMaps = false; ///< of the last frame
  std::shared_ptr<GeometryStore> SharedStore;
  GeometryStore& Store;
  bool OwnsShared = true; ///< the store and the mask source
  ViewSampler Sampler;
  LastFrame Last;
  bool Resampled = false; ///< whether the analysis looks at the last frame
  bool Settled = true;    ///< false where that frame shows something else than this one
  LightTurning Turns;
  /// What the view can show, of each light; empty where it isn't asked for, or nothing.
  std::vector<std::optional<Rectangle>> Minimal;
  std::vector<double> DrawnTurns; ///< of the layers as they are
  FocusStage Focus;
  CasterDrawing Casters;
  SplitChoice Splits;
  double DrawnRatio = 1; ///< of texels along s and t
  DeepestSamples Deepest;
  LightImages Images;
  MaskStage Masking;
  DebugStage Debugging;
  ErrorPrediction Prediction;
  int OtherLayers = 0; ///< unwarped, behind the lights' own: of casters that mappers draw, whose
                       ///< edges can't be warped
  int SamplesAPixel = 1;
  bool HasSamples = false; ///< of the last frame
  bool HasMask = false;
  View Masked; ///< what the mask is of
  DenseLayers Layers;
  LayerTable Table;
  StageTimers Timers;
  Statistics Counted;
  View Viewed;
  std::vector<LightFrame> Frames, LayerFrames;
  double SceneSize = 0;
  std::uint64_t LastSignature = 0;
};
}

#endif
