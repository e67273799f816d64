// SPDX-License-Identifier: BSD-3-Clause
// Few view samples do as well as many: what they collect, where it is put, and wrong pixels.
#include "rtwImportanceScene.h"
#include "rtwSceneStage.h"

#include "vtkImageData.h"
#include "vtkRTWShadowMapPass.h"
#include "vtkShadowRenderStepsPass.h"
#include "vtkUniformShadowMapPass.h"

#include <cmath>
#include <iostream>
#include <vector>

namespace
{
using Pass = vtkRTWShadowMapPass;

std::vector<double> ProfileOf(rtwImportanceScene& scene, int axis)
{
  std::vector<double> profile;
  const vtkSmartPointer<vtkImageData> image = scene.Pass->GetImportanceImage(0);
  for (int cell = 0; RTW_CHECK(image != nullptr) && cell < image->GetDimensions()[0]; ++cell)
  {
    profile.push_back(*static_cast<float*>(image->GetScalarPointer(cell, axis, 0)));
  }
  return profile;
}

double Sum(const std::vector<double>& profile)
{
  double sum = 0;
  for (const double value : profile)
  {
    sum += value;
  }
  return sum;
}

// Each sample speaks for a square: cells get what all pixels would give them, but for what is seen
// of a thing's edge.
void CheckProfiles(int width, int height, int functions, int stride, double tolerance)
{
  rtwImportanceScene scene;
  scene.Window->SetSize(width, height);
  scene.AddSun(4, 5, 1);
  scene.Warped->SetImportanceResolution(512);
  scene.Pass->SetViewSampleStride(1);
  scene.MapsWith(functions);
  std::vector<double> all[2] = { ProfileOf(scene, 0), ProfileOf(scene, 1) };
  scene.Pass->SetViewSampleStride(stride);
  scene.MapsWith(functions);
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::vector<double> few = ProfileOf(scene, axis);
    const double whole = Sum(all[axis]), share = Sum(few);
    double difference = 0;
    for (std::size_t cell = 0; cell < few.size(); ++cell)
    {
      difference += std::abs(few[cell] / share - all[axis][cell] / whole);
    }
    std::cout << width << " x " << height << ", importance " << functions << ", stride " << stride
              << ", axis " << axis << ": cells differ by " << 100 * difference << " %, sum "
              << share / whole << std::endl;
    RTW_CHECK(difference <= tolerance);
    const double samples = functions == Pass::SAMPLE_COUNT ? stride * stride : stride; // a root
    RTW_CHECK_NEAR(share / whole * samples, 1, 0.05);
  }
}

double ErrorOf(rtwSceneStage& stage, int stride, int source)
{
  vtkNew<Pass> pass;
  pass->SetResolution(512);
  pass->SetViewSampleStride(stride);
  pass->SetViewSampleSource(source);
  const rtw::ShadowErrors errors = stage.Measure(pass, source == Pass::PREVIOUS_FRAME ? 3 : 1);
  const double percent = errors.Percent(errors.Wrong());
  std::cout << stage.Name << ", " << (source == Pass::PREPASS ? "prepass" : "previous frame")
            << ", stride " << stride << ": " << percent << " % wrong" << std::endl;
  return percent;
}

// Its near pixels are few; a square's middle pixel for each made a fifth more wrong ones.
void TestErrors()
{
  rtwSceneStage stage("duel");
  const double least = ErrorOf(stage, 1, Pass::PREPASS);
  RTW_CHECK(ErrorOf(stage, 16, Pass::PREPASS) <= 1.07 * least);
  RTW_CHECK(ErrorOf(stage, 64, Pass::PREPASS) <= 1.15 * least);
  RTW_CHECK(
    ErrorOf(stage, 8, Pass::PREVIOUS_FRAME) <= 1.05 * ErrorOf(stage, 1, Pass::PREVIOUS_FRAME));
}

// The focus of few samples holds what that of all does and next to nothing more, however deep the
// view: its texels are as small.
void TestFocus()
{
  rtwSceneStage stage("town");
  stage.Window->SetSize(256, 256);
  double sides[2][2];
  for (int stride = 1; stride <= 2; ++stride)
  {
    vtkNew<vtkUniformShadowMapPass> pass;
    pass->SetResolution(512);
    pass->SetViewSampleStride(stride);
    vtkNew<vtkShadowRenderStepsPass> steps;
    steps->SetShadowMapPass(pass);
    stage.Renderer->SetPass(steps);
    stage.Window->Render();
    for (int axis = 0; axis < 2; ++axis)
    {
      sides[stride - 1][axis] = pass->GetMaximumEffectiveResolution(0, axis);
      std::cout << "stride " << stride << ": effective resolution " << sides[stride - 1][axis]
                << std::endl;
    }
    steps->ReleaseGraphicsResources(stage.Window);
    stage.Renderer->SetPass(nullptr);
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    RTW_CHECK_NEAR(sides[1][axis] / sides[0][axis], 1, 0.01);
  }
}
}

int TestViewSampleStride(int, char*[])
{
  for (const int functions : { int(Pass::SAMPLE_COUNT), int(Pass::SQRT_DEMAND) })
  {
    CheckProfiles(400, 300, functions, 2, 0.05);
    CheckProfiles(397, 301, functions, 8, 0.1);
  }
  TestErrors();
  TestFocus();
  return rtwTestResult();
}
