// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMapTexels.h"
#include "rtwScene.h"
#include "rtwStage.h"

#include <vtkImageData.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkNoTWShadowMapPass.h>
#include <vtkPerspectiveShadowMapPass.h>
#include <vtkRTWEGLRenderWindow.h>
#include <vtkRTWShadowMapPass.h>
#include <vtkShadowRenderStepsPass.h>
#include <vtkUniformShadowMapPass.h>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
constexpr int WIDTH = 120, HEIGHT = 90;

std::vector<rtw::ViewSample> SamplesOf(Stage& stage)
{
  return rtw::ShadowReference(stage.Renderer).Samples(stage.Light, WIDTH, HEIGHT);
}

// Looks at the ground from above, so that all pixels are as wide there.
class FromAbove : public Stage
{
public:
  FromAbove()
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0, 6, 0);
    camera->SetViewUp(0, 0, -1);
    camera->SetViewAngle(40);
    this->PixelWidth = 2 * 6 * std::tan(glm::radians(20.0)) / HEIGHT;
  }
  double PixelWidth;
};
}

TEST(Aliasing, SamplesAreThePixelsThatFaceTheLight)
{
  Stage stage;
  stage.Renderer->AddActor(MakeBall(0));
  const rtw::Truth truth = stage.Trace();
  const std::vector<rtw::ViewSample> samples = SamplesOf(stage);
  EXPECT_EQ(samples.size(), rtw::Compare(truth.Mask, truth).LitFacing);
  for (const rtw::ViewSample& sample : samples)
  {
    ASSERT_TRUE(
      truth.Mask[sample.Pixel] == rtw::MASK_LIT || truth.Mask[sample.Pixel] == rtw::MASK_SHADOW);
  }
}

TEST(Aliasing, IsTheRatioOfWidthsOnAPlane)
{
  FromAbove stage;
  const std::vector<rtw::ViewSample> samples = SamplesOf(stage);
  EXPECT_EQ(samples.size(), size_t(WIDTH) * HEIGHT);
  // Texels are 1/8 wide along x and 1/20 along z.
  const auto texels = [](const glm::dvec3& p) { return glm::dvec2(8 * p.x, 20 * p.z); };
  const rtw::AliasingError error = rtw::Summarize(rtw::AliasingErrors(samples, texels));
  EXPECT_EQ(error.Pixels, samples.size());
  const double expected = 0.125 / stage.PixelWidth;
  EXPECT_NEAR(error.Maximum / expected, 1, 1e-6);
  EXPECT_NEAR(error.Mean / expected, 1, 1e-6);
  EXPECT_NEAR(error.Percentile95 / expected, 1, 1e-6);
}

TEST(Aliasing, GrowsWhereTheMapIsCoarser)
{
  FromAbove stage;
  const std::vector<rtw::ViewSample> samples = SamplesOf(stage);
  // A warp gives what lies beyond x = 0 three times the texels.
  const auto texels = [](const glm::dvec3& p) {
    return glm::dvec2(p.x > 0 ? 30 * p.x : 10 * p.x, 1000 * p.z);
  };
  const std::vector<double> errors = rtw::AliasingErrors(samples, texels);
  for (size_t i = 0; i < samples.size(); ++i)
  {
    const double density = samples[i].Position.x > 0 ? 30 : 10;
    ASSERT_NEAR(errors[i] * density * stage.PixelWidth, 1, 1e-6);
  }
}

// Lloyd et al.'s approximation for narrow beams: wl / wi * cos(theta_i) / cos(theta_l).
TEST(Aliasing, IsPerspectiveTimesProjection)
{
  Stage stage;
  stage.Renderer->GetActiveCamera()->SetPosition(0, 6, 8); // 10 away
  const std::vector<rtw::ViewSample> samples = SamplesOf(stage);
  const size_t middle = size_t(HEIGHT / 2) * WIDTH + WIDTH / 2;
  const auto sample = std::find_if(samples.begin(), samples.end(),
    [&](const rtw::ViewSample& each) { return each.Pixel == middle; });
  ASSERT_NE(sample, samples.end());
  // Light comes along (0, -3, -4) / 5; texels are 0.1 wide across it, and tiny along x.
  const auto texels = [](const glm::dvec3& p) {
    return glm::dvec2(1e6 * p.x, (p.z * 3 - p.y * 4) / 5 / 0.1);
  };
  const double wi = 2 * 10 * std::tan(glm::radians(15.0)) / HEIGHT;
  const double expected = 0.1 / wi * (6.0 / 10) / (3.0 / 5);
  EXPECT_NEAR(rtw::AliasingErrors({ *sample }, texels)[0] / expected, 1, 0.01);
}

TEST(Aliasing, SummaryIsMaximumMeanAndPercentile)
{
  std::vector<double> errors(100);
  std::iota(errors.begin(), errors.end(), 1);
  std::reverse(errors.begin(), errors.end());
  errors.push_back(0); // not defined there
  const rtw::AliasingError error = rtw::Summarize(errors);
  EXPECT_EQ(error.Pixels, 100u);
  EXPECT_EQ(error.Maximum, 100);
  EXPECT_EQ(error.Mean, 50.5);
  EXPECT_EQ(error.Percentile95, 95);
  EXPECT_EQ(rtw::Summarize({}).Maximum, 0);
}

