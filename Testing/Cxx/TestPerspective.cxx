// SPDX-License-Identifier: BSD-3-Clause
// Perspective warps beside exact rays: triangles that reach behind the viewer, each
// parameterization beside its twin in double precision, lights that pass through the line of sight,
// and bad input.
#include "rtwDeepStage.h"

#include "rtwMapTexels.h"
#include "Warp/Perspective/rtwPerspectiveWarp.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLineSource.h"
#include "vtkMatrix4x4.h"
#include "vtkPerspectiveShadowMapPass.h"
#include "vtkPerspectiveShadowMapWarp.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

vtkPerspectiveShadowMapPass* PassOf(rtwShadowStage& stage)
{
  return vtkPerspectiveShadowMapPass::SafeDownCast(stage.Pass);
}

struct Deep : rtwDeepStage
{
  explicit Deep(int floorCells)
    : rtwDeepStage(rtwTechnique::Perspective, floorCells)
  {
  }

  double Measure(const char* name)
  {
    const rtw::ShadowErrors errors = this->Compare(name);
    RTW_CHECK(errors.Percent(errors.FarFromEdge) < 0.02);
    return errors.Percent(errors.Wrong());
  }
};

// Edges stay straight, so that all ways to rasterize are one; and triangles that reach behind the
// centre of projection are as right as those that don't.
void TestRasterization()
{
  Deep coarse(1), fine(120);
  const double exact = coarse.Measure("floor of 2 triangles");
  RTW_CHECK_NEAR(exact, fine.Measure("floor of 28800"), 0.05);
  for (const int way : { vtkAdaptiveShadowMapPass::LINEAR, vtkAdaptiveShadowMapPass::TESSELLATED,
         vtkAdaptiveShadowMapPass::EXACT })
  {
    coarse.Pass->SetRasterization(way);
    RTW_CHECK_NEAR(coarse.Measure("another rasterization"), exact, 1e-9);
  }
  coarse.Pass->SetFilterToPCF();
  PassOf(coarse)->SetParameterizationToPSM();
  coarse.Measure("PSM, PCF");
  coarse.Pass->SetFilterToBilinear();
  coarse.Pass->FocusOnViewOff();
  // A map of the whole scene lies around the viewer, who gains nothing by a warp.
  const double whole = coarse.Measure("whole scene");
  PassOf(coarse)->SetParameterizationToUnwarped();
  RTW_CHECK_NEAR(coarse.Measure("whole scene, unwarped"), whole, 1e-9);
}

// From the least distance along the view of any sample, and from the extent of the focus along t,
// in double precision.
double ExpectedStrength(Deep& stage, const rtw::PerspectiveChoice& choice, vtkMatrix4x4* toPlane)
{
  const auto* size = stage.Renderer->GetSize();
  glm::dvec3 eye, forward, direction;
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->GetPosition(&eye.x);
  camera->GetDirectionOfProjection(&forward.x);
  double nearest = Infinity;
  for (const rtw::ViewSample& sample :
    rtw::ShadowReference(stage.Renderer).Samples(stage.Sun, size[0], size[1]))
  {
    nearest = std::min(nearest, glm::dot(sample.Position - eye, forward));
  }
  const glm::dvec3 t(
    toPlane->GetElement(1, 0), toPlane->GetElement(1, 1), toPlane->GetElement(1, 2));
  direction = glm::normalize(-glm::dvec3(3, 4, 2));
  return rtw::PerspectiveStrength(
    choice, { glm::length(glm::cross(forward, direction)), 1, 0 }, nearest, 1 / glm::length(t));
}

void TestParameterizations()
{
  using Choice = rtw::PerspectiveChoice;
  Deep stage(20);
  vtkPerspectiveShadowMapPass* pass = PassOf(stage);
  pass->SetViewSampleStride(1);
  pass->SetResolutionSplitToSquare(); // so that resolutions compare
  double mean = 0;
  const auto check = [&](const char* name, const Choice& choice) {
    const double wrong = stage.Measure(name);
    const vtkSmartPointer<vtkImageData> warp = pass->GetWarpImage(0);
    vtkNew<vtkMatrix4x4> toPlane;
    if (!RTW_CHECK(warp && warp->GetDimensions()[0] == 3 && warp->GetDimensions()[1] == 3) ||
      !RTW_CHECK(pass->GetLightPlaneMatrix(0, 0, toPlane)))
    {
      return wrong;
    }
    const double strength = *static_cast<float*>(warp->GetScalarPointer(1, 2, 0));
    const double expected = ExpectedStrength(stage, choice, toPlane);
    std::cout << "  strength " << strength << ", expected " << expected << std::endl;
    RTW_CHECK_NEAR(strength, expected, 2e-3 * (1e-3 + expected));
    // The focus is always the same; its near end is that much denser.
    const double even = pass->GetMaximumEffectiveResolution(0, 1) / (1 + strength);
    mean = mean == 0 ? even : mean;
    RTW_CHECK_NEAR(even / mean, 1, 1e-3);
    return wrong;
  };
  const double lispsm = check("LiSPSM", { Choice::Eta, 0 });
  pass->SetParameterizationToUnwarped();
  const double unwarped = check("unwarped", { Choice::Eta, -1 });
  RTW_CHECK(lispsm < 0.5 * unwarped);
  pass->SetParameterizationToPSM();
  RTW_CHECK(check("PSM", { Choice::Eta, 1 }) < unwarped);
  pass->SetParameterizationToTSM();
  check("TSM", { Choice::FocusPoint, 0.1 });
  pass->SetFocusPoint(0.5);
  check("TSM 0.5", { Choice::FocusPoint, 0.5 });
  pass->SetEta(-0.5);
  check("eta -0.5", { Choice::Eta, -0.5 });
  pass->SetEta(0);
  RTW_CHECK_NEAR(check("eta 0", { Choice::Eta, 0 }), lispsm, 1e-9);
  pass->SetNearDistance(20);
  check("n' 20", { Choice::Near, 20 });
  pass->SetNearDistance(Infinity);
  RTW_CHECK_NEAR(check("n' infinite", { Choice::Near, Infinity }), unwarped, 1e-9);
}

