// SPDX-License-Identifier: BSD-3-Clause
// The importance that the GPU collects, against what rays through the pixels ask for, and what
// becomes of it, against the warping maps.
#include "rtwImportanceScene.h"

#include "Warp/Rectilinear/rtwRectilinearWarp.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
using Pass = vtkRTWShadowMapPass;
using Profile = std::vector<double>;
enum Which
{
  COLLECTED,
  USED
};

Profile ProfileOf(rtwImportanceScene& scene, int axis, Which which, int light = 0)
{
  Profile profile;
  const vtkSmartPointer<vtkImageData> image = scene.Pass->GetImportanceImage(light);
  if (RTW_CHECK(image != nullptr) && RTW_CHECK_EQUAL(image->GetNumberOfScalarComponents(), 2) &&
    RTW_CHECK_EQUAL(image->GetDimensions()[0], scene.Warped->GetImportanceResolution()) &&
    RTW_CHECK_EQUAL(image->GetDimensions()[1], 2))
  {
    for (int cell = 0; cell < image->GetDimensions()[0]; ++cell)
    {
      profile.push_back(static_cast<float*>(image->GetScalarPointer(cell, axis, 0))[which]);
    }
  }
  return profile;
}

double Sum(const Profile& profile)
{
  return std::accumulate(profile.begin(), profile.end(), 0.0);
}

std::size_t Peak(const Profile& profile)
{
  return std::size_t(std::max_element(profile.begin(), profile.end()) - profile.begin());
}

// Of each cell, over the pixels that face the light.
struct Expected
{
  Profile Demand[2], Nearness[2], Count[2];

  Expected(rtwImportanceScene& scene, vtkLight* light)
  {
    vtkNew<vtkMatrix4x4> matrix;
    RTW_CHECK(scene.Pass->GetLightPlaneMatrix(0, 0, matrix));
    glm::dmat4 toPlane;
    for (int i = 0; i < 16; ++i)
    {
      toPlane[i % 4][i / 4] = matrix->GetElement(i / 4, i % 4);
    }
    const int cells = scene.Warped->GetImportanceResolution();
    for (int axis = 0; axis < 2; ++axis)
    {
      this->Demand[axis] = this->Nearness[axis] = this->Count[axis] = Profile(cells, 0.0);
    }
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    const double *eye = camera->GetPosition(), *forward = camera->GetDirectionOfProjection();
    const glm::dvec3 from(eye[0], eye[1], eye[2]), along(forward[0], forward[1], forward[2]);
    const int* size = scene.Renderer->GetSize();
    for (const rtw::ViewSample& sample :
      rtw::ShadowReference(scene.Renderer).Samples(light, size[0], size[1]))
    {
      const glm::dvec2 at(toPlane * glm::dvec4(sample.Position, 1));
      const glm::dvec2 right(toPlane * glm::dvec4(sample.ToRight, 0));
      const glm::dvec2 above(toPlane * glm::dvec4(sample.ToAbove, 0));
      const double depth = glm::dot(sample.Position - from, along);
      for (int axis = 0; axis < 2; ++axis)
      {
        const int cell = std::clamp(int(at[axis] * cells), 0, cells - 1);
        this->Demand[axis][cell] += 1 / std::hypot(right[axis], above[axis]);
        this->Nearness[axis][cell] =
          std::max(this->Nearness[axis][cell], camera->GetClippingRange()[0] / depth);
        this->Count[axis][cell] += 1;
      }
    }
  }
};

// The sum of what cells differ by, as a share of the sum of all; a sample that lies on the border
// of two cells may fall to either.
double Difference(const Profile& actual, const Profile& expected)
{
  double difference = actual.size() == expected.size() ? 0 : 1e9;
  for (std::size_t i = 0; i < std::min(actual.size(), expected.size()); ++i)
  {
    difference += std::abs(actual[i] - expected[i]);
  }
  return difference / Sum(expected);
}

void CheckProfile(
  const std::string& what, const Profile& actual, const Profile& expected, double tolerance)
{
  const double difference = Difference(actual, expected), sum = Sum(actual) / Sum(expected);
  if (!RTW_CHECK(difference < 1e9))
  {
    return;
  }
  const std::size_t peak = Peak(expected);
  std::cout << what << ": cells differ by " << 100 * difference << " %, sum " << sum << ", at the "
            << "peak, cell " << peak << ", " << actual[peak] / expected[peak] << std::endl;
  RTW_CHECK(difference <= tolerance);
  RTW_CHECK_NEAR(sum, 1, tolerance);
  RTW_CHECK_NEAR(actual[peak] / expected[peak], 1, tolerance);
}

void TestCollected(bool parallel)
{
  rtwImportanceScene scene;
  vtkLight* sun = scene.AddSun(4, 5, 1);
  scene.Pass->SetViewSampleStride(1);
  scene.Warped->SetImportanceResolution(64);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(3);
  scene.Render();
  Expected expected(scene, sun);
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::string name = std::string(axis ? "t" : "s") + (parallel ? ", parallel" : "");
    scene.MapsWith(Pass::SQRT_DEMAND);
    Profile demand = ProfileOf(scene, axis, COLLECTED);
    for (double& value : demand)
    {
      value *= value;
    }
    // A step to the next pixel isn't a derivative, and demand is collected in whole numbers.
    CheckProfile("demand along " + name, demand, expected.Demand[axis], 0.01);
    scene.MapsWith(Pass::SAMPLE_COUNT);
    CheckProfile(
      "count along " + name, ProfileOf(scene, axis, COLLECTED), expected.Count[axis], 1e-4);
    if (!parallel)
    {
      scene.MapsWith(Pass::DISTANCE_TO_EYE);
      CheckProfile(
        "nearness along " + name, ProfileOf(scene, axis, COLLECTED), expected.Nearness[axis], 1e-4);
    }
  }
}

