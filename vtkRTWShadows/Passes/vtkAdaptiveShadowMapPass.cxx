// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveShadowMapPass.h"

#include "rtwAdaptiveShadowMapInternals.h"
#include "rtwMapperDrawing.h"
#include "rtwModelPlace.h"

#include "vtkActor.h"
#include "vtkAdaptiveShadowMapBakerPass.h"
#include "vtkIdentityShadowMapWarp.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowMapPartition.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <utility>

vtkStandardNewMacro(vtkAdaptiveShadowMapPass);
vtkInformationKeyMacro(vtkAdaptiveShadowMapPass, CASTS_SHADOW, Integer);
vtkInformationKeyMacro(vtkAdaptiveShadowMapPass, RECEIVES_SHADOW, Integer);

vtkAdaptiveShadowMapPass::vtkAdaptiveShadowMapPass()
  : Partition(vtkSmartPointer<vtkShadowMapPartition>::New())
  , Warp(vtkSmartPointer<vtkIdentityShadowMapWarp>::New())
  , Shadows(new Internals)
{
  vtkNew<vtkAdaptiveShadowMapBakerPass> baker;
  this->SetShadowMapBakerPass(baker);
  this->Shadows->DefaultSequence = this->OpaqueSequence;
  this->StageTime.Modified();
}

vtkAdaptiveShadowMapPass::~vtkAdaptiveShadowMapPass()
{
  if (this->Shadows->Window)
  {
    this->ReleaseGraphicsResources(this->Shadows->Window);
  }
}

void vtkAdaptiveShadowMapPass::SetShadowMapBakerPass(vtkShadowMapBakerPass* baker)
{
  auto* ours = vtkAdaptiveShadowMapBakerPass::SafeDownCast(baker);
  if (!ours || (ours->ShadowMapPass && ours->ShadowMapPass != this))
  {
    vtkErrorMacro("SetShadowMapBakerPass("
      << (baker ? baker->GetClassName() : "null")
      << "): expected a vtkAdaptiveShadowMapBakerPass that serves no other pass; keeping the one that is set");
    return;
  }
  if (auto* old = vtkAdaptiveShadowMapBakerPass::SafeDownCast(this->ShadowMapBakerPass))
  {
    old->ShadowMapPass = nullptr;
  }
  this->Superclass::SetShadowMapBakerPass(ours);
  ours->ShadowMapPass = this;
}

void vtkAdaptiveShadowMapPass::WarnOnce()
{
  Internals& my = *this->Shadows;
  if (!my.Pipeline.HasOwnDrawing() && !my.WarnedOfContext)
  {
    my.WarnedOfContext = true;
    vtkWarningMacro("draws conventional shadow maps of the whole scene, because "
      << my.Pipeline.GetProblem() << "; a newer driver, or an OpenGL 4.3 context, gives all that was asked for");
  }
  if (my.Lights.Unsupported > 0 && !my.WarnedOfPointLights)
  {
    my.WarnedOfPointLights = true;
    vtkWarningMacro(<< my.Lights.Unsupported
                    << " positional light(s) with a cone of 90 degrees or more cast no shadows; make the cone narrower");
  }
  if (my.Lights.Broken > 0 && !my.WarnedOfBrokenLights)
  {
    my.WarnedOfBrokenLights = true;
    vtkWarningMacro(<< my.Lights.Broken
                    << " light(s) cast no shadows, because their position, focal point or cone is not a number, or the "
                       "first two are the same point; set them apart");
  }
}

void vtkAdaptiveShadowMapPass::WarnOfMaskSource()
{
  Internals& my = *this->Shadows;
  if (!my.Pipeline.GetSourceProblem().empty() && !my.WarnedOfSource)
  {
    my.WarnedOfSource = true;
    vtkWarningMacro("looks shadows up in maps, because the driver refused a shader: "
      << my.Pipeline.GetSourceProblem());
  }
  if (my.Pipeline.TakeIncomplete() && !my.WarnedOfMemoryBound)
  {
    my.WarnedOfMemoryBound = true;
    vtkWarningMacro("looked the shadows of a frame up in maps, because its tests outgrew their "
                    "memory bound; later frames have more of it");
  }
}

rtw::LookupOptions vtkAdaptiveShadowMapPass::MakeLookupOptions()
{
  constexpr double MostTexels = 8;
  rtw::LookupOptions options;
  options.Bias = this->ConstantBias;
  options.FilterJitter = this->FilterJitter;
  options.FilterWorld = this->Filter == SOFT ? this->FilterRadius : 0;
  options.FilterTexels = this->Filter == PCF ? std::min(this->FilterRadius, MostTexels) : 0;
  if (this->Filter == PCF && this->FilterRadius > MostTexels &&
    !this->Shadows->WarnedOfFilterRadius)
  {
    this->Shadows->WarnedOfFilterRadius = true;
    vtkWarningMacro("FilterRadius " << this->FilterRadius << " is more than PCF's largest; using "
                                    << MostTexels << " texels");
  }
  return options;
}

