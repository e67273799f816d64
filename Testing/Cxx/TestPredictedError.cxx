// SPDX-License-Identifier: BSD-3-Clause
// The predicted error: against its double-precision twin, for every kind of window and caster, and
// that nothing comes of asking.
#include "rtwShadowStage.h"

#include "rtwEdgeTwin.h"

#include "vtkActor.h"
#include "vtkIdentityShadowMapWarp.h"
#include "vtkImageData.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iostream>

namespace
{
void CheckTwin(rtwShadowStage& stage, vtkLight* light, int index)
{
  const double predicted = stage.Pass->GetPredictedError(index);
  const double twin = rtw::PredictedErrorTwin(stage.Renderer, stage.Pass, light, index);
  std::cout << stage.Name << ", light " << index << ": " << 100 * predicted << " % predicted, twin "
            << 100 * twin << " %" << std::endl;
  RTW_CHECK(predicted > 0.0001);
  RTW_CHECK_NEAR(predicted / twin, 1, 0.03);
}

void TestTwin()
{
  for (const rtwTechnique technique :
    { rtwTechnique::RTW, rtwTechnique::Uniform, rtwTechnique::Unfocused })
  {
    rtwShadowStage stage(technique, rtwChain::Classic);
    stage.Name = "technique " + std::to_string(int(technique));
    stage.AddObjects();
    vtkLight* sun = stage.AddSun(3, 5, 2);
    vtkLight* spot = stage.AddSpot(-3, 7, 2, 40);
    stage.Pass->SetResolution(256);
    stage.Render();
    CheckTwin(stage, sun, 0);
    CheckTwin(stage, spot, 1);
    RTW_CHECK_EQUAL(stage.Pass->GetPredictedError(2), -1);
    RTW_CHECK_EQUAL(stage.Pass->GetPredictedError(-1), -1);
    // Half the texels a side make each twice as wide.
    const double fine = stage.Pass->GetPredictedError(0);
    stage.Pass->SetResolution(128);
    stage.Render();
    RTW_CHECK_NEAR(stage.Pass->GetPredictedError(0) / fine, 2, 0.3);
    // Another warp, another context.
    vtkNew<vtkIdentityShadowMapWarp> identity;
    stage.Pass->SetWarp(identity);
    stage.Pass->SetResolution(256);
    stage.Name = "another warp";
    stage.Render();
    CheckTwin(stage, sun, 0);
    const double before = stage.Pass->GetPredictedError(0);
    stage.Window->Finalize();
    stage.Name = "another context";
    stage.Render();
    CheckTwin(stage, sun, 0);
    RTW_CHECK_EQUAL(stage.Pass->GetPredictedError(0), before);
  }
}

void TestNothing()
{
  rtwShadowStage stage;
  stage.Name = "nothing";
  RTW_CHECK_EQUAL(stage.Pass->GetPredictedError(0), -1);
  stage.AddFloor();
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetPredictedError(0), -1);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetPredictedError(0), 0); // no shadow
  sun->SetPosition(3, -5, 2);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetPredictedError(0), 0); // nothing faces it
  stage.Pass->ReleaseGraphicsResources(stage.Window);
  RTW_CHECK_EQUAL(stage.Pass->GetPredictedError(0), -1);
}

// Where no mask is drawn, one is for the asking, and says the same.
void TestWithoutMask()
{
  rtwShadowStage stage;
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.Pass->SetResolution(256);
  stage.Render();
  const double masked = stage.Pass->GetPredictedError(0);
  stage.Name = "previous frame";
  stage.Pass->SetViewSampleSourceToPreviousFrame();
  stage.Render();
  stage.Render();
  CheckTwin(stage, sun, 0);
  RTW_CHECK_NEAR(stage.Pass->GetPredictedError(0) / masked, 1, 0.15);
  stage.Pass->SetViewSampleSourceToPrepass();
  stage.Name = "several samples a pixel";
  stage.Window->SetMultiSamples(4);
  stage.Render();
  CheckTwin(stage, sun, 0);
  RTW_CHECK_NEAR(stage.Pass->GetPredictedError(0) / masked, 1, 0.05);
  RTW_CHECK_PICTURE(stage);
}

// Asking disturbs neither the picture nor what is kept.
void TestAsking()
{
  rtwShadowStage stage;
  stage.Name = "asked";
  stage.AddObjects();
  stage.AddSun(3, 5, 2);
  stage.Render();
  const vtkSmartPointer<vtkImageData> before = rtwGrab(stage.Window);
  const double first = stage.Pass->GetPredictedError(0);
  RTW_CHECK_EQUAL(stage.Pass->GetPredictedError(0), first);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersReused(), 1);
  RTW_CHECK_EQUAL(stage.Pass->GetPredictedError(0), first);
  const vtkSmartPointer<vtkImageData> after = rtwGrab(stage.Window);
  const int* size = before->GetDimensions();
  RTW_CHECK(std::memcmp(before->GetScalarPointer(), after->GetScalarPointer(),
              std::size_t(3) * size[0] * size[1]) == 0);
  RTW_CHECK_PICTURE(stage);
}

void AddBalls(rtwShadowStage& stage)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1.2, 1.3, 0);
  points->InsertNextPoint(1.4, 0.8, 0.6);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(places);
  mapper->SetRadius(0.7f);
  vtkNew<vtkActor> balls;
  balls->SetMapper(mapper);
  stage.Renderer->AddActor(balls);
}

// What mappers draw isn't warped, so that its edges are as coarse as on a uniform map.
void TestMapperCasters()
{
  double predicted[2], own = 0;
  for (const rtwTechnique technique : { rtwTechnique::Uniform, rtwTechnique::RTW })
  {
    rtwShadowStage stage(technique);
    stage.AddFloor();
    AddBalls(stage);
    stage.AddSun(3, 5, 2);
    stage.Pass->SetResolution(256);
    stage.Render();
    const bool warped = technique == rtwTechnique::RTW;
    predicted[warped ? 1 : 0] = stage.Pass->GetPredictedError(0);
    if (warped)
    {
      // Beside them casters whose edges are finer.
      stage.AddBox(-2.5, 0.6, 2.5, 1.2);
      stage.Render();
      own = stage.Pass->GetPredictedError(0);
    }
  }
  std::cout << "balls of a mapper: " << 100 * predicted[0] << " % predicted, warped "
            << 100 * predicted[1] << " %, beside a mesh " << 100 * own << " %" << std::endl;
  RTW_CHECK_NEAR(predicted[1] / predicted[0], 1, 0.02);
  RTW_CHECK(own > 0);
}
}

int TestPredictedError(int, char*[])
{
  TestTwin();
  TestNothing();
  TestWithoutMask();
  TestAsking();
  TestMapperCasters();
  return rtwTestResult();
}
