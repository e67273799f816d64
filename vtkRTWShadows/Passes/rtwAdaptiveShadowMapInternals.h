// SPDX-License-Identifier: BSD-3-Clause
// What a vtkAdaptiveShadowMapPass keeps from its users.
#ifndef rtwAdaptiveShadowMapInternals_h
#define rtwAdaptiveShadowMapInternals_h

#include "rtwImages.h"
#include "rtwLightCollector.h"
#include "rtwReceiverCode.h"
#include "rtwFrameScene.h"
#include "rtwShadowPipeline.h"

#include "vtkAdaptiveShadowMapPass.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <set>
#include <vector>

class vtkAdaptiveShadowMapPass::Internals
{
public:
  rtw::ShadowPipeline Pipeline;
  rtw::PipelineOptions Options;
  rtw::ReceiverUniforms Uniforms;
  rtw::LightCollection Lights;
  rtw::FrameScene Scene;
  /// Of which only addresses are used: the actors of Scene.Props, and those that have translucent parts.
  std::set<vtkProp*> DrawnByMappers, Translucent;
  /// Of the code of props, by whether it is one of DrawnByMappers and one of Translucent.
  vtkSmartPointer<rtw::ReceiverCodePass> Codes[2][2];
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkWeakPointer<vtkRenderer> Renderer; ///< that the last bake was for
  vtkWeakPointer<vtkRenderer> OtherRenderer; ///< that one was for before
  vtkSmartPointer<vtkShadowMapWarp> Warp; ///< that the pipeline uses; kept alive for its stage
  vtkSmartPointer<vtkShadowMapPartition> Partition; ///< likewise
  vtkSmartPointer<vtkImageData> MaskImage, MapImage, WarpImage, ImportanceImage, AliasingImage;
  vtkRenderPass* DefaultSequence = nullptr; ///< only compared with
  bool AwaitsDebugView = false; ///< of what is drawn next, the first since the bake
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
  int WarnedOfDebugLight = -1; ///< which

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
  /// With the shape that the options have.
  rtw::ReceiverCode MakeCode(bool drawnByMappers, bool translucent) const;
  void FindCodes();
  /// True where it comes back to a renderer after another one.
  bool TakeTurns(vtkRenderer* renderer);

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
    rtw::ReceiverCodePass::Answering Answering;
    std::vector<vtkProp*> Props;
    std::vector<vtkSmartPointer<rtw::ReceiverCodePass>> Codes; ///< one a prop
    std::vector<int> Units;
    std::size_t Needed;
  };
};

#endif
