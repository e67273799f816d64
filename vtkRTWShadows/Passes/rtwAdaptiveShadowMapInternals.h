// SPDX-License-Identifier: BSD-3-Clause
// What a vtkAdaptiveShadowMapPass keeps from its users.
#ifndef rtwAdaptiveShadowMapInternals_h
#define rtwAdaptiveShadowMapInternals_h

#include "rtwDetachment.h"
#include "rtwImages.h"
#include "rtwLightCollector.h"
#include "rtwReceiverShader.h"
#include "rtwFrameScene.h"
#include "rtwShadowPipeline.h"

#include "vtkAdaptiveShadowMapPass.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <optional>
#include <set>
#include <vector>

namespace rtw
{
/// What has been said once.
struct Warnings
{
  bool WarnedOfContext = false;
  bool WarnedOfPointLights = false;
  bool WarnedOfBrokenLights = false;
  bool WarnedOfResolution = false;
  bool WarnedOfUnits = false;
  bool WarnedOfFilterRadius = false;
  bool WarnedOfDebugShader = false;
  bool WarnedOfSource = false;
  bool WarnedOfMemoryBound = false;
  int WarnedOfDebugLight = -1; ///< which
};
}

/// Of one eye: a still pair is recognised like any still frame, since each eye has what it drew last.
class vtkAdaptiveShadowMapPass::Internals : public rtw::Warnings
{
public:
  Internals() = default;
  /// For the right eye, beside the left.
  explicit Internals(const Internals* left);
  const bool RightEye = false;
  rtw::ShadowPipeline Pipeline;
  rtw::PipelineOptions Options;
  rtw::ReceiverUniforms Uniforms;
  rtw::LightCollection Lights;
  rtw::FrameScene Scene;
  /// Of which only addresses are used: the actors of Scene.Props, and those that have translucent parts.
  std::set<vtkProp*> DrawnByMappers, Translucent;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkWeakPointer<vtkRenderer> Renderer; ///< that the last bake was for
  vtkSmartPointer<vtkShadowMapWarp> Warp; ///< that the pipeline uses; kept alive for its stage
  vtkSmartPointer<vtkShadowMapPartition> Partition; ///< likewise
  vtkSmartPointer<vtkImageData> MaskImage, MapImage, WarpImage, ImportanceImage, AliasingImage;
  vtkRenderPass* DefaultSequence = nullptr; ///< only compared with
  bool WasMasked = false;
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
  bool MakeCurrent();
  void UseWarp(vtkShadowMapWarp* warp);
  void UsePartition(vtkShadowMapPartition* partition);
  std::uint64_t Sign(vtkMTimeType warpTime, vtkMTimeType partitionTime) const;

  /// While one lives, the mappers of those props draw with the pass's code, in that phase, and the maps are bound.
  class Attachment
  {
  public:
    Attachment(Internals& internals, vtkAdaptiveShadowMapPass* pass, std::vector<vtkProp*> props,
      rtw::Phase phase, int layer);
    ~Attachment();
    Attachment(const Attachment&) = delete;
    Attachment& operator=(const Attachment&) = delete;
    /// False where no texture units were free; nothing is attached then.
    bool IsComplete() const { return this->Units.size() == this->Needed; }

  private:
    Internals& My;
    vtkAdaptiveShadowMapPass* Pass;
    std::vector<vtkProp*> Props;
    std::optional<rtw::Detachment> Alone; ///< where it isn't the picture that is drawn
    std::vector<int> Units;
    std::size_t Needed;
  };
};

#endif