// The light passes through the line of sight, from behind the viewer and from in front: nothing
// that is seen jumps on the map, but that it may be turned by half, which moves no texel.
void TestSweep(bool inFront)
{
  rtwShadowStage stage(rtwTechnique::Perspective);
  stage.Name = inFront ? "light in front" : "light behind";
  // Nothing round, whose facets would come into the light one by one.
  stage.AddFloor();
  stage.AddBox(0, 0.5, 0, 1);
  stage.AddBox(2, 0.5, -2, 1);
  vtkLight* sun = stage.AddSun(0, 0, 1);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  // The floor has light from above, whichever side that comes from.
  camera->SetPosition(0, 3, 9);
  camera->SetFocalPoint(0, inFront ? 4 : 0.5, 0);
  camera->SetViewAngle(inFront ? 80 : 30);
  stage.Renderer->ResetCameraClippingRange();
  glm::dvec3 view;
  camera->GetDirectionOfProjection(&view.x);
  const std::vector<glm::dvec3> points{ { -2, 0, 2 }, { 2, 0, 1 }, { 1, 0, -3 }, { 0, 1, 0 } };
  double largest = 0;
  std::vector<glm::dvec2> last;
  for (int i = -40; i <= 40; ++i)
  {
    const double angle = 1e-3 * i;
    const glm::dvec3 up = glm::normalize(glm::dvec3(0, 1, 0) - view.y * view);
    const glm::dvec3 from = (inFront ? 1.0 : -1.0) * std::cos(angle) * view + std::sin(angle) * up;
    sun->SetPosition(from.x, from.y, from.z);
    stage.Render();
    const rtw::TexelFunction texels = rtw::TexelsOf(stage.Pass, 0);
    const int* const extent = stage.Pass->GetShadowMapImage(0)->GetDimensions();
    const glm::dvec2 size(extent[0], extent[1]);
    std::vector<glm::dvec2> places;
    for (const glm::dvec3& point : points)
    {
      places.push_back(texels(point) / size);
      RTW_CHECK(std::isfinite(places.back().x) && std::isfinite(places.back().y));
    }
    double straight = 0, turned = 0;
    for (std::size_t k = 0; k < last.size(); ++k)
    {
      straight = std::max(straight, glm::distance(places[k], last[k]));
      turned = std::max(turned, glm::distance(places[k], 1.0 - last[k]));
    }
    largest = std::max(largest, std::min(straight, turned));
    last = places;
    if (i % 20 == 0)
    {
      rtwShadowBounds bounds;
      bounds.Shadowed = 0.1;
      // Few pixels, whose light is low.
      bounds.Wrong = inFront ? 0.3 : bounds.Wrong;
      bounds.Far = inFront ? 0.1 : bounds.Far;
      RTW_CHECK_SHADOWS_WITHIN(stage, sun, 0, bounds);
    }
  }
  std::cout << stage.Name << ": places change by " << largest << " of the map at most" << std::endl;
  RTW_CHECK(largest < 0.01);
}

// From above, from behind the viewer, who is behind it or beside it, and from in front.
void TestSpots()
{
  rtwShadowStage stage(rtwTechnique::Perspective);
  stage.AddObjects();
  stage.AddBox(-1.5, 0.4, 1.5, 0.8);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0, 3, 9);
  camera->SetFocalPoint(0, 0.5, 0);
  stage.Renderer->ResetCameraClippingRange();
  for (const glm::dvec3& place : { glm::dvec3(3, 7, 2), glm::dvec3(0.3, 4, 14),
         glm::dvec3(1, 3.3, 7.5), glm::dvec3(-3, 4, 9), glm::dvec3(1, 5, -5) })
  {
    std::ostringstream name;
    name << "spot at " << place.x << " " << place.y << " " << place.z;
    stage.Name = name.str();
    vtkLight* spot = stage.AddSpot(place.x, place.y, place.z, 40);
    stage.Render();
    rtwShadowBounds bounds;
    bounds.Shadowed = 0.2;
    RTW_CHECK_SHADOWS_WITHIN(stage, spot, 0, bounds);
    stage.Renderer->RemoveLight(spot);
  }
}

