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
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkSTLWriter.h>
#include <vtkTriangle.h>
#include <vtkXMLPolyDataWriter.h>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
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

std::string TemporaryFile(const std::string& name)
{
  return testing::TempDir() + name;
}

std::string MessageOf(const std::string& path)
{
  try
  {
    rtw::LoadScene(path);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "nothing is wrong";
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

TEST(Scenes, RefusesWhatItDoesNotKnow)
{
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

TEST(LoadScene, ReadsAnObjAndItsSettings)
{
  const std::string path = TemporaryFile("rtw-quad.obj");
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  std::ofstream(TemporaryFile("rtw-quad.json")) << R"({"camera": {"position": [0, 0, 9]}})";
  const rtw::Scene scene = rtw::LoadScene(path);
  EXPECT_EQ(scene.Name, "rtw-quad");
  EXPECT_EQ(scene.Mesh->GetNumberOfPolys(), 2);
  EXPECT_EQ(scene.Camera.Position, glm::dvec3(0, 0, 9));
  std::ofstream(TemporaryFile("rtw-quad.json")) << "{";
  EXPECT_NE(MessageOf(path).find("rtw-quad.json: not a JSON"), std::string::npos);
}

TEST(LoadScene, FitsTheCamera)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(5, 0, 0);
  vtkNew<vtkXMLPolyDataWriter> writer;
  const std::string path = TemporaryFile("rtw-sphere.vtp");
  writer->SetFileName(path.c_str());
  writer->SetInputConnection(sphere->GetOutputPort());
  writer->Write();
  const rtw::Scene scene = rtw::LoadScene(path);
  EXPECT_EQ(scene.Mesh->GetNumberOfPolys(), 96);
  EXPECT_EQ(scene.Mesh->GetPointData()->GetNormals(), nullptr);
  EXPECT_NEAR(scene.Camera.Focal.x, 5, 0.1);
  const double distance = glm::distance(scene.Camera.Position, scene.Camera.Focal);
  EXPECT_LT(scene.Camera.Near, distance - 0.5);
  EXPECT_GT(scene.Camera.Far, distance + 0.5);
}

namespace
{
template <class Writer>
void ExpectSphereComesBack(const std::string& name)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<Writer> writer;
  const std::string path = TemporaryFile(name);
  writer->SetFileName(path.c_str());
  writer->SetInputConnection(sphere->GetOutputPort());
  writer->Write();
  EXPECT_EQ(rtw::LoadScene(path).Mesh->GetNumberOfPolys(), 96) << name;
}
}

TEST(LoadScene, ReadsOtherFormats)
{
  ExpectSphereComesBack<vtkPLYWriter>("rtw-sphere.ply");
  ExpectSphereComesBack<vtkSTLWriter>("rtw-sphere.STL");
}

TEST(LoadScene, PlacesThePartsOfAGltfFile)
{
  const std::string path = TemporaryFile("rtw-two.gltf");
  std::ofstream(path) << R"({"asset": {"version": "2.0"}, "scene": 0,
    "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0, "translation": [10, 0, 0]}, {"mesh": 0, "scale": [1, 3, 1]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
      "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  const rtw::Scene scene = rtw::LoadScene(path);
  EXPECT_EQ(scene.Mesh->GetNumberOfPolys(), 2);
  double bounds[6];
  scene.Mesh->GetBounds(bounds);
  EXPECT_EQ(bounds[1], 11);
  EXPECT_EQ(bounds[3], 3);
}

TEST(LoadScene, SaysWhatIsWrong)
{
  EXPECT_NE(MessageOf("no/such.obj").find("no/such.obj: there is no such file"), std::string::npos);
  const std::string odd = TemporaryFile("rtw-odd.docx"), empty = TemporaryFile("rtw-empty.obj");
  std::ofstream(odd) << "?";
  EXPECT_NE(MessageOf(odd).find("expected a file that ends in"), std::string::npos);
  for (const char* name :
    { "rtw-empty.obj", "rtw-empty.ply", "rtw-empty.stl", "rtw-empty.vtp", "rtw-empty.glb" })
  {
    const std::string path = TemporaryFile(name);
    std::ofstream(path).flush();
    EXPECT_NE(MessageOf(path).find("no triangles could be read"), std::string::npos) << name;
    std::ofstream(path) << "This is no mesh at all.\n";
    EXPECT_NE(MessageOf(path).find("no triangles could be read"), std::string::npos) << name;
  }
}
