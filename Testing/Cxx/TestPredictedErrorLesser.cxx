// SPDX-License-Identifier: BSD-3-Clause
// The predicted error and the turn of the light plane in a context without compute shaders, as Mesa
// plays one where MESA_GL_VERSION_OVERRIDE says so; skipped in a better one.
#include "rtwShadowStage.h"

#include "vtkMatrix4x4.h"
#include "vtkRTWEGLRenderWindow.h"

#include <iostream>

namespace
{
bool HasCompute(vtkRenderWindow* window)
{
  auto* ours = vtkRTWEGLRenderWindow::SafeDownCast(window);
  return !ours || 10 * ours->GetOpenGLMajorVersion() + ours->GetOpenGLMinorVersion() >= 43;
}

double GetAxis(rtwShadowStage& stage)
{
  vtkNew<vtkMatrix4x4> matrix;
  RTW_CHECK(stage.Pass->GetLightPlaneMatrix(0, 0, matrix));
  return matrix->GetElement(0, 0) / matrix->GetElement(0, 2);
}
}

int TestPredictedErrorLesser(int, char*[])
{
  rtwShadowStage stage;
  stage.Name = "lesser context";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  rtwMessageCatcher messages(stage.Pass);
  stage.Render();
  if (HasCompute(stage.Window))
  {
    return rtwTestSkipped;
  }
  const double off = GetAxis(stage);
  const double predicted = stage.Pass->GetPredictedError(0);
  std::cout << 100 * predicted << " % predicted" << std::endl;
  RTW_CHECK(predicted > 0.0001 && predicted < 0.05);
  stage.Pass->SetLightPlaneTurnToAutomatic();
  stage.Render();
  RTW_CHECK_EQUAL(GetAxis(stage), off);
  stage.Pass->SetLightPlaneTurnToViewAligned();
  stage.Render();
  RTW_CHECK(std::abs(GetAxis(stage) - off) > 0.01);
  rtwShadowBounds bounds;
  bounds.Wrong = 0.5;
  RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 0);
  RTW_CHECK_EQUAL(messages.GetNumberOfWarnings(), 1);
  return rtwTestResult();
}
