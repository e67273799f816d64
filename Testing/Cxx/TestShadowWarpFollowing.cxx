// SPDX-License-Identifier: BSD-3-Clause
// Warping functions that follow the last frame's: as their twin says, in moving and still views.
#include "rtwWarpViews.h"

#include <cmath>
#include <iostream>
#include <string>

namespace
{
using rtw::WarpingFunction;

void TestBlendingTwin(int light)
{
  rtwWarpViews views;
  views.Following->SetTemporalBlending(0.6);
  views.Following->FocusOnViewOff(); // so that both have one focus
  views.Plain->FocusOnViewOff();
  rtwWarp last = views.Follow(light);
  RTW_CHECK(rtwDifference(last, views.Forget(light)) < 1e-5);
  for (int frame = 0; frame < 5; ++frame)
  {
    views.Camera->Azimuth(0.7);
    views.Camera->Dolly(1.005);
    if (frame == 2)
    {
      views.AddBox(6.5, 0.5, 1, 1); // beside the focus so far, which grows
    }
    const rtwWarp wanted = views.Forget(light), blended = views.Follow(light);
    const std::array<glm::dvec2, 2> ends = rtwEndsIn(last, blended);
    double most = 0;
    for (int axis = 0; axis < 2; ++axis)
    {
      const WarpingFunction twin =
        wanted.Along[axis].BlendedWith(last.Along[axis], ends[axis].x, ends[axis].y, 0.6);
      most = std::max(most, rtwDifference(blended.Along[axis], twin));
    }
    const double moved = rtwDifference(blended, wanted);
    std::cout << "light " << light << ", blended, off the twin by " << most
              << ", off what is wanted by " << moved << std::endl;
    RTW_CHECK(most < 2e-5);
    RTW_CHECK(moved > 1e-3);
    last = blended;
  }
}

// The focus that a frame needs is that of the pass that forgets.
void TestSnappingTwin(int light, bool focused)
{
  rtwWarpViews views;
  views.Following->SnappingOn();
  views.Following->SetFocusOnView(focused);
  views.Plain->SetFocusOnView(focused);
  rtwWarp last = views.Follow(light);
  int kept = 0, changed = 0;
  for (int frame = 0; frame < 24; ++frame)
  {
    views.Camera->Azimuth(0.8);
    views.Camera->Zoom(frame < 12 ? 1.012 : 0.98);
    const rtwWarp wanted = views.Forget(light), snapped = views.Follow(light);
    const std::array<glm::dvec2, 2> was = rtwEndsIn(wanted, last), is = rtwEndsIn(wanted, snapped),
                                    stayed = rtwEndsIn(last, snapped);
    for (int axis = 0; axis < 2; ++axis)
    {
      const glm::dvec2 twin = focused ? rtw::SnappedEnds({ 0, 1 }, &was[axis]) : glm::dvec2(0, 1);
      RTW_CHECK_NEAR(is[axis].x, twin.x, 1e-4);
      RTW_CHECK_NEAR(is[axis].y, twin.y, 1e-4);
      const bool sameFocus = glm::length(stayed[axis] - glm::dvec2(0, 1)) < 1e-4;
      const bool same = sameFocus && rtwDifference(snapped.Along[axis], last.Along[axis]) == 0;
      ++(same ? kept : changed);
      if (!focused)
      {
        // Here cells are those of the pass that forgets.
        const double excess = last.Along[axis].ExcessOver(wanted.Along[axis]);
        const double from = rtwDifference(snapped.Along[axis], wanted.Along[axis]);
        RTW_CHECK(same || from < 1e-5);
        RTW_CHECK(same == (excess <= rtw::SnappingMostExcess) ||
          std::abs(excess - rtw::SnappingMostExcess) < 1e-3);
      }
    }
    last = snapped;
  }
  std::cout << "light " << light << (focused ? ", focused" : ", all of the scene")
            << ": functions kept " << kept << " times, changed " << changed << " times"
            << std::endl;
  RTW_CHECK(kept >= 24);
  RTW_CHECK(changed >= 1);
}

// A still view comes to what it wants, and then draws nothing any more.
void TestSettling(double blending, bool snapping, bool previousFrame)
{
  rtwWarpViews views;
  views.Following->CachingOn();
  views.Following->SetTemporalBlending(blending);
  views.Following->SetSnapping(snapping);
  views.Following->SetFocusOnView(snapping);
  views.Plain->SetFocusOnView(snapping);
  views.Following->SetViewSampleSource(
    previousFrame ? vtkAdaptiveShadowMapPass::PREVIOUS_FRAME : vtkAdaptiveShadowMapPass::PREPASS);
  views.Follow();
  for (int frame = 0; frame < 3; ++frame)
  {
    views.Camera->Azimuth(1);
    views.Follow();
  }
  int frames = 1;
  for (views.Render(); views.Following->GetNumberOfLayersDrawn() > 0 && frames < 200; ++frames)
  {
    views.Render();
  }
  const rtwWarp settled = views.WarpOf(views.Following, 0);
  const double off = rtwDifference(settled, views.Forget());
  std::cout << "blending " << blending << ", snapping " << snapping << ": settled after " << frames
            << " still frames, off by " << 1024 * off << " texels" << std::endl;
  // The frame that moved counts too, unless its samples were those of another view.
  RTW_CHECK_EQUAL(frames, rtw::FramesToSettle(blending, 1024) + (previousFrame ? 1 : 0));
  if (!snapping && !previousFrame)
  {
    RTW_CHECK(1024 * off < 0.3);
  }
  for (int i = 0; i < 3; ++i)
  {
    views.Render();
    RTW_CHECK_EQUAL(views.Following->GetNumberOfLayersDrawn(), 0);
    RTW_CHECK_EQUAL(views.Following->GetNumberOfLayersReused(), 2);
  }
  views.Name = "settled";
  RTW_CHECK_SHADOWS(views, views.Sun, 0);
  RTW_CHECK_SHADOWS(views, views.Spot, 1);
  RTW_CHECK_PICTURE(views);
}

// Shadows are right all along a path with fast and slow parts and cuts.
void TestPath(double blending, bool snapping)
{
  rtwWarpViews views;
  views.Following->CachingOn();
  views.Following->CullEmptyCellsOn();
  views.Following->SetTemporalBlending(blending);
  views.Following->SetSnapping(snapping);
  rtwShadowBounds bounds;
  bounds.Wrong = 0.06;
  bounds.Shadowed = 1;
  const double steps[] = { 0.3, 0.3, 2, 2.5, -2, 40, 0.2, 0, 0, 7, 1 };
  for (const double step : steps)
  {
    views.Camera->Azimuth(step);
    views.Render();
    views.Name = "after " + std::to_string(step) + " degrees, blending " +
      std::to_string(blending) + ", snapping " + std::to_string(snapping);
    RTW_CHECK_SHADOWS_WITHIN(views, views.Sun, 0, bounds);
    RTW_CHECK_SHADOWS_WITHIN(views, views.Spot, 1, bounds);
  }
}
}

int TestShadowWarpFollowing(int, char*[])
{
  for (int light = 0; light < 2; ++light)
  {
    TestBlendingTwin(light);
    TestSnappingTwin(light, true);
    TestSnappingTwin(light, false);
  }
  TestSettling(0, true, false);
  TestSettling(0.5, false, false);
  TestSettling(0.9, true, false);
  TestSettling(0.5, true, true);
  TestPath(0.9, true);
  return rtwTestResult();
}
