// SPDX-License-Identifier: BSD-3-Clause
#include "rtwScene.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkTriangle.h>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <stdexcept>

namespace
{
// What is known of a scene from elsewhere. The sums are of the coordinates' absolute values.
struct Known
{
  const char* Name;
  vtkIdType Points, Triangles;
  glm::dvec3 Sums;
  double Area;
};

void PrintTo(const Known& known, std::ostream* out)
{
  *out << known.Name;
}

const Known KNOWN[] = {
  { "town", 937457, 505832, { 46731121.829865, 4832782.809959, 133054110.114863 }, 506200.055063 },
  { "sandbox", 17563, 28008, { 32216.479322, 3034.801643, 32470.672084 }, 6508.107363 },
  { "furball", 105387, 98464, { 41771.907622, 41258.604219, 41200.949146 }, 257.378002 },
  { "playground", 350068, 680016, { 1261199.827029, 559115.736767, 959114.744269 }, 6544.969265 },
  { "duel", 61741, 97320, { 342512.257808, 59991.600225, 7105175.168261 }, 92257.020170 },
  { "robot", 9817, 14772, { 24764.699933, 19326.410006, 9169.452164 }, 4136.516335 },
};

class KnownScenes : public testing::TestWithParam<Known>
{
};

class AllScenes : public testing::TestWithParam<std::string>
{
};

glm::dvec3 SumOfCoordinates(vtkPolyData* mesh)
{
  glm::dvec3 sum(0);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    mesh->GetPoint(i, &p.x);
    sum += glm::abs(p);
  }
  return sum;
}

double Area(vtkPolyData* mesh)
{
  double area = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(i, size, ids);
    double corners[3][3];
    for (int k = 0; k < 3; ++k)
    {
      mesh->GetPoint(ids[k], corners[k]);
    }
    area += vtkTriangle::TriangleArea(corners[0], corners[1], corners[2]);
  }
  return area;
}
}

TEST_P(KnownScenes, AreTheSame)
{
  const Known& known = GetParam();
  const rtw::Scene scene = rtw::MakeScene(known.Name);
  EXPECT_EQ(scene.Name, known.Name);
  EXPECT_EQ(scene.Mesh->GetNumberOfPoints(), known.Points);
  EXPECT_EQ(scene.Mesh->GetNumberOfPolys(), known.Triangles);
  const glm::dvec3 sums = SumOfCoordinates(scene.Mesh);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(sums[i], known.Sums[i], 1e-9 * known.Sums[i]);
  }
  EXPECT_NEAR(Area(scene.Mesh), known.Area, 1e-6 * known.Area);
  EXPECT_NEAR(glm::length(scene.Light.Direction), 1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Scenes, KnownScenes, testing::ValuesIn(KNOWN),
  [](const auto& info) { return std::string(info.param.Name); });

TEST(Scenes, TerrainHasTheTrianglesAskedFor)
{
  EXPECT_EQ(rtw::MakeScene("terrain").Mesh->GetNumberOfPolys(), 320000);
  EXPECT_EQ(rtw::MakeScene("terrain", 0.25).Mesh->GetNumberOfPolys(), 80000);
}

TEST(Scenes, ScaleChangesTheTown)
{
  EXPECT_EQ(rtw::MakeScene("town", 0.3).Mesh->GetNumberOfPolys(), 155656);
  EXPECT_EQ(rtw::MakeScene("playground", 0.3).Mesh->GetNumberOfPolys(), 208336);
}

TEST(Scenes, AreTheTenOfTheBenchmark)
{
  const std::vector<std::string> names = { "town", "sandbox", "furball", "playground", "duel",
    "robot", "room", "assembly", "molecule", "terrain" };
  EXPECT_EQ(rtw::SceneNames(), names);
}

TEST_P(AllScenes, HaveAsManyTrianglesAsTheBudgetAllows)
{
  const rtw::Scene usual = rtw::MakeScene(this->GetParam());
  for (const std::size_t budget : { 10000, 60000, 700000 })
  {
    const rtw::Scene scene = rtw::MakeSceneWithBudget(this->GetParam(), budget);
    EXPECT_NEAR(double(rtw::NumberOfTriangles(scene)) / double(budget), 1, 0.15) << budget;
    EXPECT_EQ(scene.Name, this->GetParam());
    EXPECT_EQ(rtw::WriteSettings(scene), rtw::WriteSettings(usual)); // the same view and light
    // And about the same things in it: some leaves may reach farther than others.
    const rtw::SceneBounds bounds = rtw::BoundsOf(scene), usually = rtw::BoundsOf(usual);
    const double size = glm::distance(usually.Low, usually.High);
    EXPECT_LT(glm::distance(bounds.Low, usually.Low), 0.02 * size) << budget;
    EXPECT_LT(glm::distance(bounds.High, usually.High), 0.02 * size) << budget;
  }
}

