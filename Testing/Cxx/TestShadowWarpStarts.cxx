// SPDX-License-Identifier: BSD-3-Clause
// Warping functions start anew after cuts, and follow the last frame of their own light and
// viewport only.
#include "rtwWarpViews.h"

#include "vtkRenderPass.h"

#include <functional>
#include <iostream>

namespace
{
using rtw::WarpingFunction;

// Each of these makes a frame start anew; a small move doesn't.
void TestStartingAnew(double blending, bool snapping)
{
  const std::function<void(rtwWarpViews&)> changes[] = {
    [](rtwWarpViews& v) { v.Camera->Azimuth(20); },
    [](rtwWarpViews& v) { v.Camera->Zoom(1.3); },
    [](rtwWarpViews& v) { v.Camera->ParallelProjectionOn(); },
    [](rtwWarpViews& v) { v.Window->SetSize(280, 220); },
    [](rtwWarpViews& v) { v.Sun->SetPosition(2.9, 5, 2); },
    [](rtwWarpViews& v) { v.AddSun(1, 5, -1); },
    [](rtwWarpViews& v) { v.Following->SetResolution(512); },
    [](rtwWarpViews& v) {
      v.Following->SetBlurSigma(4);
      v.Plain->SetBlurSigma(4);
    },
    [](rtwWarpViews& v) {
      v.Following->SetImportanceResolution(300);
      v.Plain->SetImportanceResolution(300);
    },
    [](rtwWarpViews& v) { v.Following->ReleaseGraphicsResources(v.Window); },
  };
  int number = 0;
  for (const auto& change : changes)
  {
    rtwWarpViews views;
    views.Following->FocusOnViewOff(); // so that all have one focus
    views.Plain->FocusOnViewOff();
    views.Following->SetTemporalBlending(blending);
    views.Following->SetSnapping(snapping);
    views.Follow();
    views.Camera->Azimuth(1);
    const double followed = rtwDifference(views.Follow(), views.Forget());
    change(views);
    const double anew = rtwDifference(views.Follow(), views.Forget());
    std::cout << "change " << number++ << ": off by " << followed << " before, by " << anew
              << " after" << std::endl;
    RTW_CHECK(followed > 1e-4);
    RTW_CHECK(anew < 1e-5);
  }
}

// The other light's functions go on following.
void TestOneLightMoves()
{
  rtwWarpViews views;
  views.Following->FocusOnViewOff(); // so that both have one focus
  views.Plain->FocusOnViewOff();
  views.Following->SetTemporalBlending(0.9);
  views.Follow();
  views.Camera->Azimuth(1);
  views.Sun->SetPosition(2.9, 5, 2);
  views.Follow();
  views.Forget();
  RTW_CHECK(rtwDifference(views.WarpOf(views.Following, 0), views.WarpOf(views.Plain, 0)) < 1e-5);
  RTW_CHECK(rtwDifference(views.WarpOf(views.Following, 1), views.WarpOf(views.Plain, 1)) > 1e-3);
}

// Two viewports side by side, whose cameras go different ways.
struct Pair
{
  Pair()
  {
    for (rtwWarpViews* views : { &this->Left, &this->Right })
    {
      views->Following->FocusOnViewOff(); // so that all have one focus
      views->Plain->FocusOnViewOff();
      views->Following->SetTemporalBlending(0.9);
    }
    this->Left.Window->SetSize(600, 200);
    this->Left.Renderer->SetViewport(0, 0, 0.5, 1);
    this->Right.Window->RemoveRenderer(this->Right.Renderer);
    this->Right.Renderer->SetViewport(0.5, 0, 1, 1);
    this->Left.Window->AddRenderer(this->Right.Renderer);
    this->Right.Camera->Azimuth(1.5);
  }
  ~Pair() { this->Left.Window->RemoveRenderer(this->Right.Renderer); }

  void Move()
  {
    this->Left.Camera->Azimuth(1);
    this->Right.Camera->Azimuth(-1);
  }

  // What this frame alone wants, left and right.
  std::array<rtwWarp, 2> Forget()
  {
    this->Left.Renderer->SetPass(this->Left.PlainSteps);
    this->Right.Renderer->SetPass(this->Right.PlainSteps);
    this->Left.Render();
    this->Left.UsePass(true);
    this->Right.UsePass(true);
    return { this->Left.WarpOf(this->Left.Plain, 0), this->Right.WarpOf(this->Right.Plain, 0) };
  }

  rtwWarpViews Left, Right;
};

void TestViewports()
{
  Pair pair;
  pair.Left.Render();
  std::array<rtwWarp, 2> last = pair.Forget();
  for (int frame = 0; frame < 2; ++frame)
  {
    pair.Move();
    const std::array<rtwWarp, 2> wanted = pair.Forget();
    pair.Left.Render();
    const std::array<rtwWarp, 2> is = { pair.Left.WarpOf(pair.Left.Following, 0),
      pair.Right.WarpOf(pair.Right.Following, 0) };
    for (int view = 0; view < 2; ++view)
    {
      RTW_CHECK(rtwDifference(is[view], wanted[view]) > 1e-4);
      for (int axis = 0; axis < 2; ++axis)
      {
        const WarpingFunction twin =
          wanted[view].Along[axis].BlendedWith(last[view].Along[axis], 0, 1, 0.9);
        RTW_CHECK(rtwDifference(is[view].Along[axis], twin) < 2e-5);
      }
    }
    last = is;
  }
}

// A pass that two viewports share does not take one for what the other was.
void TestSharedPass()
{
  Pair pair;
  pair.Right.Renderer->SetPass(pair.Left.Renderer->GetPass());
  for (int frame = 0; frame < 2; ++frame)
  {
    pair.Move();
    pair.Left.Render();
    const rtwWarp last = pair.Left.WarpOf(pair.Left.Following, 0);
    vtkRenderPass* const shared = pair.Left.Renderer->GetPass();
    RTW_CHECK(rtwDifference(last, pair.Forget()[1]) < 1e-5);
    pair.Right.Renderer->SetPass(shared);
  }
}
}

int TestShadowWarpStarts(int, char*[])
{
  TestStartingAnew(0.9, false);
  TestStartingAnew(0, true);
  TestOneLightMoves();
  TestViewports();
  TestSharedPass();
  return rtwTestResult();
}
