// SPDX-License-Identifier: BSD-3-Clause
// The aliasing error of each pixel as the GPU has it, against the metric that follows the map in
// double precision.
#include "rtwDebugViews.h"

#include "rtwMapTexels.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkNonOrthogonalShadowMapWarp.h"
#include "vtkNoTWShadowMapPass.h"

#include <algorithm>
#include <cmath>

namespace
{
// Both tell the error of a pixel; where only one does, the other finds no receiver that faces the
// light.
struct Agreement
{
  std::size_t Compared = 0, Missing = 0, Extra = 0;
  std::vector<double> Differences; ///< relative

  double Quantile(double share)
  {
    const auto rank = std::size_t(share * double(this->Differences.size() - 1));
    std::nth_element(
      this->Differences.begin(), this->Differences.begin() + rank, this->Differences.end());
    return this->Differences[rank];
  }
};

Agreement Compare(rtwShadowStage& stage, vtkLight* light, int index)
{
  Agreement result;
  const vtkSmartPointer<vtkImageData> image = stage.Pass->GetAliasingErrorImage(index);
  const int* size = stage.Renderer->GetSize();
  if (!RTW_CHECK(image != nullptr) || !RTW_CHECK_EQUAL(image->GetDimensions()[0], size[0]) ||
    !RTW_CHECK_EQUAL(image->GetDimensions()[1], size[1]) ||
    !RTW_CHECK_EQUAL(image->GetNumberOfScalarComponents(), 2))
  {
    return result;
  }
  const auto* values = static_cast<float*>(image->GetScalarPointer());
  std::vector<double> expected(std::size_t(size[0]) * size[1], 0.0);
  const std::vector<rtw::ViewSample> samples =
    rtw::ShadowReference(stage.Renderer).Samples(light, size[0], size[1]);
  const std::vector<double> errors = rtw::AliasingErrors(samples, rtw::TexelsOf(stage.Pass, index));
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    expected[samples[i].Pixel] = errors[i];
  }
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const double actual = std::max(values[2 * i], values[2 * i + 1]);
    if (actual > 0 && expected[i] > 0)
    {
      ++result.Compared;
      result.Differences.push_back(std::abs(actual / expected[i] - 1));
    }
    result.Missing += expected[i] > 0 && actual == 0;
    result.Extra += expected[i] == 0 && actual > 0;
  }
  return result;
}

// Where a pixel's ellipse reaches into two cells of a warp the metric takes the mean of both. In a
// cell of a non-orthogonal one the error isn't even the same everywhere.
void Check(rtwShadowStage& stage, vtkLight* light, int index, rtwTechnique technique)
{
  Agreement a = Compare(stage, light, index);
  if (!RTW_CHECK(a.Compared > 5000))
  {
    return;
  }
  const double pixels = double(a.Compared);
  std::cout << stage.Name << ", light " << index << ": " << a.Compared << " pixels, relative "
            << a.Quantile(0.5) << " median, " << a.Quantile(0.99) << " at 99 %, "
            << a.Quantile(0.995) << " at 99.5 %, " << a.Quantile(0.999) << " at 99.9 %; missing "
            << 100 * double(a.Missing) / pixels << " %, extra " << 100 * double(a.Extra) / pixels
            << " %" << std::endl;
  const double bends = technique == rtwTechnique::NoTW ? 2 : 1;
  const bool warped = technique == rtwTechnique::RTW || technique == rtwTechnique::NoTW;
  RTW_CHECK(a.Quantile(0.5) < bends * 1e-5);
  RTW_CHECK(a.Quantile(0.99) < (warped ? bends * 0.005 : 2e-4));
  RTW_CHECK(a.Quantile(0.999) < (warped ? bends * 0.02 : 5e-4));
  RTW_CHECK(double(a.Missing) < 2e-4 * pixels);
  // The metric leaves out the rim of a cone, beyond 0.97 of its radius.
  RTW_CHECK(double(a.Extra) < (light->GetPositional() ? 0.08 : 1e-3) * pixels);
}

void TestTechnique(rtwTechnique technique, const std::string& name)
{
  rtwShadowStage stage(technique);
  rtwFillForDebugViews(stage);
  if (auto* notw = vtkNoTWShadowMapPass::SafeDownCast(stage.Pass))
  {
    // The less its functions are smoothed, the more does a slope change within a pixel.
    notw->GetNonOrthogonalWarp()->AutomaticSmoothingOff();
  }
  auto* lights = stage.Renderer->GetLights();
  auto* sun = vtkLight::SafeDownCast(lights->GetItemAsObject(0));
  auto* spot = vtkLight::SafeDownCast(lights->GetItemAsObject(1));
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  for (const bool parallel : { false, true })
  {
    stage.Name = name + (parallel ? ", parallel" : "");
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(3.5);
    stage.Render();
    Check(stage, sun, 0, technique);
    Check(stage, spot, 1, technique);
  }
}

// Straight from above a pixel is a square, and a focus of another shape has texels that are none.
void TestAxes()
{
  rtwShadowStage stage(rtwTechnique::Uniform);
  stage.AddFloor();
  stage.AddSun(0, 10, 0);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0, 6, 0);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, -1);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(2);
  stage.Render();
  const vtkSmartPointer<vtkImageData> image = stage.Pass->GetAliasingErrorImage(0);
  vtkNew<vtkMatrix4x4> toPlane;
  RTW_CHECK(stage.Pass->GetLightPlaneMatrix(0, 0, toPlane));
  double expected[2];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double perUnit = std::hypot(toPlane->GetElement(axis, 0), toPlane->GetElement(axis, 2));
    const double pixel = 2.0 * 2.0 / stage.Renderer->GetSize()[1];
    expected[axis] = 1 / (1024 * perUnit * pixel);
  }
  std::cout << "axes: " << expected[0] << ", " << expected[1] << std::endl;
  RTW_CHECK(std::abs(expected[0] / expected[1] - 1) > 0.3);
  const auto* values = static_cast<float*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < 2 * image->GetNumberOfPoints(); ++i)
  {
    if (!RTW_CHECK_NEAR(values[i] / expected[i % 2], 1, 1e-4))
    {
      break;
    }
  }
}
}

int TestAliasingImage(int, char*[])
{
  TestTechnique(rtwTechnique::Unfocused, "unfocused");
  TestTechnique(rtwTechnique::Uniform, "uniform");
  TestTechnique(rtwTechnique::RTW, "rtw");
  TestTechnique(rtwTechnique::NoTW, "notw");
  TestTechnique(rtwTechnique::Perspective, "perspective");
  TestAxes();
  return rtwTestResult();
}