// A line from far behind the viewer to the horizon, whose shadow lies along its own image.
void TestThin()
{
  Deep stage(1);
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-1, 4, 100);
  line->SetPoint2(1, 4, -100);
  stage.Add(line)->GetProperty()->SetLighting(false);
  stage.Render();
  const int* size = stage.Renderer->GetSize();
  const std::vector<unsigned char> mask = stage.GetMask(0);
  const glm::dvec3 a = glm::dvec3(-1, 4, 100) - glm::dvec3(3, 4, 2);
  const glm::dvec3 along = glm::normalize(glm::dvec3(2, 0, -200));
  std::size_t dark = 0, astray = 0;
  for (const rtw::ViewSample& sample :
    rtw::ShadowReference(stage.Renderer).Samples(stage.Sun, size[0], size[1]))
  {
    if (mask[sample.Pixel] < 128 && stage.Truth.Mask[sample.Pixel] == rtw::MASK_LIT &&
      sample.Position.y < 0.01)
    {
      const glm::dvec3 away = sample.Position - a;
      ++dark;
      astray += glm::length(away - glm::dot(away, along) * along) > 0.5;
    }
  }
  std::cout << "line: " << dark << " pixels dark, " << astray << " astray" << std::endl;
  RTW_CHECK(dark > 30);
  RTW_CHECK(10 * astray < dark);
}

void TestBadInput()
{
  rtwShadowStage stage(rtwTechnique::Perspective);
  stage.Name = "bad input";
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  vtkPerspectiveShadowMapWarp* warp = PassOf(stage)->GetPerspectiveWarp();
  rtwMessageCatcher messages(warp);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : { nan, -1.5, 1.001 })
  {
    warp->SetEta(bad);
  }
  for (const double bad : { nan, 0.0, -2.0, -Infinity })
  {
    warp->SetNearDistance(bad);
  }
  for (const double bad : { nan, 0.0, 1.5 })
  {
    warp->SetFocusPoint(bad);
  }
  warp->SetParameterization(-1);
  warp->SetParameterization(6);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 12);
  RTW_CHECK_EQUAL(warp->GetEta(), 0.0);
  RTW_CHECK_EQUAL(warp->GetNearDistance(), 1.0);
  RTW_CHECK_EQUAL(warp->GetFocusPoint(), 0.1);
  RTW_CHECK_EQUAL(warp->GetParameterization(), vtkPerspectiveShadowMapWarp::LISPSM);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK(stage.Pass->GetWarpImage(1) == nullptr);
  RTW_CHECK(stage.Pass->GetImportanceImage(0) == nullptr);
  // Less than the nearest sample's distance, and with next to nothing to be seen along the view.
  warp->SetNearDistance(1e-300);
  stage.Render();
  RTW_CHECK_SHADOWS(stage, sun, 0);
  RTW_CHECK_EQUAL(messages.GetNumberOfErrors(), 12);
}

// A parallel view has no perspective; settings and the camera change what is kept.
void TestChanges()
{
  rtwShadowStage stage(rtwTechnique::Perspective);
  stage.Name = "changes";
  stage.Render();
  stage.AddObjects();
  vtkLight* sun = stage.AddSun(3, 5, 2);
  const auto strength = [&] {
    stage.Render();
    RTW_CHECK_SHADOWS(stage, sun, 0);
    return *static_cast<float*>(stage.Pass->GetWarpImage(0)->GetScalarPointer(1, 2, 0));
  };
  const float lispsm = strength();
  RTW_CHECK(lispsm > 0.1);
  stage.Render();
  RTW_CHECK_EQUAL(stage.Pass->GetNumberOfLayersReused(), 1);
  PassOf(stage)->SetEta(0.7);
  RTW_CHECK(strength() > 1.1 * lispsm);
  stage.Renderer->GetActiveCamera()->ParallelProjectionOn();
  stage.Renderer->GetActiveCamera()->SetParallelScale(4);
  RTW_CHECK_EQUAL(strength(), 0.f);
  stage.Renderer->GetActiveCamera()->ParallelProjectionOff();
  PassOf(stage)->SetParameterizationToLiSPSM();
  RTW_CHECK_NEAR(strength(), lispsm, 1e-6);
  // Samples of a frame before, seen from elsewhere.
  stage.Pass->SetViewSampleSourceToPreviousFrame();
  for (int i = 0; i < 3; ++i)
  {
    stage.Renderer->GetActiveCamera()->Azimuth(0.5);
    RTW_CHECK_NEAR(strength(), lispsm, 0.2 * lispsm);
  }
}
}

int TestPerspective(int, char*[])
{
  TestRasterization();
  TestParameterizations();
  TestSweep(false);
  TestSweep(true);
  TestSpots();
  TestThin();
  TestBadInput();
  TestChanges();
  return rtwTestResult();
}
