// SPDX-License-Identifier: BSD-3-Clause
#include "Passes/rtwRendererFlags.h"

#include "GL/rtwOpenGL.h"
#include "GL/rtwVTKCompatibility.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkFXAAOptions.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLState.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkSSAOPass.h"
#include "vtkTimeStamp.h"
#include "vtkTranslucentPass.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace rtw
{
namespace
{
// The pass of that kind that there is for a window while some flags hold it, or a new one around
// VTK's plain one. Those are counted apart from VTK's references: mappers keep one of each pass
// that they were last drawn in.
template <class Pass, class Make>
std::shared_ptr<Pass> OfWindow(vtkRenderWindow* window, Make make)
{
  static std::map<vtkRenderWindow*, std::weak_ptr<Pass>> known;
  std::shared_ptr<Pass> pass = known[window].lock();
  if (!pass)
  {
    for (auto at = known.begin(); at != known.end();)
    {
      at = at->second.expired() ? known.erase(at) : std::next(at);
    }
    pass = std::shared_ptr<Pass>(make(), [](Pass* made) { made->Delete(); });
    vtkNew<vtkTranslucentPass> translucent;
    pass->SetTranslucentPass(translucent);
    known[window] = pass;
  }
  return pass;
}

// Lets go of a pass. Whoever has it last releases what it has on the GPU: a released pass draws no
// more as it did.
template <class Pass>
void GiveUp(std::shared_ptr<Pass>& pass, vtkWindow* window)
{
  if (pass.use_count() == 1)
  {
    pass->ReleaseGraphicsResources(window);
  }
  pass.reset();
}

// A part of an assembly that has levels of detail chooses one when it is drawn, and can't be asked before.
bool MayBeTranslucent(vtkProp* prop)
{
  if (!prop->IsA("vtkAssembly"))
  {
    return prop->HasTranslucentPolygonalGeometry() != 0;
  }
  bool found = false;
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkProp* part = path->GetLastNode()->GetViewProp();
    found = found || part->IsA("vtkLODProp3D") || part->HasTranslucentPolygonalGeometry();
  }
  return found;
}
}

// VTK's pass draws wireframes as surfaces too, by changing their properties and changing them back: nothing that a frame
// after it would have to be drawn anew for.
class HiddenLinesStep : public vtkRenderPass
{
public:
  static HiddenLinesStep* New();
  vtkTypeMacro(HiddenLinesStep, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    std::vector<std::pair<vtkProperty*, vtkTimeStamp>> times;
    for (int i = 0; i < s->GetPropArrayCount(); ++i)
    {
      auto* actor = vtkActor::SafeDownCast(s->GetPropArray()[i]);
      if (actor && actor->GetProperty()->GetRepresentation() == VTK_WIREFRAME)
      {
        times.emplace_back(actor->GetProperty(), TimeOf(actor->GetProperty()));
      }
    }
    this->Pass->Render(s);
    this->NumberOfRenderedProps = this->Pass->GetNumberOfRenderedProps();
    for (const auto& [property, time] : times)
    {
      TimeOf(property) = time;
    }
  }

private:
  static vtkTimeStamp& TimeOf(vtkObject* object) { return object->*(&HiddenLinesStep::MTime); }

  vtkNew<vtkHiddenLineRemovalPass> Pass;
};
vtkStandardNewMacro(HiddenLinesStep);

// VTK's filter looks for the picture where the renderer has it in the window.
class FXAAStep : public vtkRenderPass
{
public:
  static FXAAStep* New();
  vtkTypeMacro(FXAAStep, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    auto* renderer = vtkOpenGLRenderer::SafeDownCast(s->GetRenderer());
    if (!renderer || !this->IsInPlace(renderer))
    {
      return;
    }
    if (vtkFXAAOptions* options = renderer->GetFXAAOptions())
    {
      this->Filter->UpdateConfiguration(options);
    }
    this->Filter->Execute(renderer);
  }

  void ReleaseGraphicsResources(vtkWindow*) override { this->Filter->ReleaseGraphicsResources(); }

private:
  bool IsInPlace(vtkOpenGLRenderer* renderer)
  {
    int drawn[4], place[4];
    renderer->GetState()->vtkglGetIntegerv(GL_VIEWPORT, drawn);
    renderer->GetTiledSizeAndOrigin(&place[2], &place[3], &place[0], &place[1]);
    const bool same = std::equal(drawn, drawn + 4, place);
    if (!same && !this->Warned)
    {
      this->Warned = true;
      vtkWarningMacro("leaves the renderer's UseFXAA out, because another pass draws its viewport elsewhere than in "
                      "the window; put a vtkOpenGLFXAAPass around that pass instead");
    }
    return same;
  }

