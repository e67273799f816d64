// SPDX-License-Identifier: BSD-3-Clause
#include "rtwScene.h"

#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkSTLWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>

namespace
{
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

// They sway about what they look at.
TEST(LoadScene, LoadedScenesHavePathsToo)
{
  rtw::Scene scene = rtw::MakeScene("robot");
  scene.Path.clear();
  rtw::FitView(scene);
  EXPECT_LT(glm::distance(rtw::CameraOnPath(scene, 0).Position, scene.Camera.Position), 1e-9);
  const double distance = glm::distance(scene.Camera.Position, scene.Camera.Focal);
  double farthest = 0;
  for (int i = 0; i < 60; ++i)
  {
    const rtw::SceneCamera camera = rtw::CameraOnPath(scene, i / 60.0);
    EXPECT_EQ(camera.Focal, scene.Camera.Focal);
    EXPECT_NEAR(glm::distance(camera.Position, camera.Focal), distance, 1e-9 * distance);
    farthest = std::max(farthest, glm::distance(camera.Position, scene.Camera.Position));
  }
  EXPECT_GT(farthest, 0.2 * distance);
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
