// SPDX-License-Identifier: BSD-3-Clause
// Edges that a warp bends: how far each way of drawing them is from exact rays, on a floor that
// reaches to the horizon.
#include "rtwShadowStage.h"

#include "vtkCamera.h"
#include "vtkPlaneSource.h"

#include <iostream>

namespace
{
constexpr double FloorSide = 300;

struct Deep : rtwShadowStage
{
  explicit Deep(int floorCells)
    : rtwShadowStage(rtwTechnique::RTW, rtwChain::Steps)
  {
    vtkNew<vtkPlaneSource> floor;
    floor->SetOrigin(-FloorSide / 2, 0, FloorSide / 2);
    floor->SetPoint1(FloorSide / 2, 0, FloorSide / 2);
    floor->SetPoint2(-FloorSide / 2, 0, -FloorSide / 2);
    floor->SetResolution(floorCells, floorCells);
    this->Add(floor);
    for (int i = 0; i < 12; ++i)
    {
      this->AddBox(4.0 * (i % 3) - 5.0, 1.0, 2.0 - 9.0 * i, 2.0);
    }
    // A roof, large and bent, over a part of them.
    vtkNew<vtkPlaneSource> roof;
    roof->SetOrigin(4, 3, -80);
    roof->SetPoint1(30, 3, -80);
    roof->SetPoint2(4, 3, 0);
    this->Add(roof);
    this->Sun = this->AddSun(3, 4, 2);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0, 2.2, 12);
    camera->SetFocalPoint(0, 1.5, 0);
    this->Renderer->ResetCameraClippingRange();
    this->Pass->SetResolution(512);
    this->Truth = this->Trace(this->Sun);
  }

  rtw::ShadowErrors Measure(const char* name)
  {
    this->Render();
    const rtw::ShadowErrors errors = rtw::Compare(this->GetMask(0), this->Truth);
    std::cout << name << ": " << errors.Percent(errors.Wrong()) << " % wrong, "
              << errors.Percent(errors.FarFromEdge) << " % far from edges" << std::endl;
    return errors;
  }

  vtkLight* Sun;
  rtw::Truth Truth;
};

void TestAll()
{
  Deep stage(1);
  vtkAdaptiveShadowMapPass* pass = stage.Pass;
  const rtw::ShadowErrors automatic = stage.Measure("automatic");
  pass->SetRasterizationToExact();
  const rtw::ShadowErrors exact = stage.Measure("exact");
  pass->SetRasterizationToLinear();
  const rtw::ShadowErrors linear = stage.Measure("linear");
  pass->SetRasterizationToTessellated();
  double wrong[3];
  const double lengths[] = { 0.05, 0.025, 0.01 };
  for (int i = 0; i < 3; ++i)
  {
    pass->SetMaximumEdgeLength(lengths[i]);
    const rtw::ShadowErrors errors = stage.Measure("tessellated");
    wrong[i] = errors.Percent(errors.Wrong());
  }
  const double best = exact.Percent(exact.Wrong());
  RTW_CHECK(best < 3);
  RTW_CHECK_NEAR(automatic.Percent(automatic.Wrong()), best, 0.02);
  RTW_CHECK(linear.Percent(linear.Wrong()) > 2 * best);
  RTW_CHECK(linear.Percent(linear.Wrong()) > wrong[0]);
  RTW_CHECK(wrong[0] >= wrong[1]);
  RTW_CHECK(wrong[1] >= wrong[2]);
  RTW_CHECK(wrong[2] < best + 0.1);
}

// What is bent is as good as what is too small to be.
void TestFineFloor()
{
  Deep coarse(1), fine(708); // a million triangles
  const rtw::ShadowErrors a = coarse.Measure("two triangles"),
                          b = fine.Measure("a million triangles");
  RTW_CHECK_NEAR(a.Percent(a.Wrong()), b.Percent(b.Wrong()), 0.02);
}
}

int TestShadowRasterization(int, char*[])
{
  TestAll();
  TestFineFloor();
  return rtwTestResult();
}
