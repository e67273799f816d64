// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveShadowMapPass.h"

#include "GL/rtwViewport.h"
#include "GL/rtwVTKCompatibility.h"
#include "LightPass/rtwMapperDrawing.h"
#include "Lookup/rtwModelPlace.h"
#include "Passes/rtwAdaptiveShadowMapInternals.h"
#include "Passes/rtwSelection.h"

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
#include <optional>
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

void vtkAdaptiveShadowMapPass::WarnOfProps()
{
  Internals& my = *this->Shadows;
  for (const rtw::SceneRefusal& refusal : my.FindNewRefusals())
  {
    vtkWarningMacro(<< rtw::NameOf(refusal.Prop) << " " << refusal.What
                    << "; where that is meant, set CASTS_SHADOW() and RECEIVES_SHADOW() of its property keys to 0");
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
  // Nobody sees that frame, and its window has no multisampling: the picture's shadows stay as they are.
  if (rtw::IsSelecting(renderer))
  {
    return;
  }
  this->UseEye(renderer);
  Internals& my = *this->Shadows;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  my.UseWarp(this->Warp);
  my.UsePartition(this->Partition);
  if (!my.Pipeline.SetContext(window))
  {
    return;
  }
  my.Window = window;
  if (my.TakeTurns(renderer) && !my.WarnedOfRenderers)
  {
    my.WarnedOfRenderers = true;
    vtkWarningMacro("serves several renderers by turns, and draws the shadows of each anew in every "
                    "frame; give each renderer a pass of its own");
  }
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
  this->WarnOfProps();

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
  // A pixel with several samples has no single depth.
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
  my.Options.SamplesAPixel = my.Options.Masked ? samples : 1;
  rtw::ReceiverShape shape{ my.Pipeline.GetShape(), {}, this->Filter, this->DepthTest,
    my.Pipeline.CountOtherLayers(my.Scene, lights * parts) > 0, parts,
    my.Pipeline.CountFaces(parts), my.Pipeline.BlendsLayers() };
  for (const rtw::ShadowLight& light : my.Lights.Shadowing)
  {
    shape.Switched.push_back(light.Switched);
  }
  my.Options.Shape = shape;
  my.FindCodes();
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
  if (rtw::RenderSelection(s))
  {
    return;
  }
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
  std::vector<vtkProp*> props(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  my.KeepShaded(props);
  Internals::Attachment attachment(my, this, props, rtw::Phase::Picture, 0);
  if (!attachment.IsComplete() && !my.WarnedOfUnits)
  {
    my.WarnedOfUnits = true;
    vtkWarningMacro("draws without shadows: no three texture units are free; use fewer textures at a time");
  }
  // Any other pass may leave props out, and then there would be holes; so would samples of another frame make.
  const bool isOpaque = !rtw::IsSelecting(s->GetRenderer()) &&
    (delegate == my.DefaultSequence || !std::strcmp(delegate->GetClassName(), "vtkOpaquePass"));
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
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  const Internals& my = *this->Shadows;
  const std::optional<rtw::SceneShading> shading = my.Scene.FindShading(mapper, prop);
  if (vtkPolyDataMapper::SafeDownCast(mapper) && shading)
  {
    ++this->NumberOfShaderBuilds;
    rtw::MarkPlaces(fragmentShader);
    if (my.MakeCode(false, shading->IsUnsampled).Way == rtw::Receiving::Sampled)
    {
      rtw::RequireSamples(fragmentShader);
    }
  }
  return true;
}

bool vtkAdaptiveShadowMapPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  const Internals& my = *this->Shadows;
  const std::optional<rtw::SceneShading> shading = my.Scene.FindShading(mapper, prop);
  if (vtkPolyDataMapper::SafeDownCast(mapper) && shading)
  {
    const rtw::ReceiverCode code = my.MakeCode(shading->DrawsItself, shading->IsUnsampled);
    rtw::InjectReceiver(
      { vertexShader, geometryShader, fragmentShader }, code.Shape, code.Way, code.DrawsItself);
  }
  return true;
}

namespace
{
// Flat lines and points have no side to be lit on; tubes and spheres are round.
bool HasSides(vtkActor* actor, rtw::MeshPrimitive primitive)
{
  vtkProperty* property = actor->GetProperty();
  const int drawn = property->GetRepresentation();
  if (drawn == VTK_POINTS || primitive == rtw::MeshPrimitive::Points)
  {
    return property->GetRenderPointsAsSpheres();
  }
  const bool isLines = drawn == VTK_WIREFRAME || primitive == rtw::MeshPrimitive::Lines;
  return !isLines || (property->GetRenderLinesAsTubes() && property->GetLineWidth() > 1);
}
}

bool vtkAdaptiveShadowMapPass::SetShaderParameters(vtkShaderProgram* program,
  vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject* array)
{
  if (!program->IsUniformUsed("rtwReceives"))
  {
    return true;
  }
  Internals& my = *this->Shadows;
  if (my.Uniforms.CurrentPhase == rtw::Phase::Picture)
  {
    // A pass between us and the mapper may draw elsewhere than where the view was.
    my.Uniforms.PlaceView(rtw::ViewportOf(my.Window), my.Pipeline.GetView());
  }
  my.Uniforms.Set(program);
  rtw::SetModelToView(program, mapper, prop, my.Pipeline.GetView());
  vtkInformation* keys = prop ? prop->GetPropertyKeys() : nullptr;
  auto* actor = vtkActor::SafeDownCast(prop);
  const bool receives = (!actor || HasSides(actor, rtw::PrimitiveOf(mapper, array))) &&
    (!keys || !keys->Has(RECEIVES_SHADOW()) || keys->Get(RECEIVES_SHADOW()) != 0);
  program->SetUniformi("rtwReceives", receives ? 1 : 0);
  return true;
}

vtkMTimeType vtkAdaptiveShadowMapPass::GetShaderStageMTime()
{
  return this->StageTime; // for good: other code is another object in the keys of props
}

void vtkAdaptiveShadowMapPass::ReleaseGraphicsResources(vtkWindow* w)
{
  this->DropRightEye(w);
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
