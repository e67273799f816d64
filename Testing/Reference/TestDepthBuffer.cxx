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

TEST(Reference, SeesWhatIsDrawn)
{
  const int width = 300, height = 200;
  vtkNew<vtkRTWEGLRenderWindow> window;
  if (!window->SupportsOpenGL())
  {
    GTEST_SKIP() << "no OpenGL here";
  }
  for (const char* name : { "sandbox", "robot", "duel" })
  {
    const rtw::Scene scene = rtw::MakeScene(name);
    vtkNew<vtkRenderer> renderer;
    rtw::AddToRenderer(scene, renderer);
    window->SetMultiSamples(0);
    window->SetSize(width, height);
    window->AddRenderer(renderer);
    window->Render();
    std::vector<float> depth(size_t(width) * height);
    window->GetZbufferData(0, 0, width - 1, height - 1, depth.data());
    auto* light = vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(0));
    const rtw::Truth truth = rtw::ShadowReference(renderer).Trace(light, width, height);
    EXPECT_GT(Agreement(truth, depth, scene.Camera.Far / scene.Camera.Near), 0.998) << name;
    window->RemoveRenderer(renderer);
  }
}