  bool Warned = false;
  vtkNew<vtkOpenGLFXAAFilter> Filter;
};
vtkStandardNewMacro(FXAAStep);

RendererFlags::RendererFlags() = default;

RendererFlags::~RendererFlags() = default;

void RendererFlags::Begin(const vtkRenderState* s)
{
  const auto isDrawnByPass = [](vtkProp* prop) {
    vtkInformation* keys = prop->GetPropertyKeys();
    return keys && keys->Length(vtkOpenGLRenderPass::RenderPasses()) > 0;
  };
  vtkProp** props = s->GetPropArray();
  const int count = s->GetPropArrayCount();
  this->Inside = s->GetFrameBuffer() || std::any_of(props, props + count, isDrawnByPass);
  this->HidesLines = false;
  this->PeeledVolumes = false;
  this->HasTranslucent = std::any_of(props, props + count,
    [](vtkProp* prop) { return MayBeTranslucent(prop); });
}

vtkRenderPass* RendererFlags::DrawOpaque(const vtkRenderState* s, vtkRenderPass* opaque)
{
  this->HidesLines = opaque && s->GetRenderer()->GetUseHiddenLineRemoval() &&
    vtkHiddenLineRemovalPass::WireframePropsExist(s->GetPropArray(), s->GetPropArrayCount());
  return this->HidesLines ? this->HiddenLines.Get() : opaque;
}

vtkRenderPass* RendererFlags::AroundOpaque(const vtkRenderState* s, vtkRenderPass* step)
{
  vtkRenderer* renderer = s->GetRenderer();
  if (!step || this->HidesLines || !renderer->GetUseSSAO())
  {
    return step;
  }
  this->Occlusion->SetRadius(renderer->GetSSAORadius());
  this->Occlusion->SetBias(renderer->GetSSAOBias());
  this->Occlusion->SetKernelSize(renderer->GetSSAOKernelSize());
  this->Occlusion->SetBlur(renderer->GetSSAOBlur());
  this->Occlusion->SetDelegatePass(step);
  return this->Occlusion;
}

vtkRenderPass* RendererFlags::DrawTranslucent(
  const vtkRenderState* s, vtkRenderPass* translucent, vtkRenderPass* volumetric)
{
  if (!translucent || !this->HasTranslucent)
  {
    return nullptr;
  }
  if (s->GetRenderer()->GetUseDepthPeeling())
  {
    return this->Peel(s, volumetric);
  }
  return !this->Inside && BlendsInAnyOrder(s->GetRenderer()) ? this->Blend(s) : translucent;
}

vtkRenderPass* RendererFlags::Blend(const vtkRenderState* s)
{
  this->Blending = OfWindow<vtkOrderIndependentTranslucentPass>(
    s->GetRenderer()->GetRenderWindow(), [] { return vtkOrderIndependentTranslucentPass::New(); });
  return this->Blending.get();
}

vtkRenderPass* RendererFlags::Peel(const vtkRenderState* s, vtkRenderPass* volumetric)
{
  vtkRenderer* renderer = s->GetRenderer();
  this->Peeling = OfWindow<vtkDepthPeelingPass>(renderer->GetRenderWindow(), [renderer] {
    auto* drawn = vtkOpenGLRenderer::SafeDownCast(renderer);
    const bool dual = !drawn || drawn->IsDualDepthPeelingSupported();
    return dual ? vtkDualDepthPeelingPass::New() : vtkDepthPeelingPass::New();
  });
  this->Peeling->SetMaximumNumberOfPeels(renderer->GetMaximumNumberOfPeels());
  this->Peeling->SetOcclusionRatio(renderer->GetOcclusionRatio());
  if (auto* dual = vtkDualDepthPeelingPass::SafeDownCast(this->Peeling.get()))
  {
    this->PeeledVolumes = renderer->GetUseDepthPeelingForVolumes() && volumetric;
    dual->SetVolumetricPass(this->PeeledVolumes ? volumetric : nullptr);
  }
  return this->Peeling.get();
}

vtkRenderPass* RendererFlags::AfterTranslucent(const vtkRenderState* s)
{
  return s->GetRenderer()->GetUseFXAA() ? this->Smoothing.Get() : nullptr;
}

void RendererFlags::ReleaseGraphicsResources(vtkWindow* w)
{
  this->Occlusion->ReleaseGraphicsResources(w);
  this->Smoothing->ReleaseGraphicsResources(w);
  GiveUp(this->Blending, w);
  GiveUp(this->Peeling, w);
}
}
