// SPDX-License-Identifier: BSD-3-Clause
// What cameras and lights see along their paths.
#include "rtwCollect.h"
#include "rtwCompare.h"
#include "rtwScene.h"
#include "rtwTracer.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

namespace
{
constexpr int FRAMES = 60, SIZE = 80;

class ScenePaths : public testing::TestWithParam<std::string>
{
protected:
  ScenePaths()
    : Scene(rtw::MakeScene(this->GetParam()))
  {
    rtw::AddToRenderer(this->Scene, this->Renderer);
    this->Light = vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
  }

  rtw::Scene Scene;
  vtkNew<vtkRenderer> Renderer;
  vtkLight* Light;
};

// To something in any of many directions.
double Clearance(const rtw::Tracer& tracer, const glm::dvec3& position)
{
  const int directions = 100;
  double nearest = 1e9;
  for (int k = 0; k < directions; ++k)
  {
    const double y = 1 - (2 * k + 1.0) / directions, angle = 2.39996 * k; // a spiral on a sphere
    const double across = std::sqrt(1 - y * y);
    const rtw::Ray ray{ position, { across * std::cos(angle), y, across * std::sin(angle) }, 0,
      1e6 };
    if (const auto hit = tracer.First(ray))
    {
      nearest = std::min(nearest, hit->Distance);
    }
  }
  return nearest;
}
}

TEST_P(ScenePaths, GoThroughNoWalls)
{
  const rtw::Tracer tracer(rtw::Collect(this->Renderer, {}));
  const glm::dvec3 origin = tracer.Scene().Origin;
  for (int frame = 0; frame < FRAMES; ++frame)
  {
    const glm::dvec3 from =
      rtw::CameraOnPath(this->Scene, frame / double(FRAMES)).Position - origin;
    const glm::dvec3 to =
      rtw::CameraOnPath(this->Scene, (frame + 1) / double(FRAMES)).Position - origin;
    const double length = glm::distance(from, to);
    ASSERT_GT(length, 0);
    EXPECT_FALSE(tracer.First({ from, (to - from) / length, 0, length })) << "frame " << frame;
    EXPECT_GT(Clearance(tracer, from), this->Scene.Camera.Near) << "frame " << frame;
  }
}

TEST_P(ScenePaths, ShowLightAndShadowAllAlong)
{
  const rtw::ShadowReference reference(this->Renderer);
  for (int step = 0; step < 6; ++step)
  {
    rtw::Apply(rtw::CameraOnPath(this->Scene, step / 6.0), this->Renderer->GetActiveCamera());
    rtw::Apply(rtw::LightOnPath(this->Scene, step / 6.0), this->Scene, this->Light);
    const rtw::Truth truth = reference.Trace(this->Light, SIZE, SIZE);
    const rtw::ShadowErrors seen = rtw::Compare(truth.Mask, truth);
    EXPECT_GT(double(seen.LitFacing) / (SIZE * SIZE), 0.3) << "step " << step;
    EXPECT_GT(seen.Percent(seen.Shadowed), 3) << "step " << step;
    EXPECT_LT(seen.Percent(seen.Shadowed), 70) << "step " << step;
  }
}

// A tenth of a pixel does less to the truth than a whole one.
TEST_P(ScenePaths, TinyMovesChangeTheTruthLess)
{
  this->Scene.Size[1] = SIZE;
  const rtw::ShadowReference reference(this->Renderer);
  const auto trace = [&](int frame) {
    rtw::Apply(rtw::CameraOnTinyPath(this->Scene, frame), this->Renderer->GetActiveCamera());
    return reference.Trace(this->Light, SIZE, SIZE);
  };
  const auto changes = [](const rtw::Truth& a, const rtw::Truth& b) {
    size_t changed = 0;
    for (size_t i = 0; i < a.Mask.size(); ++i)
    {
      changed += a.Mask[i] != b.Mask[i];
    }
    return changed;
  };
  const rtw::Truth start = trace(0);
  const size_t byTenth = changes(start, trace(1)), byPixel = changes(start, trace(10));
  EXPECT_GT(byTenth, 0u);
  EXPECT_LT(byTenth, byPixel);
}

INSTANTIATE_TEST_SUITE_P(Reference, ScenePaths, testing::ValuesIn(rtw::SceneNames()),
  [](const auto& info) { return info.param; });
