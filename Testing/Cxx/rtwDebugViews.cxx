// SPDX-License-Identifier: BSD-3-Clause
#include "rtwDebugViews.h"

#include "vtkConeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <memory>

void rtwFillForDebugViews(rtwShadowStage& stage)
{
  stage.AddObjects();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.3, 0.6, 1.8);
  points->InsertNextPoint(2.6, 0.6, 1.2);
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkConeSource> cone;
  cone->SetDirection(0, 1, 0);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(places);
  glyphs->SetSourceConnection(cone->GetOutputPort());
  vtkNew<vtkActor> cones;
  cones->SetMapper(glyphs);
  cones->GetProperty()->SetColor(0.5, 0.8, 0.5);
  stage.Renderer->AddActor(cones);
  vtkActor* glass = stage.AddBall(-2.6, 0.7, 1.8, 0.5);
  glass->GetProperty()->SetOpacity(0.4);
  glass->GetProperty()->SetColor(0.2, 0.6, 1);
  stage.AddSun(3, 5, 2)->SetIntensity(0.6);
  stage.AddSpot(-2, 6, 3, 24)->SetIntensity(0.4);
}

void rtwCheckDebugViews(int light, rtwChain chain, int argc, char* argv[])
{
  std::vector<std::unique_ptr<rtwShadowStage>> stages;
  for (int view = vtkAdaptiveShadowMapPass::NONE; view <= vtkAdaptiveShadowMapPass::LAYERS; ++view)
  {
    stages.push_back(std::make_unique<rtwShadowStage>(rtwTechnique::RTW, chain));
    rtwShadowStage& stage = *stages.back();
    rtwFillForDebugViews(stage);
    stage.Pass->SetResolution(256);
    stage.Pass->SetDebugView(view);
    stage.Pass->SetDebugLight(light);
    const int column = view % 3, row = view / 3;
    stage.Renderer->SetViewport(column / 3.0, 0.5 - row / 2.0, (column + 1) / 3.0, 1 - row / 2.0);
    stage.Renderer->SetBackground(0.1, 0.2, 0.3);
    if (view > 0)
    {
      stage.Window->RemoveRenderer(stage.Renderer);
      stages[0]->Window->AddRenderer(stage.Renderer);
    }
    stage.Renderer->ResetCameraClippingRange();
  }
  vtkRenderWindow* window = stages[0]->Window;
  window->SetSize(720, 360);
  // The first frame, and one in which nothing is drawn anew.
  for (int frame = 0; frame < 2; ++frame)
  {
    window->Render();
    rtwCompareWithBaseline(window, argc, argv);
  }
  for (std::size_t i = 1; i < stages.size(); ++i)
  {
    window->RemoveRenderer(stages[i]->Renderer);
  }
}
