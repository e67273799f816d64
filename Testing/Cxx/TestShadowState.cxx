// SPDX-License-Identifier: BSD-3-Clause
// Whatever state OpenGL is in when a stage of ours begins, it is in when the stage ends, piece by
// piece, and what the stage finds out is what it finds in the usual state. VTK's record of the state
// stays true, and OpenGL has noted no error.
#include "rtwOddState.h"
#include "rtwShadowStage.h"
#include "rtwStateSnapshot.h"

#include "vtkAdaptiveShadowMapBakerPass.h"
#include "vtkCameraPass.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkSequencePass.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{
using Pass = vtkAdaptiveShadowMapPass;

// Does something in an odd state and in the usual one, and compares what OpenGL says before and
// after.
void Watch(vtkOpenGLRenderWindow* window, const std::string& name, bool odd,
  const std::function<void()>& act)
{
  RTW_CHECK_EQUAL(rtwTakeErrors(), std::string());
  std::unique_ptr<rtwOddState> state;
  if (odd)
  {
    state = std::make_unique<rtwOddState>(window);
  }
  const rtwStateSnapshot before;
  const std::string errors = rtwTakeErrors();
  act();
  const std::string failed = rtwTakeErrors();
  const std::string differences = before.DifferencesTo(rtwStateSnapshot());
  const std::string stale = rtwStaleRecords(window);
  rtwCheck(errors.empty(), __FILE__, __LINE__, "the test itself draws no errors:" + errors);
  rtwCheck(failed.empty(), __FILE__, __LINE__, name + " draws no errors:" + failed);
  rtwCheck(differences.empty(), __FILE__, __LINE__, name + " changes nothing:" + differences);
  rtwCheck(stale.empty(), __FILE__, __LINE__, name + " leaves VTK's record true:" + stale);
  state.reset();
  const std::string after = rtwTakeErrors();
  rtwCheck(after.empty(), __FILE__, __LINE__, "the test itself draws no errors at its end:" + after);
}

// Draws nothing, so that only our code lies between.
class NoPass : public vtkOpaquePass
{
public:
  static NoPass* New() { return new NoPass; }
  void Render(const vtkRenderState*) override { this->NumberOfRenderedProps = 0; }
};

class WatchedPass : public vtkRenderPass
{
public:
  static WatchedPass* New() { return new WatchedPass; }
  vtkTypeMacro(WatchedPass, vtkRenderPass);
  void Render(const vtkRenderState* s) override
  {
    auto* window =
      vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    Watch(window, *this->Name, this->Odd, [&] { this->Watched->Render(s); });
    this->NumberOfRenderedProps = this->Watched->GetNumberOfRenderedProps();
  }

  vtkSmartPointer<vtkRenderPass> Watched;
  const std::string* Name = nullptr;
  bool Odd = true;
};

// Objects under a sun and a spot; baker and pass are watched each frame.
class WatchedStage
{
public:
  explicit WatchedStage(rtwTechnique technique, const std::string& name, int samples = 0)
    : Stage(technique)
    , Name(name)
  {
    this->Stage.Name = name;
    this->Stage.Window->SetMultiSamples(samples);
    this->Stage.Window->SetSize(90, 60);
    this->Stage.AddObjects();
    this->Stage.AddSun(3, 5, 2);
    this->Stage.AddSpot(3, 7, 2, 40);
    this->Pass->SetResolution(64);
    this->Pass->SetOpaqueSequence(this->None);
    this->Baker->Watched = this->Pass->GetShadowMapBakerPass();
    this->Baker->Name = &this->BakerName;
    this->Shadows->Watched = this->Pass;
    this->Shadows->Name = &this->PassName;
    vtkNew<vtkRenderPassCollection> passes;
    passes->AddItem(this->Baker);
    passes->AddItem(this->Shadows);
    vtkNew<vtkSequencePass> sequence;
    sequence->SetPasses(passes);
    vtkNew<vtkCameraPass> chain;
    chain->SetDelegatePass(sequence);
    this->Stage.Renderer->SetPass(chain);
  }

  // A frame, in an odd state or the usual one.
  void Render(const std::string& what, bool odd = true)
  {
    this->BakerName = this->Name + ", " + what + ": baker";
    this->PassName = this->Name + ", " + what + ": pass";
    this->Baker->Odd = this->Shadows->Odd = odd;
    this->Stage.Render();
  }

  // A frame that draws all and one that is still; the masks are those of the usual state.
  void Check(const std::string& what)
  {
    this->Pass->SetCaching(false);
    this->Render(what + ", usual", false);
    this->Render(what + ", usual", false);
    const std::vector<unsigned char> usual = this->Stage.GetMask(0);
    RTW_CHECK(std::count(usual.begin(), usual.end(), 0) > 20);
    this->Render(what);
    this->Render(what);
    const std::vector<unsigned char> odd = this->Stage.GetMask(0);
    rtwCheck(usual == odd, __FILE__, __LINE__,
      this->Name + ", " + what + ": the mask doesn't depend on the state before");
    this->Pass->SetCaching(true);
    this->Render(what + ", to be still");
    this->Render(what + ", still");
  }

