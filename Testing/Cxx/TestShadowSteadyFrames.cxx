// SPDX-License-Identifier: BSD-3-Clause
// From frame to frame: what is kept, what is drawn again, and that it is right after all changes.
#include "rtwShadowStage.h"

#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkIdentityShadowMapWarp.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRectilinearShadowMapWarp.h"

#include <functional>

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

// Every combination of settings decides alike, but for errors of their own.
void TestSettings()
{
  rtwShadowStage stage;
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  rtwShadowBounds bounds;
  bounds.Wrong = 0.2;
  vtkNew<vtkIdentityShadowMapWarp> identity;
  vtkNew<vtkRectilinearShadowMapWarp> published;
  published->SetImportance(
    vtkRectilinearShadowMapWarp::DISTANCE_TO_EYE | vtkRectilinearShadowMapWarp::SURFACE_NORMAL);
  for (const int filter : { vtkAdaptiveShadowMapPass::NEAREST, vtkAdaptiveShadowMapPass::BILINEAR })
  {
    for (const int test : { vtkAdaptiveShadowMapPass::DUAL,
           vtkAdaptiveShadowMapPass::RECEIVER_PLANE, vtkAdaptiveShadowMapPass::CONSTANT_BIAS })
    {
      stage.Name = "filter " + std::to_string(filter) + ", test " + std::to_string(test);
      stage.Pass->SetFilter(filter);
      stage.Pass->SetDepthTest(test);
      stage.Pass->SetConstantBias(0.01);
      stage.Render();
      RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
    }
  }
  stage.Pass->SetDepthTestToDual();
  stage.Name = "published importance";
  stage.Pass->SetWarp(published);
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  stage.Name = "warp changed";
  published->SetImportanceResolution(64);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersDrawn(), 1);
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  stage.Name = "identity";
  stage.Pass->SetWarp(identity);
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_PICTURE(stage);
  stage.Name = "linear";
  stage.Pass->SetRasterizationToLinear();
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  stage.Name = "culling off";
  stage.Pass->CullCastersOff();
  stage.Render();
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfCastersCulled(0), 0);
}

// A frame without the pass, one after all its resources went, and one in a new context.
void TestReleased(rtwChain chain)
{
  rtwShadowStage stage(rtwTechnique::RTW, chain);
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  const auto check = [&](const char* name) {
    stage.Name = std::string(name) + (chain == rtwChain::Classic ? " classic" : " steps");
    stage.Render();
    RTW_CHECK_SHADOWS(stage, sun, 0);
  };
  check("before");
  const vtkTypeInt64 memory = stage.Pass->GetShadowMemory();
  for (int i = 0; i < 3; ++i)
  {
    stage.UsePass(false);
    stage.Render();
    stage.UsePass(true);
    stage.Render();
    RTW_CHECK_EQUAL(stage.Pass->GetShadowMemory(), memory);
  }
  check("used again");
  stage.Pass->ReleaseGraphicsResources(stage.Window);
  check("released");
  stage.Renderer->ReleaseGraphicsResources(stage.Window);
  check("renderer released");
  stage.Window->Finalize();
  check("new context");
  RTW_CHECK_PICTURE(stage);
  // Another window takes over the renderer.
  stage.Window->RemoveRenderer(stage.Renderer);
  vtkNew<vtkRenderWindow> other;
  other->SetMultiSamples(0);
  other->SetSize(220, 240);
  other->AddRenderer(stage.Renderer);
  stage.Renderer->ResetCameraClippingRange();
  other->Render();
  stage.Name = "other window";
  RTW_CHECK_SHADOWS(stage, sun, 0);
  other->RemoveRenderer(stage.Renderer);
}
}

int TestShadowSteadyFrames(int, char*[])
{
  TestShaderBuilds(rtwTechnique::RTW, rtwChain::Steps);
  TestShaderBuilds(rtwTechnique::Uniform, rtwChain::Classic);
  TestReuse();
  TestSettings();
  TestReleased(rtwChain::Steps);
  TestReleased(rtwChain::Classic);
  return rtwTestResult();
}
