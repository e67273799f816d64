// SPDX-License-Identifier: BSD-3-Clause
// Nonsense is refused, or drawn as well as can be, with one message and no crash.
#include "rtwShadowStage.h"

#include "vtkAdaptiveShadowMapBakerPass.h"
#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkCellArray.h"
#include "vtkExecutive.h"
#include "vtkIdentityShadowMapWarp.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRectilinearShadowMapWarp.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPartition.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <functional>
#include <limits>

namespace
{
const double NotANumber = std::numeric_limits<double>::quiet_NaN();

bool IsAnythingDrawn(vtkRenderWindow* window)
{
  const vtkSmartPointer<vtkImageData> picture = rtwGrab(window);
  const int* size = picture->GetDimensions();
  int drawn = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      drawn += rtwPixel(picture, x, y)[0] > 20;
    }
  }
  return drawn > size[0] * size[1] / 10;
}

// A light that is broken leaves the other's shadow; it is said once.
void TestLight(const char* name, const std::function<void(vtkLight*)>& breakIt, bool spot)
{
  rtwShadowStage stage;
  stage.Name = name;
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkLight* broken = spot ? stage.AddSpot(-3, 6, 2) : stage.AddSun(-3, 6, 2);
  broken->SetIntensity(0.2);
  breakIt(broken);
  rtwMessageCatcher messages(stage.Pass);
  stage.Render();
  stage.Render();
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 0);
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShadowLights(), 1);
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

void TestLights()
{
  TestLight(
    "position that is no number", [](vtkLight* light) { light->SetPosition(NotANumber, 5, 2); },
    false);
  TestLight(
    "focal point that is no number",
    [](vtkLight* light) { light->SetFocalPoint(0, NotANumber, 2); }, true);
  TestLight(
    "infinite position", [](vtkLight* light) { light->SetPosition(INFINITY, 5, 2); }, true);
  TestLight(
    "focal point at the position",
    [](vtkLight* light) { light->SetFocalPoint(light->GetPosition()); }, false);
  TestLight(
    "cone that is no number", [](vtkLight* light) { light->SetConeAngle(NotANumber); }, true);
  TestLight(
    "cone of nothing", [](vtkLight* light) { light->SetConeAngle(0); }, true);
  TestLight(
    "cone below nothing", [](vtkLight* light) { light->SetConeAngle(-20); }, true);
}

void TestCamera()
{
  rtwShadowStage stage;
  stage.Name = "camera";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(NotANumber, 0, 9);
  stage.Window->Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 0);
  camera->SetPosition(1, 6, 9);
  camera->SetFocalPoint(1, 6, 9);
  stage.Window->Render();
  camera->SetFocalPoint(0, 0.5, 0);
  camera->SetViewUp(0, 1, 0);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

// Nothing there, things without data, and windows without pixels.
void TestNothing()
{
  rtwShadowStage stage;
  stage.Name = "nothing";
  stage.Window->Render();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Window->Render();
  RTW_CHECK(stage.Pass->GetShadowMask(0) == nullptr);
  RTW_CHECK(stage.Pass->GetShadowMask(-1) == nullptr);
  RTW_CHECK(stage.Pass->GetShadowMapImage(0) == nullptr);
  RTW_CHECK(stage.Pass->GetWarpImage(7) == nullptr);
  RTW_CHECK_EQUAL(stage.Pass->GetMaximumEffectiveResolution(0, 0), 0);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfCastersDrawn(3), 0);

  vtkNew<vtkActor> bare;
  stage.Renderer->AddActor(bare);
  stage.Window->Render();
  vtkNew<vtkPolyData> empty;
  stage.Add(empty);
  vtkNew<vtkPolyData> pointless;
  vtkNew<vtkPoints> points;
  pointless->SetPoints(points);
  stage.Add(pointless);
  stage.Window->Render();
  stage.AddObjects();
  stage.Name = "beside nothing";
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

void TestMapperWithoutInput()
{
  rtwShadowStage stage;
  stage.Name = "mapper without input";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  // VTK itself complains about it.
  rtwMessageCatcher messages(mapper), executive(mapper->GetExecutive());
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 1);
  stage.Renderer->RemoveActor(actor);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