  void Look(const std::string& what, const std::function<void()>& look)
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Stage.Window);
    window->MakeCurrent();
    Watch(window, this->Name + ": " + what, true, look);
  }

  void CheckReadOuts();
  void CheckDebugViews();

  rtwShadowStage Stage;
  std::string Name, BakerName, PassName;
  vtkAdaptiveShadowMapPass* Pass = Stage.Pass;
  vtkNew<NoPass> None;
  vtkNew<WatchedPass> Baker, Shadows;
};

void WatchedStage::CheckReadOuts()
{
  vtkAdaptiveShadowMapPass* pass = this->Pass;
  vtkNew<vtkMatrix4x4> matrix;
  double range[2];
  this->Look("mask", [&] { RTW_CHECK(pass->GetShadowMask(0)); });
  this->Look("map", [&] { pass->GetShadowMapImage(1, 0); });
  this->Look("warp", [&] { RTW_CHECK(pass->GetWarpImage(1, 0)); });
  this->Look("importance", [&] { pass->GetImportanceImage(1, 0); });
  this->Look("aliasing error", [&] { RTW_CHECK(pass->GetAliasingErrorImage(1)); });
  this->Look("predicted error", [&] { RTW_CHECK(pass->GetPredictedError(1) >= 0); });
  this->Look("casters", [&] { RTW_CHECK(pass->GetNumberOfCastersDrawn(0) > 0); });
  this->Look("effective resolution",
    [&] { RTW_CHECK(pass->GetMaximumEffectiveResolution(0, 0) > 0); });
  this->Look("depth range", [&] { RTW_CHECK(pass->GetLayerDepthRange(0, 0, range)); });
  this->Look("light plane", [&] { RTW_CHECK(pass->GetLightPlaneMatrix(0, 0, matrix)); });
}

void WatchedStage::CheckDebugViews()
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

void TestTechnique(rtwTechnique technique, const std::string& name)
{
  WatchedStage watched(technique, name);
  watched.Render("first frame");
  watched.Check("frames");
  watched.CheckReadOuts();
  watched.CheckDebugViews();
}

void TestSamples(rtwTechnique technique, const std::string& name)
{
  WatchedStage watched(technique, name + ", 4 samples", 4);
  watched.Render("first frame");
  watched.Check("frames");
  watched.CheckReadOuts();
  watched.CheckDebugViews();
}

void TestSettings()
{
  WatchedStage watched(rtwTechnique::RTW, "rtw");
  watched.Pass->SetTimeStages(true);
  for (const int filter : { Pass::NEAREST, Pass::PCF, Pass::SOFT })
  {
    watched.Pass->SetFilter(filter);
    watched.Check("filter " + std::to_string(filter));
  }
  watched.Pass->SetFilter(Pass::BILINEAR);
  for (const int rasterization : { Pass::LINEAR, Pass::TESSELLATED, Pass::EXACT })
  {
    watched.Pass->SetRasterization(rasterization);
    watched.Check("rasterization " + std::to_string(rasterization));
  }
  watched.Pass->SetRasterization(Pass::AUTOMATIC);
  for (const int turn :
    { Pass::TURN_VIEW_ALIGNED, Pass::TURN_AUTOMATIC, Pass::TURN_MINIMAL_FRUSTUM })
  {
    watched.Pass->SetLightPlaneTurn(turn);
    watched.Check("turn " + std::to_string(turn));
  }
  watched.Pass->SetFocusOnView(false);
  watched.Check("unfocused");
}

void TestPreviousFrame(rtwTechnique technique, const std::string& name)
{
  WatchedStage watched(technique, name + ", previous frame");
  watched.Pass->SetViewSampleSource(Pass::PREVIOUS_FRAME);
  watched.Pass->SetCaching(false);
  for (int frame = 0; frame < 3; ++frame)
  {
    watched.Render("frame " + std::to_string(frame));
  }
  watched.CheckReadOuts();
}
}

int TestShadowState(int, char*[])
{
  {
    rtwShadowStage stage;
    stage.Render();
    if (!rtwCanTellState())
    {
      return rtwTestSkipped;
    }
  }
  const std::pair<rtwTechnique, const char*> techniques[] = {
    { rtwTechnique::Unfocused, "unfocused" }, { rtwTechnique::Uniform, "uniform" },
    { rtwTechnique::RTW, "rtw" }, { rtwTechnique::NoTW, "notw" },
    { rtwTechnique::Perspective, "perspective" }, { rtwTechnique::Cascades, "cascades" },
    { rtwTechnique::Exact, "exact" } };
  for (const auto& [technique, name] : techniques)
  {
    TestTechnique(technique, name);
  }
  TestSamples(rtwTechnique::RTW, "rtw");
  TestSamples(rtwTechnique::Exact, "exact");
  TestSettings();
  TestPreviousFrame(rtwTechnique::RTW, "rtw");
  TestPreviousFrame(rtwTechnique::Cascades, "cascades");
  return rtwTestResult();
}