void vtkAdaptiveShadowMapPass::Bake(const vtkRenderState* s)
{
  vtkRenderer* renderer = s->GetRenderer();
  Internals& my = *this->Shadows;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  my.UseWarp(this->Warp);
  my.UsePartition(this->Partition);
  if (!my.Pipeline.SetContext(window))
  {
    return;
  }
  my.Window = window;
  my.Renderer = renderer;
  my.AwaitsDebugView = this->DebugView != NONE;
  renderer->UpdateLightsGeometryToFollowCamera();
  // Mappers that draw view samples look at them, and a classic chain lights nothing before.
  if (auto* lit = vtkOpenGLRenderer::SafeDownCast(renderer))
  {
    lit->UpdateLights();
  }
  my.Lights = rtw::CollectLights(renderer);
  my.Scene = rtw::CollectScene(
    renderer, { CASTS_SHADOW(), RECEIVES_SHADOW() }, my.Pipeline.HasOwnDrawing());
  this->WarnOnce();

  const std::size_t lights = my.Lights.Shadowing.size();
  const int parts = my.Pipeline.CountParts(lights);
  my.Options.Resolution = my.Pipeline.ClampResolution(this->GetResolution(), lights * parts);
  if (static_cast<unsigned int>(my.Options.Resolution) < this->GetResolution() &&
    !my.WarnedOfResolution)
  {
    my.WarnedOfResolution = true;
    vtkWarningMacro("Resolution " << this->GetResolution() << " is more than this GPU's textures hold; using "
                                  << my.Options.Resolution);
  }
  my.Options.ViewSampleStride = this->ViewSampleStride;
  // Of several samples a pixel there is no one depth.
  my.Options.PreviousFrame =
    this->ViewSampleSource == PREVIOUS_FRAME && window->GetMultiSamples() <= 1;
  my.Options.FocusOnView = this->FocusOnView;
  my.Options.Turn = static_cast<rtw::Turning>(this->LightPlaneTurn);
  my.Options.Viewer = renderer;
  my.Options.Caching = this->Caching;
  my.Options.Casters = { this->CullCasters, static_cast<rtw::Bending>(this->Rasterization),
    this->MaximumEdgeLength };
  my.Options.Lookup = this->MakeLookupOptions();
  // Samples of a pixel see other surfaces than its centre; without own programs a mask would cost a pass through VTK's mappers.
  const int samples = window->GetMultiSamples() <= 1 ? 1 : my.Pipeline.CountMaskSamples();
  my.Options.Masked = my.Pipeline.HasOwnDrawing() && samples > 0 && !my.Options.PreviousFrame;
  const int samplesBefore = my.Options.SamplesAPixel;
  my.Options.SamplesAPixel = my.Options.Masked ? samples : 1;
  rtw::ReceiverShape shape{ my.Pipeline.GetShape(), {}, this->Filter, this->DepthTest,
    my.Pipeline.CountOtherLayers(my.Scene, lights * parts) > 0, parts,
    my.Pipeline.CountFaces(parts), my.Pipeline.BlendsLayers() };
  for (const rtw::ShadowLight& light : my.Lights.Shadowing)
  {
    shape.Switched.push_back(light.Switched);
  }
  std::set<vtkProp*> drawn = rtw::ActorsOf(my.Scene.Props);
  std::set<vtkProp*> translucent = rtw::TranslucentActorsOf(my.Scene.Shaded);
  if (!(shape == my.Options.Shape) || drawn != my.DrawnByMappers || translucent != my.Translucent ||
    my.WasMasked != my.Options.Masked || (samplesBefore > 1) != (my.Options.SamplesAPixel > 1))
  {
    my.Options.Shape = shape;
    my.WasMasked = my.Options.Masked;
    my.DrawnByMappers = std::move(drawn);
    my.Translucent = std::move(translucent);
    this->StageTime.Modified();
  }
  my.Options.Signature = my.Sign(this->Warp->GetMTime(), this->Partition->GetMTime());
  my.Pipeline.Update(rtw::ViewOf(s), my.Scene, my.Lights.Shadowing, my.Options,
    { [this, renderer] { this->DrawViewSamples(renderer); },
      [this, renderer](int layer, const rtw::LightFrame& frame) {
        this->DrawCasters(renderer, layer, frame);
      } });
  this->WarnOfMaskSource();
}