void TestWindow()
{
  rtwShadowStage stage;
  stage.Name = "window";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Window->SetSize(1, 1);
  stage.Render();
  stage.Renderer->SetViewport(0.5, 0.5, 0.5, 0.5);
  stage.Render();
  stage.Renderer->SetViewport(0, 0, 1, 1);
  stage.Window->SetSize(300, 200);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

// Points that are no numbers, and cells that name points that there aren't: the rest of the mesh
// stays.
void TestMesh()
{
  rtwShadowStage stage;
  stage.Name = "points that are no numbers";
  stage.AddFloor();
  vtkNew<vtkSphereSource> source;
  source->SetCenter(0, 1.4, 0);
  source->SetRadius(1);
  source->SetThetaResolution(24);
  source->SetPhiResolution(24);
  source->Update();
  vtkNew<vtkPolyData> good, bad;
  good->DeepCopy(source->GetOutput());
  bad->DeepCopy(good);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(bad->GetPoints());
  vtkIdType triangle[] = { 0, points->InsertNextPoint(NotANumber, 1, 1), 1 };
  bad->SetPoints(points);
  bad->GetPolys()->InsertNextCell(3, triangle);
  bad->GetPointData()->Initialize();
  good->GetPointData()->Initialize();
  stage.SetStandIn(stage.Add(bad), good);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
}

void TestSettings()
{
  rtwShadowStage stage;
  stage.Name = "settings";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkAdaptiveShadowMapPass* pass = stage.Pass;
  {
    rtwMessageCatcher baker(pass->GetShadowMapBakerPass());
    pass->SetResolution(300);
    pass->SetResolution(0);
    RTW_CHECK_EQUAL(baker.GetNumberOfErrors(), 1);
    RTW_CHECK_EQUAL(pass->GetResolution(), 300u);
    pass->SetResolution(1024);
  }
  {
    rtwMessageCatcher messages(pass);
    int expected = 0;
    const auto refused = [&](const char* what) {
      ++expected;
      rtwCheck(messages.GetNumberOfErrors() == expected, __FILE__, __LINE__, what);
    };
    pass->SetFilter(7);
    refused("SetFilter(7)");
    pass->SetFilter(-1);
    refused("SetFilter(-1)");
    for (const double radius : { NotANumber, -1.0, double(INFINITY), 1e31 })
    {
      pass->SetFilterRadius(radius);
      refused("SetFilterRadius out of range");
    }
    pass->SetDepthTest(3);
    refused("SetDepthTest(3)");
    pass->SetRasterization(4);
    refused("SetRasterization(4)");
    pass->SetMaximumEdgeLength(NotANumber);
    refused("SetMaximumEdgeLength(nan)");
    pass->SetViewSampleSource(2);
    refused("SetViewSampleSource(2)");
    pass->SetConstantBias(NotANumber);
    refused("SetConstantBias(nan)");
    pass->SetWarp(nullptr);
    refused("SetWarp(nullptr)");
    pass->SetPartition(nullptr);
    refused("SetPartition(nullptr)");
    vtkNew<vtkShadowMapBakerPass> foreign;
    pass->SetShadowMapBakerPass(foreign);
    refused("a foreign baker");
    pass->SetShadowMapBakerPass(nullptr);
    refused("no baker");
    const auto other = rtwMakePass(rtwTechnique::Uniform);
    pass->SetShadowMapBakerPass(other->GetShadowMapBakerPass());
    refused("the baker of another pass");
    RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 0);
  }
  RTW_CHECK_EQUAL(pass->GetFilter(), int(vtkAdaptiveShadowMapPass::BILINEAR));
  RTW_CHECK_EQUAL(pass->GetFilterRadius(), 2.0);
  RTW_CHECK_EQUAL(pass->GetDepthTest(), int(vtkAdaptiveShadowMapPass::DUAL));
  RTW_CHECK_EQUAL(pass->GetViewSampleSource(), int(vtkAdaptiveShadowMapPass::PREPASS));
  RTW_CHECK(pass->GetWarp() != nullptr);
  RTW_CHECK(pass->GetPartition() != nullptr);
  RTW_CHECK(pass->GetShadowMapBakerPass() != nullptr);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);

  vtkNew<vtkRectilinearShadowMapWarp> warp;
  rtwMessageCatcher messages(warp);
  warp->SetImportance(0);
  warp->SetImportance(512);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 2);
  RTW_CHECK_EQUAL(warp->GetImportance(), int(vtkRectilinearShadowMapWarp::SQRT_DEMAND));
  warp->SetBlurSigma(NotANumber);
  warp->SetImportanceFloor(NotANumber);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 4);
  RTW_CHECK_EQUAL(warp->GetBlurSigma(), 3.0);
}

// More texels than PCF looks at are as good as the most; that is said once. SOFT takes any width.
void TestLargeFilterRadius()
{
  rtwShadowStage stage(rtwTechnique::Uniform);
  stage.AddObjects();
  stage.AddSun(3, 5, 2);
  stage.Pass->SetFilterRadius(20);
  rtwMessageCatcher messages(stage.Pass);
  stage.Render();
  stage.Pass->SetFilterToSoft();
  stage.Render();
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 0);
  stage.Pass->SetFilterToPCF();
  stage.Render();
  const std::vector<unsigned char> clamped = stage.GetMask(0);
  stage.Pass->SetFilterRadius(8);
  stage.Render();
  RTW_CHECK(stage.GetMask(0) == clamped);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 0);
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
  RTW_CHECK(messages.GetText().find("FilterRadius 20") != std::string::npos);
}

// More than the GPU can do; clamping is said once. In a scene without objects nothing so large is
// made.
void TestHugeResolution(unsigned int resolution)
{
  rtwShadowStage stage(rtwTechnique::Uniform);
  stage.Pass->SetResolution(resolution);
  stage.AddSun(3, 5, 2);
  rtwMessageCatcher messages(stage.Pass);
  stage.Window->Render();
  stage.Window->Render();
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 0);
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
  RTW_CHECK(messages.GetText().find(std::to_string(resolution)) != std::string::npos);
}

// A baker whose pass is gone bakes nothing and says so; the scene is drawn.
void TestLostBaker()
{
  rtwShadowStage stage;
  stage.AddObjects();
  stage.AddSun(3, 5, 2);
  vtkNew<vtkAdaptiveShadowMapBakerPass> alone;
  rtwMessageCatcher messages(alone);
  auto chain = rtwMakeClassicChain(stage.Pass);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(alone);
  passes->AddItem(stage.Pass);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkCameraPass::SafeDownCast(chain)->SetDelegatePass(sequence);
  stage.Renderer->SetPass(chain);
  stage.Render();
  stage.Render();
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 0);
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
  RTW_CHECK(IsAnythingDrawn(stage.Window));
}
}

int TestShadowBadInput(int, char*[])
{
  TestLights();
  TestCamera();
  TestNothing();
  TestMapperWithoutInput();
  TestWindow();
  TestMesh();
  TestSettings();
  TestLargeFilterRadius();
  TestHugeResolution(1000000);
  TestHugeResolution(4000000000u);
  TestLostBaker();
  return rtwTestResult();
}