// The texels of a light's image stand for as many pixels as there are, of which the view samples
// are a quarter.
void TestUnits()
{
  rtwImportanceScene scene(false);
  scene.AddSun(4, 5, 1);
  scene.MapsWith(Pass::SAMPLE_COUNT);
  const double samples = Sum(ProfileOf(scene, 0, COLLECTED));
  scene.MapsWith(Pass::SAMPLE_COUNT, Pass::FORWARD);
  const double pixels = Sum(ProfileOf(scene, 0, COLLECTED));
  std::cout << "samples " << samples << ", pixels " << pixels << std::endl;
  RTW_CHECK_EQUAL(samples, std::floor(samples));
  RTW_CHECK_NEAR(pixels / samples, 4, 0.1);
  scene.MapsWith(Pass::SQRT_DEMAND);
  const double root = Sum(ProfileOf(scene, 1, COLLECTED));
  scene.MapsWith(Pass::SQRT_DEMAND, Pass::FORWARD);
  RTW_CHECK_NEAR(Sum(ProfileOf(scene, 1, COLLECTED)) / root, 2, 0.1);
}

// Blur and floor, as the twin has them, and the warping map that comes of it.
void CheckUsed(rtwImportanceScene& scene, int light, int axis, const Profile& map)
{
  const Profile collected = ProfileOf(scene, axis, COLLECTED, light);
  const Profile used = ProfileOf(scene, axis, USED, light);
  const rtw::WarpingFunction twin = rtw::WarpingFunction::FromImportance(
    collected, scene.Warped->GetBlurSigma(), scene.Warped->GetImportanceFloor());
  RTW_CHECK(Sum(collected) > 0);
  double worst = 0, worstOfMap = 0;
  for (std::size_t cell = 0; cell < used.size(); ++cell)
  {
    const double share = used[cell] / Sum(used);
    worst = std::max(worst, std::abs(share * double(used.size()) - twin.Slope(int(cell))));
    worstOfMap = std::max(worstOfMap, std::abs(share - (map[cell + 1] - map[cell])));
  }
  if (!RTW_CHECK(worst < 1e-4) || !RTW_CHECK(worstOfMap < 1e-5))
  {
    std::cout << scene.Warped->GetImportance() << ", analysis " << scene.Warped->GetAnalysis()
              << ", light " << light << ", axis " << axis << ": slopes differ by " << worst
              << ", the map by " << worstOfMap << std::endl;
  }
}

void TestUsed()
{
  rtwImportanceScene scene;
  scene.AddSun(4, 5, 1);
  scene.AddSpot(-3, 6, 2);
  scene.Warped->SetImportanceFloor(0.05);
  for (const int analysis : { Pass::BACKWARD, Pass::FORWARD, Pass::HYBRID })
  {
    for (const int functions : { int(Pass::SQRT_DEMAND), Pass::SQRT_DEMAND | Pass::SHADOW_EDGE,
           Pass::DISTANCE_TO_EYE | Pass::SURFACE_NORMAL, int(Pass::SAMPLE_COUNT) })
    {
      for (int light = 0; light < 2; ++light)
      {
        const rtwImportanceScene::Maps maps = scene.MapsWith(functions, analysis, light);
        for (int axis = 0; axis < 2; ++axis)
        {
          CheckUsed(scene, light, axis, maps[axis]);
        }
      }
    }
  }
}

// Before the first frame, of what there isn't, and of a warp that has none.
void TestNone()
{
  rtwImportanceScene scene;
  RTW_CHECK(scene.Pass->GetImportanceImage(0) == nullptr);
  scene.AddSun(4, 5, 1);
  scene.Render();
  RTW_CHECK(scene.Pass->GetImportanceImage(0) != nullptr);
  RTW_CHECK(scene.Pass->GetImportanceImage(-1) == nullptr);
  RTW_CHECK(scene.Pass->GetImportanceImage(1) == nullptr);
  RTW_CHECK(scene.Pass->GetImportanceImage(0, 1) == nullptr);
  RTW_CHECK(scene.Pass->GetImportanceImage(0, -1) == nullptr);
  // What is set for the next frame doesn't change the last one's.
  scene.Warped->SetImportanceResolution(32);
  RTW_CHECK_EQUAL(scene.Pass->GetImportanceImage(0)->GetDimensions()[0], 512);
  scene.Render();
  RTW_CHECK_EQUAL(scene.Pass->GetImportanceImage(0)->GetDimensions()[0], 32);
  scene.Pass->ReleaseGraphicsResources(scene.Window);
  RTW_CHECK(scene.Pass->GetImportanceImage(0) == nullptr);
  rtwShadowStage uniform(rtwTechnique::Uniform);
  uniform.AddFloor();
  uniform.AddSun(4, 5, 1);
  uniform.Render();
  RTW_CHECK(uniform.Pass->GetImportanceImage(0) == nullptr);
}
}

int TestImportanceImage(int, char*[])
{
  TestCollected(false);
  TestCollected(true);
  TestUnits();
  TestUsed();
  TestNone();
  return rtwTestResult();
}
