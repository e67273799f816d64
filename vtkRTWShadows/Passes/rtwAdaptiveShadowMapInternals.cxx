// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/rtwAdaptiveShadowMapInternals.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkProp.h"
#include "vtkShadowMapPartition.h"
#include "vtkShadowMapWarp.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace
{
bool HasPass(vtkInformation* keys, vtkObjectBase* pass)
{
  vtkInformationObjectBaseVectorKey* const passes = vtkOpenGLRenderPass::RenderPasses();
  const int length = keys->Has(passes) ? passes->Length(keys) : 0;
  for (int i = 0; i < length; ++i)
  {
    if (passes->Get(keys, i) == pass)
    {
      return true;
    }
  }
  return false;
}
}

bool vtkAdaptiveShadowMapPass::Internals::MakeCurrent()
{
  if (!this->Window)
  {
    return false;
  }
  this->Window->MakeCurrent();
  return this->Window->IsCurrent();
}

void vtkAdaptiveShadowMapPass::Internals::UseWarp(vtkShadowMapWarp* warp)
{
  if (this->Warp != warp)
  {
    // The old stage asks the old warp for its settings, so it is retired first.
    this->Pipeline.SetWarp(warp->MakeStage());
    this->Warp = warp;
  }
}

void vtkAdaptiveShadowMapPass::Internals::UsePartition(vtkShadowMapPartition* partition)
{
  if (this->Partition != partition)
  {
    this->Pipeline.SetPartition(partition->MakeStage());
    this->Partition = partition;
  }
}

void vtkAdaptiveShadowMapPass::Internals::KeepShaded(std::vector<vtkProp*>& props) const
{
  std::vector<vtkProp*> shaded = this->Scene.Shaded;
  std::sort(shaded.begin(), shaded.end());
  const auto isOther = [&shaded](vtkProp* prop) {
    return !std::binary_search(shaded.begin(), shaded.end(), prop);
  };
  props.erase(std::remove_if(props.begin(), props.end(), isOther), props.end());
}

std::vector<rtw::SceneRefusal> vtkAdaptiveShadowMapPass::Internals::FindNewRefusals()
{
  for (auto at = this->Refused.begin(); at != this->Refused.end();)
  {
    at = at->second ? std::next(at) : this->Refused.erase(at);
  }
  std::vector<rtw::SceneRefusal> found;
  for (const rtw::SceneRefusal& refusal : this->Scene.Refusals)
  {
    if (this->Refused.emplace(refusal.Prop, refusal.Prop).second)
    {
      found.push_back(refusal);
    }
  }
  return found;
}

std::uint64_t vtkAdaptiveShadowMapPass::Internals::Sign(
  vtkMTimeType warpTime, vtkMTimeType partitionTime) const
{
  const rtw::PipelineOptions& o = this->Options;
  std::uint64_t signature = rtw::Mix(std::uint64_t(1), std::uint64_t(warpTime));
  signature = rtw::Mix(signature, std::uint64_t(partitionTime));
  signature = rtw::Mix(signature, std::uint64_t(o.Resolution));
  signature = rtw::Mix(signature, std::uint64_t(o.ViewSampleStride));
  signature = rtw::Mix(signature, std::uint64_t(o.SamplesAPixel));
  signature = rtw::Mix(signature, std::uint64_t(o.Shape.Filter));
  signature = rtw::Mix(rtw::Mix(signature, std::uint64_t(o.Shape.DepthTest)), o.Lookup.Bias);
  signature = rtw::Mix(rtw::Mix(signature, o.Lookup.FilterTexels), o.Lookup.FilterWorld);
  signature = rtw::Mix(signature, o.Casters.EdgeLength);
  return rtw::Mix(signature,
    std::uint64_t(o.FocusOnView) | std::uint64_t(o.Casters.Cull) << 1 | std::uint64_t(o.Masked) << 2 |
      std::uint64_t(o.PreviousFrame) << 3 | std::uint64_t(o.Lookup.FilterJitter) << 4 |
      std::uint64_t(o.Casters.Bends) << 8);
}

rtw::ReceiverCode vtkAdaptiveShadowMapPass::Internals::MakeCode(
  bool drawsItself, bool unsampled) const
{
  rtw::Receiving way = rtw::Receiving::Direct;
  if (this->Options.Masked && !unsampled)
  {
    way = this->Options.SamplesAPixel > 1 ? rtw::Receiving::Sampled : rtw::Receiving::Masked;
  }
  return rtw::ReceiverCode::Make(this->Options.Shape, way, drawsItself);
}

bool vtkAdaptiveShadowMapPass::Internals::TakeTurns(vtkRenderer* renderer)
{
  const bool isBack = this->Renderer != renderer && this->OtherRenderer == renderer;
  if (this->Renderer != renderer)
  {
    this->OtherRenderer = this->Renderer;
    this->Renderer = renderer;
  }
  return isBack;
}