namespace
{
// A scene under a pass, drawn once.
class Drawn
{
public:
  Drawn(
    const rtw::Scene& scene, vtkSmartPointer<vtkAdaptiveShadowMapPass> pass, unsigned resolution)
    : Pass(pass)
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(WIDTH, HEIGHT);
    this->Window->AddRenderer(this->Renderer);
    rtw::AddToRenderer(scene, this->Renderer);
    this->Pass->SetResolution(resolution);
    this->Steps->SetShadowMapPass(this->Pass);
    this->Renderer->SetPass(this->Steps);
    this->Window->Render();
    auto* light = vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
    const rtw::ShadowReference reference(this->Renderer);
    this->Samples = reference.Samples(light, WIDTH, HEIGHT);
    this->Truth = reference.Trace(light, WIDTH, HEIGHT);
  }
  ~Drawn()
  {
    this->Steps->ReleaseGraphicsResources(this->Window);
    this->Renderer->SetPass(nullptr);
  }

  rtw::AliasingError Error()
  {
    return rtw::Summarize(rtw::AliasingErrors(this->Samples, rtw::TexelsOf(this->Pass, 0)));
  }

  // The share of lit samples whose depth is the one on the map, where they are said to lie.
  double ShareOnMap()
  {
    const rtw::TexelFunction texels = rtw::TexelsOf(this->Pass, 0);
    vtkNew<vtkMatrix4x4> matrix;
    EXPECT_TRUE(this->Pass->GetLightPlaneMatrix(0, 0, matrix));
    const vtkSmartPointer<vtkImageData> map = this->Pass->GetShadowMapImage(0);
    size_t lit = 0, same = 0;
    for (const rtw::ViewSample& sample : this->Samples)
    {
      if (this->Truth.Mask[sample.Pixel] == rtw::MASK_LIT)
      {
        const glm::ivec2 texel(glm::floor(texels(sample.Position)));
        const double at[4] = { sample.Position.x, sample.Position.y, sample.Position.z, 1 };
        double p[4];
        matrix->MultiplyPoint(at, p);
        const int* const size = map->GetDimensions();
        ++lit;
        // Some lie a little beside it, because the view is sampled for its focus.
        if (texel.x >= 0 && texel.y >= 0 && texel.x < size[0] && texel.y < size[1])
        {
          const float depth = *static_cast<float*>(map->GetScalarPointer(texel.x, texel.y, 0));
          same += std::abs(depth - p[2] / p[3]) < 2e-3;
        }
      }
    }
    return double(same) / double(lit);
  }

private:
  vtkNew<vtkRTWEGLRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkShadowRenderStepsPass> Steps;
  vtkSmartPointer<vtkAdaptiveShadowMapPass> Pass;
  std::vector<rtw::ViewSample> Samples;
  rtw::Truth Truth;
};

template <class Pass>
vtkSmartPointer<Pass> New()
{
  return vtkSmartPointer<Pass>::New();
}

bool HasOpenGL()
{
  return vtkNew<vtkRTWEGLRenderWindow>()->SupportsOpenGL();
}

class MapTexels : public testing::TestWithParam<const char*>
{
};
}

TEST_P(MapTexels, LieWhereTheMapHasWhatTheySee)
{
  if (!HasOpenGL())
  {
    GTEST_SKIP() << "no OpenGL here";
  }
  const rtw::Scene scene = rtw::MakeScene(GetParam());
  EXPECT_GT(Drawn(scene, New<vtkRTWShadowMapPass>(), 1024).ShareOnMap(), 0.97);
  EXPECT_GT(Drawn(scene, New<vtkNoTWShadowMapPass>(), 1024).ShareOnMap(), 0.97);
  EXPECT_GT(Drawn(scene, New<vtkPerspectiveShadowMapPass>(), 1024).ShareOnMap(), 0.97);
  EXPECT_GT(Drawn(scene, New<vtkUniformShadowMapPass>(), 1024).ShareOnMap(), 0.97);
}

INSTANTIATE_TEST_SUITE_P(Aliasing, MapTexels, testing::Values("sandbox", "robot"),
  [](const auto& info) { return std::string(info.param); });

TEST(Aliasing, IsHalvedByTwiceTheTexels)
{
  if (!HasOpenGL())
  {
    GTEST_SKIP() << "no OpenGL here";
  }
  const rtw::Scene scene = rtw::MakeScene("duel");
  const rtw::AliasingError coarse = Drawn(scene, New<vtkUniformShadowMapPass>(), 512).Error();
  const rtw::AliasingError fine = Drawn(scene, New<vtkUniformShadowMapPass>(), 1024).Error();
  EXPECT_GT(coarse.Maximum, coarse.Percentile95);
  EXPECT_GT(coarse.Percentile95, coarse.Mean);
  EXPECT_NEAR(coarse.Maximum / fine.Maximum, 2, 0.02);
  EXPECT_NEAR(coarse.Mean / fine.Mean, 2, 0.02);
  EXPECT_NEAR(coarse.Percentile95 / fine.Percentile95, 2, 0.02);
  // The warp is there to lower it.
  const rtw::AliasingError warped = Drawn(scene, New<vtkRTWShadowMapPass>(), 1024).Error();
  EXPECT_LT(3 * warped.Mean, fine.Mean);
}

TEST(Aliasing, ThereAreNoTexelsOfALightThatThereIsNot)
{
  const auto pass = New<vtkRTWShadowMapPass>();
  EXPECT_FALSE(rtw::TexelsOf(pass, 0));
  vtkNew<vtkMatrix4x4> matrix;
  EXPECT_FALSE(pass->GetLightPlaneMatrix(0, 0, matrix));
  EXPECT_FALSE(pass->GetLightPlaneMatrix(0, 0, nullptr));
}