TEST_P(AllScenes, AreTheSameEachTime)
{
  const rtw::Scene a = rtw::MakeScene(this->GetParam(), 0.5);
  const rtw::Scene b = rtw::MakeScene(this->GetParam(), 0.5);
  EXPECT_EQ(SumOfCoordinates(a.Mesh), SumOfCoordinates(b.Mesh));
  ASSERT_EQ(a.Parts.size(), b.Parts.size());
  for (size_t i = 0; i < a.Parts.size(); ++i)
  {
    EXPECT_EQ(SumOfCoordinates(a.Parts[i].Data), SumOfCoordinates(b.Parts[i].Data));
    EXPECT_EQ(a.Parts[i].Placement, b.Parts[i].Placement);
  }
}

TEST_P(AllScenes, PathsAreSmoothAndClosed)
{
  const rtw::Scene scene = rtw::MakeScene(this->GetParam(), 0.1);
  const auto at = [&](double t) { return rtw::CameraOnPath(scene, t).Position; };
  for (const double t : { 0.0, 1.0 })
  {
    const rtw::SceneCamera camera = rtw::CameraOnPath(scene, t);
    EXPECT_EQ(camera.Position, scene.Camera.Position);
    EXPECT_EQ(camera.Focal, scene.Camera.Focal);
    EXPECT_LT(glm::distance(rtw::LightOnPath(scene, t).Direction, scene.Light.Direction), 1e-12);
    EXPECT_LT(glm::distance(rtw::LightOnPath(scene, t).Position, scene.Light.Position), 1e-12);
  }
  // Steps change by little, over the end too.
  const double step = 1.0 / 240;
  double longest = 0, jerk = 0;
  for (int i = 0; i < 240; ++i)
  {
    const glm::dvec3 before = at(i * step) - at((i - 1) * step),
                     after = at((i + 1) * step) - at(i * step);
    longest = std::max(longest, glm::length(after));
    jerk = std::max(jerk, glm::distance(before, after));
  }
  EXPECT_GT(longest, 0);
  EXPECT_LT(jerk, 0.15 * longest);
}

TEST_P(AllScenes, LightsMoveFromFrameToFrame)
{
  const rtw::Scene scene = rtw::MakeScene(this->GetParam(), 0.1);
  for (int frame = 0; frame < 60; ++frame)
  {
    const rtw::SceneLight a = rtw::LightOnPath(scene, frame / 60.0);
    const rtw::SceneLight b = rtw::LightOnPath(scene, (frame + 1) / 60.0);
    const double move =
      glm::distance(a.Direction, b.Direction) + glm::distance(a.Position, b.Position);
    EXPECT_GT(move, 0) << frame;
    EXPECT_LT(glm::distance(a.Direction, b.Direction), 0.03) << frame;
    EXPECT_NEAR(glm::length(a.Direction), 1, 1e-12);
  }
}

