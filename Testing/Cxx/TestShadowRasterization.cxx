// SPDX-License-Identifier: BSD-3-Clause
// Edges that a warp bends: how far each way of drawing them is from exact rays, on a floor that
// reaches to the horizon.
#include "rtwDeepStage.h"

#include <iostream>

namespace
{
struct Deep : rtwDeepStage
{
  explicit Deep(int floorCells)
    : rtwDeepStage(rtwTechnique::RTW, floorCells, true)
  {
  }
};

void TestAll()
{
  Deep stage(1);
  vtkAdaptiveShadowMapPass* pass = stage.Pass;
  const rtw::ShadowErrors automatic = stage.Compare("automatic");
  pass->SetRasterizationToExact();
  const rtw::ShadowErrors exact = stage.Compare("exact");
  pass->SetRasterizationToLinear();
  const rtw::ShadowErrors linear = stage.Compare("linear");
  pass->SetRasterizationToTessellated();
  double wrong[3];
  const double lengths[] = { 0.05, 0.025, 0.01 };
  for (int i = 0; i < 3; ++i)
  {
    pass->SetMaximumEdgeLength(lengths[i]);
    const rtw::ShadowErrors errors = stage.Compare("tessellated");
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
  const rtw::ShadowErrors a = coarse.Compare("two triangles"),
                          b = fine.Compare("a million triangles");
  RTW_CHECK_NEAR(a.Percent(a.Wrong()), b.Percent(b.Wrong()), 0.02);
}
}

int TestShadowRasterization(int, char*[])
{
  TestAll();
  TestFineFloor();
  return rtwTestResult();
}
