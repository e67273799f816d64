// SPDX-License-Identifier: BSD-3-Clause
#include "rtwScene.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkGLTFReader.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <glm/glm.hpp>
#include <vtksys/SystemTools.hxx>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rtw
{
namespace
{
std::string Extension(const std::string& path)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path));
}

// Readers, and what they are made of, print what they dislike; LoadScene() says it in one line.
class Silence
{
public:
  Silence() { vtkObject::GlobalWarningDisplayOff(); }
  ~Silence() { vtkObject::SetGlobalWarningDisplay(this->Before); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  const int Before = vtkObject::GetGlobalWarningDisplay();
};

template <class Reader>
vtkSmartPointer<vtkDataObject> Read(const std::string& path)
{
  const Silence silence;
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutputDataObject(0);
}

vtkSmartPointer<vtkDataObject> ReadAny(const std::string& path)
{
  const std::string extension = Extension(path);
  if (extension == ".obj")
  {
    return Read<vtkOBJReader>(path);
  }
  if (extension == ".ply")
  {
    return Read<vtkPLYReader>(path);
  }
  if (extension == ".stl")
  {
    return Read<vtkSTLReader>(path);
  }
  if (extension == ".vtp")
  {
    return Read<vtkXMLPolyDataReader>(path);
  }
  if (extension == ".glb" || extension == ".gltf")
  {
    return Read<vtkGLTFReader>(path);
  }
  throw std::runtime_error(
    path + ": expected a file that ends in .obj, .ply, .stl, .vtp, .glb or .gltf");
}

// Points and triangles alone: what else a file has (normals, colours) would shade it otherwise.
vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* surface)
{
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(surface->GetPoints());
  bare->SetPolys(surface->GetPolys());
  bare->SetStrips(surface->GetStrips());
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(bare);
  triangulate->PassVertsOff();
  triangulate->PassLinesOff();
  triangulate->Update();
  return triangulate->GetOutput();
}

vtkSmartPointer<vtkPolyData> Merge(vtkDataObject* data)
{
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    return surface->GetPoints() ? Triangulate(surface) : vtkSmartPointer<vtkPolyData>::New();
  }
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(vtkNew<vtkPolyData>());
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      auto* surface = vtkPolyData::SafeDownCast(each->GetCurrentDataObject());
      if (surface && surface->GetPoints())
      {
        append->AddInputData(Triangulate(surface));
      }
    }
  }
  append->Update();
  return append->GetOutput();
}

std::string ReadText(const std::string& path)
{
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}
}

void FitView(Scene& scene)
{
  const SceneBounds bounds = BoundsOf(scene);
  const glm::dvec3 centre = (bounds.Low + bounds.High) / 2.0;
  const double radius = glm::distance(bounds.Low, bounds.High) / 2;
  const double distance = radius / std::sin(glm::radians(scene.Camera.Angle / 2));
  scene.Camera.Position = centre + glm::normalize(glm::dvec3(0.45, 0.4, 0.8)) * distance;
  scene.Camera.Focal = centre;
  scene.Camera.Up = { 0, 1, 0 };
  scene.Camera.Near = distance > 1.01 * radius ? distance - 1.01 * radius : 0.001 * distance;
  scene.Camera.Far = distance + 1.01 * radius;
  scene.Light = SceneLight();
  scene.Light.Direction = glm::normalize(glm::dvec3(0.5, -1, -0.6));
}

Scene LoadScene(const std::string& path)
{
  if (!vtksys::SystemTools::FileExists(path, true))
  {
    throw std::runtime_error(path + ": there is no such file");
  }
  Scene scene;
  scene.Mesh = Merge(ReadAny(path));
  if (scene.Mesh->GetNumberOfPolys() == 0 || !(scene.Mesh->GetLength() > 0))
  {
    throw std::runtime_error(path + ": no triangles could be read");
  }
  scene.Name = vtksys::SystemTools::GetFilenameWithoutLastExtension(path);
  FitView(scene);
  const std::string extension = Extension(path);
  const std::string settings = path.substr(0, path.size() - extension.size()) + ".json";
  if (extension == ".obj" && vtksys::SystemTools::FileExists(settings, true))
  {
    try
    {
      ReadSettings(ReadText(settings), scene);
    }
    catch (const std::runtime_error& error)
    {
      throw std::runtime_error(settings + ": " + error.what());
    }
  }
  return scene;
}
}