// What is seen in the middle, and what is as far as ten times the nearest depth, move by as much.
TEST_P(AllScenes, TinyMovesAreATenthOfAPixel)
{
  const rtw::Scene scene = rtw::MakeScene(this->GetParam(), 0.1);
  for (const double t : { 0.0, 0.4 })
  {
    const rtw::SceneCamera start = rtw::CameraOnPath(scene, t);
    const rtw::SceneCamera first = rtw::CameraOnTinyPath(scene, 0, t);
    EXPECT_EQ(first.Position, start.Position);
    EXPECT_LT(glm::distance(first.Focal, start.Focal), 1e-9);
  }
  const double pixel = 2 * std::tan(glm::radians(scene.Camera.Angle / 2)) / scene.Size[1];
  for (const int frame : { 0, 1, 30, 99 })
  {
    const rtw::SceneCamera a = rtw::CameraOnTinyPath(scene, frame);
    const rtw::SceneCamera b = rtw::CameraOnTinyPath(scene, frame + 1);
    const glm::dvec3 turn =
      glm::normalize(b.Focal - b.Position) - glm::normalize(a.Focal - a.Position);
    EXPECT_NEAR(glm::length(turn) / pixel, 0.1, 0.001);
    EXPECT_NEAR(
      glm::distance(a.Position, b.Position) / (10 * scene.Camera.Near) / pixel, 0.1, 0.001);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, AllScenes, testing::ValuesIn(rtw::SceneNames()),
  [](const auto& info) { return info.param; });

TEST(Scenes, AnAssemblyHasTheActorsAskedFor)
{
  EXPECT_EQ(rtw::MakeScene("assembly").Parts.size(), 1000u);
  EXPECT_NEAR(double(rtw::NumberOfTriangles(rtw::MakeScene("assembly"))), 100000, 5000);
  const rtw::SceneBounds usual = rtw::BoundsOf(rtw::MakeScene("assembly"));
  for (const int actors : { 1, 2, 37, 5000 })
  {
    const rtw::Scene scene = rtw::MakeAssemblyOf(actors);
    vtkNew<vtkRenderer> renderer;
    rtw::AddToRenderer(scene, renderer, 3);
    EXPECT_EQ(renderer->GetActors()->GetNumberOfItems(), actors);
    EXPECT_EQ(rtw::BoundsOf(scene).Low.x, usual.Low.x);
  }
  EXPECT_THROW(rtw::MakeAssemblyOf(0), std::invalid_argument);
}

TEST(Scenes, AFloorIsTwoTriangles)
{
  const rtw::Scene scene = rtw::MakeFloor();
  EXPECT_EQ(rtw::NumberOfTriangles(scene), 2u + 12 * 12 + 2);
  EXPECT_EQ(rtw::BoundsOf(scene).High.x - rtw::BoundsOf(scene).Low.x, 300);
}

TEST(Scenes, PartsHaveTheirBoundsAndTriangles)
{
  const rtw::Scene scene = rtw::MakeScene("molecule");
  vtkNew<vtkRenderer> renderer;
  rtw::AddToRenderer(scene, renderer, 2);
  EXPECT_EQ(renderer->GetActors()->GetNumberOfItems(), vtkIdType(scene.Parts.size()) + 2);
  std::size_t imposters = 0, glyphs = 0;
  for (const rtw::ScenePart& part : scene.Parts)
  {
    const auto points = std::size_t(part.Data->GetNumberOfPoints());
    imposters += part.Kind == rtw::PartKind::SPHERES ? points : 0;
    imposters += part.Kind == rtw::PartKind::STICKS ? 12 * points : 0;
    glyphs +=
      part.Kind == rtw::PartKind::GLYPHS ? points * std::size_t(part.Glyph->GetNumberOfPolys()) : 0;
  }
  EXPECT_GT(imposters, 1000u);
  EXPECT_GT(glyphs, 100000u);
  EXPECT_EQ(rtw::NumberOfTriangles(scene),
    std::size_t(scene.Mesh->GetNumberOfPolys()) + imposters + glyphs);
}

TEST(Scenes, RefusesWhatItDoesNotKnow)
{
  EXPECT_THROW(rtw::MakeSceneWithBudget("atlantis", 10000), std::invalid_argument);
  EXPECT_THROW(rtw::MakeSceneWithBudget("town", 0), std::invalid_argument);
  EXPECT_THROW(rtw::MakeScene("atlantis"), std::invalid_argument);
  EXPECT_THROW(rtw::MakeScene("town", 0), std::invalid_argument);
  EXPECT_THROW(rtw::MakeScene("town", std::nan("")), std::invalid_argument);
}

TEST(Scenes, PiecesHoldAllTriangles)
{
  const rtw::Scene scene = rtw::MakeScene("robot");
  vtkNew<vtkRenderer> renderer;
  rtw::AddToRenderer(scene, renderer, 7);
  vtkActorCollection* actors = renderer->GetActors();
  EXPECT_EQ(actors->GetNumberOfItems(), 7);
  vtkIdType triangles = 0;
  double area = 0;
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    auto* piece = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
    triangles += piece->GetNumberOfPolys();
    area += Area(piece);
    EXPECT_EQ(piece->GetPointData()->GetNormals(), nullptr);
  }
  EXPECT_EQ(triangles, scene.Mesh->GetNumberOfPolys());
  EXPECT_NEAR(area, Area(scene.Mesh), 1e-6 * area);
}

TEST(Scenes, SetTheRenderersCameraAndLight)
{
  const rtw::Scene scene = rtw::MakeScene("sandbox");
  vtkNew<vtkRenderer> renderer;
  rtw::AddToRenderer(scene, renderer);
  EXPECT_EQ(renderer->GetActiveCamera()->GetViewAngle(), 40);
  EXPECT_EQ(renderer->GetActiveCamera()->GetPosition()[2], 4.3);
  ASSERT_EQ(renderer->GetLights()->GetNumberOfItems(), 1);
  auto* light = vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(0));
  EXPECT_TRUE(light->GetPositional());
  EXPECT_EQ(light->GetConeAngle(), 28);
  EXPECT_EQ(light->GetPosition()[1], 6.5);
}

TEST(Scenes, SettingsComeBack)
{
  rtw::Scene scene = rtw::MakeScene("sandbox");
  scene.Size[0] = 640;
  rtw::Scene read;
  rtw::ReadSettings(rtw::WriteSettings(scene), read);
  EXPECT_EQ(read.Size[0], 640);
  EXPECT_EQ(read.Camera.Position, scene.Camera.Position);
  EXPECT_EQ(read.Camera.Far, scene.Camera.Far);
  EXPECT_TRUE(read.Light.IsSpot);
  EXPECT_LT(glm::distance(read.Light.Direction, scene.Light.Direction), 1e-15);
  EXPECT_THROW(rtw::ReadSettings("{", read), std::runtime_error);
  EXPECT_THROW(rtw::ReadSettings("[1]", read), std::runtime_error);
  EXPECT_THROW(rtw::ReadSettings(R"({"camera":{"focal":[1,2]}})", read), std::runtime_error);
  EXPECT_THROW(rtw::ReadSettings(R"({"light":{"type":"lava"}})", read), std::runtime_error);
  EXPECT_THROW(rtw::ReadSettings(R"({"size":[0,1]})", read), std::runtime_error);
}
