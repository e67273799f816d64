// SPDX-License-Identifier: BSD-3-Clause
// What a vtkAdaptiveShadowMapPass keeps from its users.
#ifndef rtwAdaptiveShadowMapInternals_h
#define rtwAdaptiveShadowMapInternals_h

#include "Frame/rtwFrameScene.h"
#include "GL/rtwStateRecord.h"
#include "Inspect/rtwImages.h"
#include "Light/rtwLightCollector.h"
#include "Passes/rtwDetachment.h"
#include "Passes/rtwReceiverCode.h"
#include "Passes/rtwShadowPipeline.h"

#include "vtkAdaptiveShadowMapPass.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <map>
#include <optional>
#include <vector>

namespace rtw
{
/// Warnings that have been given, so that each is given only once.
struct Warnings
{
  bool WarnedOfContext = false;
  bool WarnedOfPointLights = false;
  bool WarnedOfBrokenLights = false;
  bool WarnedOfResolution = false;
  bool WarnedOfUnits = false;
  bool WarnedOfRenderers = false;
  bool WarnedOfFilterRadius = false;
  bool WarnedOfDebugShader = false;
  bool WarnedOfSource = false;
  bool WarnedOfMemoryBound = false;
  int WarnedOfDebugLight = -1;                 ///< the number that was warned of
  vtkWeakPointer<vtkLight> WarnedOfNamedLight; ///< the vtkLight that was warned of
};
}

/// The state of one eye: a still pair is recognised like any still frame, since each eye has what
/// it drew last.
class vtkAdaptiveShadowMapPass::Internals : public rtw::Warnings
{
public:
  Internals() = default;
  /// Makes the state of the right eye beside the left one's.
  explicit Internals(const Internals* left);
  const bool RightEye = false;
  rtw::ShadowPipeline Pipeline;
  rtw::PipelineOptions Options;
  rtw::ReceiverUniforms Uniforms;
  rtw::LightCollection Lights;
  rtw::FrameScene Scene;
  /// The passes that stand for the code of props, by whether these draw themselves and whether they
  /// are unsampled.
  vtkSmartPointer<rtw::ReceiverCodePass> Codes[2][2];
  /// The passes for props whose parts have different code, by the names of all of it.
  std::map<std::string, vtkSmartPointer<rtw::ReceiverCodePass>> MixedCodes;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkWeakPointer<vtkRenderer> Renderer;      ///< the renderer that the last bake was for
  vtkWeakPointer<vtkRenderer> OtherRenderer; ///< the renderer that the bakes before were for
  /// The warp that the pipeline uses; kept alive for its stage.
  vtkSmartPointer<vtkShadowMapWarp> Warp;
  vtkSmartPointer<vtkShadowMapPartition> Partition; ///< the same for the partition
  vtkSmartPointer<vtkImageData> MaskImage, MapImage, WarpImage, ImportanceImage, AliasingImage;
  vtkRenderPass* DefaultSequence = nullptr; ///< only compared with
  /// Props whose refusals have been reported, as long as they live.
  std::map<vtkProp*, vtkWeakPointer<vtkProp>> Refused;
  bool AwaitsDebugView = false; ///< of what is drawn next, the first since the bake

  bool Has(int light) const
  {
    return light >= 0 && light < static_cast<int>(this->Pipeline.GetFrames().size());
  }
  /// A light's layer among all; negative for one that there isn't.
  int LayerOf(int light, int layer) const
  {
    const bool exists =
      this->Has(light) && layer >= 0 && layer < this->Pipeline.GetLayerFrames()[0].Parts;
    return exists ? light * this->Pipeline.GetLayerFrames()[0].Parts + layer : -1;
  }
  /// Takes out the props that Scene doesn't shade.
  void KeepShaded(std::vector<vtkProp*>& props) const;
  /// The refusals of props that were in none of the answers before.
  std::vector<rtw::SceneRefusal> FindNewRefusals();
  bool MakeCurrent();
  void UseWarp(vtkShadowMapWarp* warp);
  void UsePartition(vtkShadowMapPartition* partition);
  std::uint64_t Sign(vtkMTimeType warpTime, vtkMTimeType partitionTime) const;
  /// The code of mappers, with the shape that the options have.
  rtw::ReceiverCode MakeCode(bool drawsItself, bool unsampled) const;
  /// Finds the passes that stand for the code of the scene's props, once the options are known.
  void FindCodes();
  /// The pass that stands for the code of what draws with such keys.
  vtkSmartPointer<rtw::ReceiverCodePass> CodeOf(const vtkObjectBase* keys) const;
  /// True where it comes back to a renderer after another one.
  bool TakeTurns(vtkRenderer* renderer);

  /// While one lives, the mappers of those props draw with the pass's code, in that phase, and the maps are bound.
  class Attachment
  {
  public:
    Attachment(Internals& internals, vtkAdaptiveShadowMapPass* pass,
      const std::vector<vtkProp*>& props, rtw::Phase phase, int layer);
    ~Attachment();
    Attachment(const Attachment&) = delete;
    Attachment& operator=(const Attachment&) = delete;
    /// False where no texture units were free; nothing is attached then.
    bool IsComplete() const { return this->Units.size() == this->Needed; }

  private:
    Internals& My;
    rtw::ReceiverCodePass::Answering Answering;
    struct Attached
    {
      vtkSmartPointer<vtkInformation> Keys;
      vtkSmartPointer<rtw::ReceiverCodePass> Code;
    };
    std::vector<Attached> Keys;
    std::optional<rtw::Detachment> Alone; ///< where it isn't the picture that is drawn
    std::vector<int> Units;
    std::size_t Needed;
    rtw::StateRecord Bound;
  };
};

#endif
