// SPDX-License-Identifier: BSD-3-Clause
#include "rtwWatchedStage.h"

#include "rtwOddState.h"
#include "rtwStateSnapshot.h"

#include "vtkAdaptiveShadowMapBakerPass.h"
#include "vtkCameraPass.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkSequencePass.h"

#include <memory>

namespace
{
using Pass = vtkAdaptiveShadowMapPass;

void CheckEmpty(const std::string& text, const std::string& what)
{
  rtwCheck(text.empty(), __FILE__, __LINE__, what + text);
}

// Does something and compares what OpenGL says before and after.
void Watch(vtkOpenGLRenderWindow* window, const std::string& name, bool odd,
  const std::function<void()>& act)
{
  CheckEmpty(rtwTakeErrors(), name + ", what was before makes no errors:");
  std::unique_ptr<rtwOddState> state;
  if (odd)
  {
    state = std::make_unique<rtwOddState>(window);
  }
  const rtwStateSnapshot before;
  CheckEmpty(rtwTakeErrors(), name + ", the test itself makes no errors:");
  act();
  CheckEmpty(rtwTakeErrors(), name + " makes no errors:");
  CheckEmpty(before.DifferencesTo(rtwStateSnapshot()), name + " changes nothing:");
  CheckEmpty(rtwStaleRecords(window), name + " leaves VTK's record true:");
  state.reset();
  CheckEmpty(rtwTakeErrors(), name + ", the test itself makes no errors at its end:");
}
}

// For our passes it is VTK's own.
class rtwNoPass : public vtkOpaquePass
{
public:
  static rtwNoPass* New() { VTK_STANDARD_NEW_BODY(rtwNoPass); }
  void Render(const vtkRenderState*) override { this->NumberOfRenderedProps = 0; }
};

class rtwWatchedPass : public vtkRenderPass
{
public:
  static rtwWatchedPass* New() { VTK_STANDARD_NEW_BODY(rtwWatchedPass); }
  vtkTypeMacro(rtwWatchedPass, vtkRenderPass);
  void Render(const vtkRenderState* s) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    Watch(window, this->Name, this->Odd, [&] { this->Watched->Render(s); });
    this->NumberOfRenderedProps = this->Watched->GetNumberOfRenderedProps();
  }

  vtkSmartPointer<vtkRenderPass> Watched;
  std::string Name;
  bool Odd = true;
};

rtwWatchedStage::rtwWatchedStage(rtwTechnique technique, const std::string& name, int samples)
  : Stage(technique)
  , Pass(Stage.Pass)
  , Name(name)
  , None(vtkSmartPointer<rtwNoPass>::New())
  , Baker(vtkSmartPointer<rtwWatchedPass>::New())
  , Shadows(vtkSmartPointer<rtwWatchedPass>::New())
{
  this->Stage.Name = name;
  this->Stage.Window->SetMultiSamples(samples);
  this->Stage.Window->SetSize(90, 60);
  this->Stage.AddObjects();
  this->Stage.AddSun(3, 5, 2);
  this->Stage.AddSpot(3, 7, 2, 40);
  this->Pass->SetResolution(128);
  this->Pass->SetOpaqueSequence(this->None);
  this->Baker->Watched = this->Pass->GetShadowMapBakerPass();
  this->Shadows->Watched = this->Pass;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(this->Baker);
  passes->AddItem(this->Shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> chain;
  chain->SetDelegatePass(sequence);
  this->Stage.Renderer->SetPass(chain);
}

rtwWatchedStage::~rtwWatchedStage() = default;

void rtwWatchedStage::Render(const std::string& what, bool odd)
{
  this->Baker->Name = this->Name + ", " + what + ": baker";
  this->Shadows->Name = this->Name + ", " + what + ": pass";
  this->Baker->Odd = this->Shadows->Odd = odd;
  this->Stage.Render();
}

void rtwWatchedStage::Look(const std::string& what, const std::function<void()>& look)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Stage.Window);
  window->MakeCurrent();
  Watch(window, this->Name + ": " + what, true, look);
}

void rtwWatchedStage::CheckReadOuts()
{
  vtkAdaptiveShadowMapPass* pass = this->Pass;
  vtkNew<vtkMatrix4x4> matrix;
  double range[2];
  this->Look("mask", [&] { RTW_CHECK(pass->GetShadowMask(0)); });
  this->Look("map", [&] { pass->GetShadowMapImage(1, 0); });
  this->Look("warp", [&] { RTW_CHECK(pass->GetWarpImage(1, 0)); });
  this->Look("importance", [&] { pass->GetImportanceImage(1, 0); });
  this->Look("aliasing error", [&] { RTW_CHECK(pass->GetAliasingErrorImage(1)); });
  this->Look("predicted error", [&] { pass->GetPredictedError(1); });
  this->Look("casters", [&] { pass->GetNumberOfCastersDrawn(0); });
  this->Look("effective resolution",
    [&] { RTW_CHECK(pass->GetMaximumEffectiveResolution(0, 0) > 0); });
  this->Look("depth range", [&] { RTW_CHECK(pass->GetLayerDepthRange(0, 0, range)); });
  this->Look("light plane", [&] { RTW_CHECK(pass->GetLightPlaneMatrix(0, 0, matrix)); });
}

void rtwWatchedStage::CheckDebugViews()
{
  for (const int view : { Pass::SHADOW, Pass::ALIASING_ERROR, Pass::IMPORTANCE, Pass::WARP_GRID,
         Pass::LAYERS, Pass::LIST_LENGTHS })
  {
    if (view != Pass::LIST_LENGTHS || this->Pass->IsA("vtkExactShadowMapPass"))
    {
      this->Pass->SetDebugView(view);
      this->Render("debug view " + std::to_string(view));
    }
  }
  this->Pass->SetDebugView(Pass::NONE);
}