void vtkAdaptiveShadowMapPass::DrawCasters(
  vtkRenderer* renderer, int layer, const rtw::LightFrame& frame)
{
  Internals& my = *this->Shadows;
  Internals::Attachment attachment(my, this, my.Scene.Shaded, rtw::Phase::LightPass, layer);
  if (attachment.IsComplete())
  {
    rtw::DrawMapperCasters(renderer, my.Scene.Props, frame);
  }
}

void vtkAdaptiveShadowMapPass::DrawViewSamples(vtkRenderer* renderer)
{
  Internals& my = *this->Shadows;
  Internals::Attachment attachment(my, this, my.Scene.Shaded, rtw::Phase::ViewSamples, 0);
  if (attachment.IsComplete())
  {
    rtw::DrawMapperSamples(renderer, my.Scene.Props, my.Pipeline.GetView());
  }
}

void vtkAdaptiveShadowMapPass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  if (!this->OpaqueSequence)
  {
    vtkWarningMacro("has no OpaqueSequence and renders nothing; set one");
    return;
  }
  this->RenderShadowed(s, this->OpaqueSequence);
}

void vtkAdaptiveShadowMapPass::RenderShadowed(const vtkRenderState* s, vtkRenderPass* delegate)
{
  Internals& my = *this->Shadows;
  // Without a bake for this renderer there are no maps that fit.
  if (my.Pipeline.GetFrames().empty() || my.Renderer != s->GetRenderer())
  {
    delegate->Render(s);
  }
  else
  {
    this->RenderLit(s, delegate);
    if (my.AwaitsDebugView)
    {
      my.AwaitsDebugView = false;
      this->PaintDebugView(s->GetRenderer());
    }
  }
  this->NumberOfRenderedProps += delegate->GetNumberOfRenderedProps();
}

void vtkAdaptiveShadowMapPass::RenderLit(const vtkRenderState* s, vtkRenderPass* delegate)
{
  Internals& my = *this->Shadows;
  const std::vector<vtkProp*> props(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  Internals::Attachment attachment(my, this, props, rtw::Phase::Picture, 0);
  if (!attachment.IsComplete() && !my.WarnedOfUnits)
  {
    my.WarnedOfUnits = true;
    vtkWarningMacro("draws without shadows: no three texture units are free; use fewer textures at a time");
  }
  // Any other pass may leave props out, and then there would be holes.
  const bool isOpaque =
    delegate == my.DefaultSequence || !std::strcmp(delegate->GetClassName(), "vtkOpaquePass");
  if (isOpaque)
  {
    my.Pipeline.PrimeDepth(my.Scene, my.Options);
  }
  delegate->Render(s);
  if (isOpaque)
  {
    my.Pipeline.CaptureFrame(my.Options);
  }
}

bool vtkAdaptiveShadowMapPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (vtkPolyDataMapper::SafeDownCast(mapper))
  {
    ++this->NumberOfShaderBuilds;
    rtw::MarkPlaces(fragmentShader);
    if (this->Shadows->Options.SamplesAPixel > 1)
    {
      rtw::RequireSamples(fragmentShader);
    }
  }
  return true;
}

bool vtkAdaptiveShadowMapPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  if (vtkPolyDataMapper::SafeDownCast(mapper))
  {
    const Internals& my = *this->Shadows;
    rtw::Receiving receiving = rtw::Receiving::Direct;
    if (my.Options.Masked && my.Translucent.count(prop) == 0)
    {
      receiving = my.Options.SamplesAPixel > 1 ? rtw::Receiving::Sampled : rtw::Receiving::Masked;
    }
    rtw::InjectReceiver({ vertexShader, geometryShader, fragmentShader }, my.Options.Shape,
      receiving, my.DrawnByMappers.count(prop) > 0);
  }
  return true;
}

bool vtkAdaptiveShadowMapPass::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  this->Shadows->Uniforms.Set(program);
  rtw::SetModelToView(program, mapper, prop, this->Shadows->Pipeline.GetView());
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  // The lines and points that a surface is drawn by have no side to be lit on.
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool isSurface = !actor || actor->GetProperty()->GetRepresentation() == VTK_SURFACE;
  const bool receives = isSurface &&
    (!keys || !keys->Has(RECEIVES_SHADOW()) || keys->Get(RECEIVES_SHADOW()) != 0);
  program->SetUniformi("rtwReceives", receives ? 1 : 0);
  return true;
}

vtkMTimeType vtkAdaptiveShadowMapPass::GetShaderStageMTime()
{
  return this->StageTime;
}

void vtkAdaptiveShadowMapPass::ReleaseGraphicsResources(vtkWindow* w)
{
  Internals& my = *this->Shadows;
  if (auto* window = vtkOpenGLRenderWindow::SafeDownCast(w))
  {
    my.Pipeline.Release(window);
  }
  my.Window = nullptr;
  if (this->OpaqueSequence)
  {
    this->OpaqueSequence->ReleaseGraphicsResources(w);
  }
}