namespace
{
// The only kind of shading that parts with the same keys have; null where they have several kinds.
const bool* OnlyOneOf(const rtw::KeyShadings& shadings)
{
  const bool* const first = &shadings.Has[0][0];
  const bool isOne = !shadings.IsMixed && std::count(first, first + 4, true) == 1;
  return isOne ? std::find(first, first + 4, true) : nullptr;
}

std::string NameOf(const rtw::KeyShadings& shadings)
{
  std::string name = shadings.IsMixed ? "some of:" : "all of:";
  for (const bool has : { shadings.Has[0][0], shadings.Has[0][1], shadings.Has[1][0], shadings.Has[1][1] })
  {
    name += has ? '1' : '0';
  }
  return name;
}
}

void vtkAdaptiveShadowMapPass::Internals::FindCodes()
{
  std::string names;
  for (const bool drawsItself : { false, true })
  {
    for (const bool unsampled : { false, true })
    {
      const std::string name = this->MakeCode(drawsItself, unsampled).GetName();
      this->Codes[drawsItself][unsampled] = rtw::ReceiverCodePass::Of(name);
      names += name + "; ";
    }
  }
  std::map<std::string, vtkSmartPointer<rtw::ReceiverCodePass>> mixed;
  for (const auto& [keys, shadings] : this->Scene.Keys)
  {
    if (!OnlyOneOf(shadings))
    {
      const std::string name = NameOf(shadings);
      mixed[name] = rtw::ReceiverCodePass::Of(names + name);
    }
  }
  this->MixedCodes = std::move(mixed);
}

vtkSmartPointer<rtw::ReceiverCodePass> vtkAdaptiveShadowMapPass::Internals::CodeOf(
  const vtkObjectBase* keys) const
{
  const auto found = this->Scene.Keys.find(keys);
  if (found == this->Scene.Keys.end())
  {
    return this->Codes[0][0];
  }
  if (const bool* const only = OnlyOneOf(found->second))
  {
    const auto index = only - &found->second.Has[0][0];
    return this->Codes[index / 2][index % 2];
  }
  return this->MixedCodes.at(NameOf(found->second));
}

vtkAdaptiveShadowMapPass::Internals::Attachment::Attachment(Internals& internals, vtkAdaptiveShadowMapPass* pass,
  const std::vector<vtkProp*>& props, rtw::Phase phase, int layer)
  : My(internals)
  , Answering(pass)
{
  vtkTextureUnitManager* manager = this->My.Window->GetTextureUnitManager();
  const bool hasGrid = this->My.Pipeline.GetShape().Kind == rtw::WarpKind::Grid;
  const bool hasSamples = this->My.Options.SamplesAPixel > 1;
  this->Needed = std::size_t(4) + (hasGrid ? 1 : 0) + (hasSamples ? 2 : 0);
  while (this->Units.size() < this->Needed)
  {
    const int unit = manager->Allocate();
    if (unit < 0)
    {
      return;
    }
    this->Units.push_back(unit);
  }
  if (phase != rtw::Phase::Picture)
  {
    this->Alone.emplace(props);
  }
  this->My.Uniforms = this->My.Pipeline.MakeUniforms(this->My.Options);
  rtw::ReceiverUniforms& uniforms = this->My.Uniforms;
  const std::vector<rtw::LightFrame>& frames = this->My.Pipeline.GetLayerFrames();
  uniforms.CurrentPhase = phase;
  uniforms.Layer = layer;
  uniforms.LightParallel =
    frames[layer % frames.size()].Light.Kind == rtw::LightKind::Directional;
  uniforms.WarpUnit = this->Units[0];
  uniforms.DepthUnit = this->Units[1];
  uniforms.GradientUnit = this->Units[2];
  uniforms.MaskUnit = this->Units[3];
  uniforms.GridUnit = this->Units.back();
  uniforms.BitsUnit = this->Units[hasSamples ? 4 : 3];
  uniforms.ManyUnit = this->Units[hasSamples ? 5 : 3];
  {
    const rtw::StateRecord::Scope taking(&this->Bound);
    this->My.Pipeline.BindTextures(uniforms, phase == rtw::Phase::Picture);
  }
  for (vtkProp* prop : props)
  {
    vtkInformation* keys = prop->GetPropertyKeys();
    if (!keys)
    {
      keys = vtkInformation::New();
      prop->SetPropertyKeys(keys);
      keys->FastDelete();
    }
    // Props may share theirs, and shader code would be put in twice.
    const vtkSmartPointer<rtw::ReceiverCodePass> code = this->My.CodeOf(keys);
    if (!HasPass(keys, code))
    {
      keys->Append(vtkOpenGLRenderPass::RenderPasses(), code);
      this->Keys.push_back({ keys, code });
    }
  }
}

vtkAdaptiveShadowMapPass::Internals::Attachment::~Attachment()
{
  vtkTextureUnitManager* manager = this->My.Window->GetTextureUnitManager();
  if (this->IsComplete())
  {
    this->Bound.GiveBack();
    for (const Attached& attached : this->Keys)
    {
      vtkInformation* keys = attached.Keys;
      keys->Remove(vtkOpenGLRenderPass::RenderPasses(), attached.Code);
      if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
      {
        keys->Remove(vtkOpenGLRenderPass::RenderPasses());
      }
    }
  }
  for (const int unit : this->Units)
  {
    manager->Free(unit);
  }
}
