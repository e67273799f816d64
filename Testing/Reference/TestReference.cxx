// SPDX-License-Identifier: BSD-3-Clause
// What shadows a renderer's props throw, and the numbers of known scenes.
#include "rtwScene.h"
#include "rtwStage.h"

#include <vtkLightCollection.h>
#include <vtkPlane.h>
#include <vtkProperty.h>

#include <gtest/gtest.h>

#include <ostream>
#include <string>

TEST(Reference, OnlyVisibleSurfacesCount)
{
  Stage stage;
  EXPECT_EQ(stage.Shadowed(), 0u);
  const auto ball = MakeBall(0);
  stage.Renderer->AddActor(ball);
  const size_t whole = stage.Shadowed();
  EXPECT_GT(whole, 100u);
  ball->VisibilityOff();
  EXPECT_EQ(stage.Shadowed(), 0u);
  ball->VisibilityOn();
  ball->GetProperty()->SetRepresentationToWireframe();
  EXPECT_EQ(stage.Shadowed(), 0u);
  ball->GetProperty()->SetRepresentationToSurface();
  EXPECT_EQ(stage.Shadowed(), whole);
}

TEST(Reference, PropsMayCastOrReceiveNoShadows)
{
  Stage stage;
  const auto ball = MakeBall(0);
  stage.Renderer->AddActor(ball);
  rtw::ReferenceOptions options;
  options.Casts = [&](vtkProp* prop) { return prop != ball; };
  EXPECT_EQ(stage.Shadowed(options), 0u);
  const rtw::Truth bright = stage.Trace(options), usual = stage.Trace();
  EXPECT_EQ(bright.Depth, usual.Depth); // it is seen all the same
  options = {};
  options.Receives = [&](vtkProp* prop) { return prop != stage.Ground; };
  const rtw::Truth truth = stage.Trace(options);
  EXPECT_EQ(truth.Mask[0], rtw::MASK_AVERTED);
  EXPECT_EQ(usual.Mask[0], rtw::MASK_LIT);
}

TEST(Reference, TranslucentPropsAreUnseenAndCast)
{
  Stage stage;
  const rtw::Truth empty = stage.Trace();
  const auto ball = MakeBall(0);
  ball->GetProperty()->SetOpacity(0.5);
  stage.Renderer->AddActor(ball);
  const rtw::Truth truth = stage.Trace();
  EXPECT_EQ(truth.Depth, empty.Depth);
  EXPECT_GT(Differences(truth, empty), 100u);
}

TEST(Reference, CullingAndClippingAreHeeded)
{
  Stage stage;
  const auto ball = MakeBall(0);
  ball->GetProperty()->FrontfaceCullingOn();
  stage.Renderer->AddActor(ball);
  const rtw::Truth inside = stage.Trace();
  ball->GetProperty()->FrontfaceCullingOff();
  const rtw::Truth outside = stage.Trace();
  size_t deeper = 0;
  for (size_t i = 0; i < inside.Depth.size(); ++i)
  {
    EXPECT_GE(inside.Depth[i], outside.Depth[i]);
    deeper += inside.Depth[i] > outside.Depth[i];
  }
  EXPECT_GT(deeper, 100u);

  vtkNew<vtkPlane> plane; // keeps what is right of it
  plane->SetNormal(1, 0, 0);
  const size_t whole = stage.Shadowed();
  ball->GetMapper()->AddClippingPlane(plane);
  const size_t half = stage.Shadowed();
  EXPECT_GT(half, whole / 4);
  EXPECT_LT(half, whole * 4 / 5);
}

TEST(Reference, ProgressEndsAndThreadsDoNotMatter)
{
  Stage stage;
  stage.Renderer->AddActor(MakeBall(0));
  rtw::ReferenceOptions options;
  double last = 0;
  options.Progress = [&last](double share) { last = share; };
  options.Threads = 1;
  const rtw::Truth one = stage.Trace(options);
  EXPECT_EQ(last, 1);
  options.Threads = 5;
  const rtw::Truth five = stage.Trace(options);
  EXPECT_EQ(one.Mask, five.Mask);
  EXPECT_EQ(one.Depth, five.Depth);
}

TEST(Reference, TheCameraMayMove)
{
  Stage stage;
  stage.Renderer->AddActor(MakeBall(0));
  const rtw::ShadowReference before(stage.Renderer);
  const rtw::Truth unmoved = before.Trace(stage.Light, 120, 90);
  stage.Renderer->GetActiveCamera()->SetPosition(3, 7, 10);
  stage.Renderer->GetActiveCamera()->SetFocalPoint(0, 1, 0);
  const rtw::Truth moved = before.Trace(stage.Light, 120, 90), expected = stage.Trace();
  EXPECT_GT(Differences(unmoved, expected), 500u);
  EXPECT_LE(Differences(moved, expected), 2u);
  for (size_t i = 0; i < expected.Depth.size(); i += 7)
  {
    EXPECT_NEAR(moved.Depth[i], expected.Depth[i], 1e-5);
  }
}

TEST(Reference, AnEmptyRendererIsBackground)
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkLight> light;
  const rtw::Truth truth = rtw::ShadowReference(renderer).Trace(light, 3, 2);
  EXPECT_EQ(truth.Mask, std::vector<unsigned char>(6, rtw::MASK_BACKGROUND));
}

namespace
{
// What another exact tracer, in world coordinates, counted at 1024 x 1024 pixels.
struct Headline
{
  const char* Name;
  double LitFacing;
  double ShadowedPercent;
  double AtEdgePercent;
};

void PrintTo(const Headline& known, std::ostream* out)
{
  *out << known.Name;
}

class KnownShadows : public testing::TestWithParam<Headline>
{
};
}

TEST_P(KnownShadows, AreCounted)
{
  const Headline& known = GetParam();
  const rtw::Scene scene = rtw::MakeScene(known.Name);
  vtkNew<vtkRenderer> renderer;
  rtw::AddToRenderer(scene, renderer);
  auto* light = vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(0));
  const rtw::Truth truth = rtw::ShadowReference(renderer).Trace(light, 1024, 1024);
  const rtw::ShadowErrors errors = rtw::Compare(truth.Mask, truth);
  EXPECT_NEAR(double(errors.LitFacing), known.LitFacing, 0.0002 * known.LitFacing);
  EXPECT_NEAR(errors.Percent(errors.Shadowed), known.ShadowedPercent, 0.02);
  EXPECT_NEAR(errors.Percent(errors.AtEdge), known.AtEdgePercent, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Reference, KnownShadows,
  testing::Values(Headline{ "town", 546644, 18.97, 10.77 },
    Headline{ "sandbox", 573441, 22.89, 7.53 }, Headline{ "furball", 1030645, 14.58, 19.31 },
    Headline{ "playground", 637914, 8.55, 6.97 }, Headline{ "duel", 556218, 38.52, 11.89 },
    Headline{ "robot", 1009768, 38.12, 4.47 }),
  [](const auto& info) { return std::string(info.param.Name); });
