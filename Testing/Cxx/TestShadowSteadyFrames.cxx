// SPDX-License-Identifier: BSD-3-Clause
// From frame to frame: what is kept, and what is drawn again.
#include "rtwShadowStage.h"

#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

namespace
{
void AddGlyphs(rtwShadowStage& stage)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-2.5, 1, 1.5);
  points->InsertNextPoint(2.5, 1, 1.5);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkConeSource> cone;
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(places);
  glyphs->SetSourceConnection(cone->GetOutputPort());
  vtkNew<vtkActor> cones;
  cones->SetMapper(glyphs);
  stage.Renderer->AddActor(cones);
  vtkNew<vtkOpenGLSphereMapper> spheres;
  spheres->SetInputData(places);
  spheres->SetRadius(0.3f);
  vtkNew<vtkActor> balls;
  balls->SetMapper(spheres);
  balls->SetPosition(0, 1, -2);
  stage.Renderer->AddActor(balls);
}

// Swapping passes or changing uniforms must not make a mapper build its shaders anew.
void TestShaderBuilds(rtwTechnique technique, rtwChain chain)
{
  rtwShadowStage stage(technique, chain);
  stage.AddObjects();
  stage.Pass->SetResolution(256);
  AddGlyphs(stage);
  stage.AddBall(0, 1, 2, 0.4)->GetProperty()->SetOpacity(0.5);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  stage.AddSpot(0, 6, 3);
  stage.Render();
  stage.Render();
  const int builds = stage.Pass->GetNumberOfShaderBuilds();
  RTW_CHECK(builds > 0);
  const vtkTypeInt64 memory = stage.Pass->GetShadowMemory();
  RTW_CHECK(memory > 0);
  for (int frame = 0; frame < 5; ++frame)
  {
    stage.Renderer->GetActiveCamera()->Azimuth(7);
    sun->SetPosition(3 - 0.5 * frame, 5, 2);
    stage.Render();
    RTW_CHECK_EQUAL(stage.Pass->GetNumberOfShaderBuilds(), builds);
    RTW_CHECK_EQUAL(stage.Pass->GetShadowMemory(), memory);
    RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 2);
    stage.GetMask(0);
  }
}

void TestReuse()
{
  rtwShadowStage stage;
  stage.AddFloor();
  vtkActor* ball = stage.AddBall(-1.2, 1.3, 0, 1);
  stage.AddBox(1.8, 0.6, -0.5, 1.2);
  vtkLight* sun = stage.AddSun(3, 5, 2);
  rtwShadowBounds bounds;
  bounds.Shadowed = 1;
  const auto check = [&](const char* name, int drawn) {
    stage.Name = name;
    stage.Render();
    RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), drawn);
    RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersReused(), 1 - drawn);
    RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  };
  check("first frame", 1);
  check("still frame", 0);
  check("still frame again", 0);
  ball->GetProperty()->SetColor(1, 0.5, 0);
  check("other colour", 0);
  stage.Renderer->GetActiveCamera()->Azimuth(20);
  check("camera moved", 1);
  RTW_CHECK_PICTURE(stage);
  sun->SetPosition(2, 5, 3);
  check("light moved", 1);
  ball->AddPosition(0.2, 0.1, 0);
  check("actor moved", 1);
  check("still again", 0);
  sun->SetIntensity(0.8);
  check("light dimmed", 0);
  RTW_CHECK_PICTURE(stage);
  stage.Pass->CachingOff();
  check("caching off", 1);
  check("caching off again", 1);
  stage.Pass->CachingOn();

  // Settings that change nothing on the map, and those that do.
  stage.Pass->SetResolution(512);
  check("other resolution", 1);
  stage.Pass->SetFilterToNearest();
  stage.Name = "nearest";
  stage.Render();
  bounds.Wrong = 0.2;
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_PICTURE(stage);
}
}

int TestShadowSteadyFrames(int, char*[])
{
  TestShaderBuilds(rtwTechnique::RTW, rtwChain::Steps);
  TestShaderBuilds(rtwTechnique::Uniform, rtwChain::Classic);
  TestReuse();
  return rtwTestResult();
}
