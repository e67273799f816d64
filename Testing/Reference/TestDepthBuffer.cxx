// SPDX-License-Identifier: BSD-3-Clause
// What the reference sees is what OpenGL draws.
#include "rtwReference.h"
#include "rtwScene.h"

#include <vtkRTWEGLRenderWindow.h>

#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
// The share of pixels whose depths, as distances to the eye, differ by less than a thousandth.
double Agreement(const rtw::Truth& truth, const std::vector<float>& drawn, double farOverNear)
{
  const double slope = 1 - 1 / farOverNear;
  size_t agree = 0;
  for (size_t i = 0; i < drawn.size(); ++i)
  {
    const bool isEmpty = truth.Depth[i] == 1, isDrawnEmpty = drawn[i] == 1;
    // 1 / distance is linear in the depth.
    const double ratio = (1 - slope * drawn[i]) / (1 - slope * truth.Depth[i]);
    agree += isEmpty || isDrawnEmpty ? isEmpty == isDrawnEmpty : std::abs(ratio - 1) < 1e-3;
  }
  return double(agree) / double(drawn.size());
}
}

namespace
{
// OpenGL rounds corners to a fraction of a pixel, so that some pixels at edges are bound to differ:
// the fewer, the larger the picture.
constexpr int WIDTH = 600, HEIGHT = 400;

std::vector<float> DrawDepth(vtkRenderer* renderer, vtkRenderWindow* window)
{
  window->SetMultiSamples(0);
  window->SetSize(WIDTH, HEIGHT);
  window->AddRenderer(renderer);
  window->Render();
  std::vector<float> depth(size_t(WIDTH) * HEIGHT);
  window->GetZbufferData(0, 0, WIDTH - 1, HEIGHT - 1, depth.data());
  window->RemoveRenderer(renderer);
  return depth;
}

class DepthBuffer : public testing::TestWithParam<std::string>
{
};
}

TEST_P(DepthBuffer, IsWhatTheReferenceSees)
{
  vtkNew<vtkRTWEGLRenderWindow> window;
  if (!window->SupportsOpenGL())
  {
    GTEST_SKIP() << "no OpenGL here";
  }
  const rtw::Scene scene = rtw::MakeScene(GetParam());
  vtkNew<vtkRenderer> whole, pieces;
  rtw::AddToRenderer(scene, whole);
  rtw::AddToRenderer(scene, pieces, 5);
  auto* light = vtkLight::SafeDownCast(whole->GetLights()->GetItemAsObject(0));
  const rtw::Truth truth = rtw::ShadowReference(whole).Trace(light, WIDTH, HEIGHT);
  const double farOverNear = scene.Camera.Far / scene.Camera.Near;
  EXPECT_GT(Agreement(truth, DrawDepth(whole, window), farOverNear), 0.999);
  EXPECT_GT(Agreement(truth, DrawDepth(pieces, window), farOverNear), 0.999);
}

INSTANTIATE_TEST_SUITE_P(Reference, DepthBuffer, testing::ValuesIn(rtw::SceneNames()),
  [](const auto& info) { return info.param; });
