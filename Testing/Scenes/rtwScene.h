// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwScene_h
#define rtwScene_h

#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>

#include <string>
#include <vector>

class vtkCamera;
class vtkLight;
class vtkPolyData;
class vtkRenderer;

namespace rtw
{
struct SceneCamera
{
  glm::dvec3 Position{ 0, 0, 1 };
  glm::dvec3 Focal{ 0, 0, 0 };
  glm::dvec3 Up{ 0, 1, 0 };
  double Angle = 30; // vertical, in degrees
  double Near = 0.1;
  double Far = 1000;
};

struct SceneLight
{
  bool IsSpot = false;
  glm::dvec3 Position{ 0, 0, 0 };   // of a spot
  glm::dvec3 Direction{ 0, -1, 0 }; // the way light goes, of length one
  double Cone = 180;                // of a spot: half its opening, in degrees
};

/// A mesh with a view and a light. Lengths are metres and +y is up in those that are made here.
struct Scene
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Mesh; // triangles without normals, so that shading is flat
  SceneCamera Camera;
  SceneLight Light;
  int Size[2] = { 1024, 1024 }; // of the picture, in pixels
};

/// The scenes that MakeScene() knows.
std::vector<std::string> SceneNames();

/// Makes a scene, always the same for the same arguments. `scale` multiplies the number of
/// triangles of town, playground and terrain.
/// Throws std::invalid_argument if there is no such scene or the scale is not above zero.
Scene MakeScene(const std::string& name, double scale = 1);

/// Reads an OBJ, PLY, STL, VTP, GLB or glTF file; all its parts are merged into one mesh in world
/// coordinates. A FILE.json beside FILE.obj gives camera and light; otherwise they are fitted.
/// Throws std::runtime_error, with a message that names the file, if there is nothing to show.
Scene LoadScene(const std::string& path);

/// Takes camera, light and size from a JSON text of the form that WriteSettings() gives; what is
/// missing there stays as it is. Throws std::runtime_error where a value has the wrong form.
void ReadSettings(const std::string& json, Scene& scene);
std::string WriteSettings(const Scene& scene);

/// Fits the camera, from above and in front, and a light from the upper left behind it.
void FitView(Scene& scene);

/// Adds the mesh, as one actor or as `pieces` actors of consecutive triangles (the picture is the
/// same), and sets the renderer's camera and its only light.
void AddToRenderer(const Scene& scene, vtkRenderer* renderer, int pieces = 1);

void Apply(const SceneCamera& from, vtkCamera* to);
vtkSmartPointer<vtkLight> MakeLight(const Scene& scene);
}

#endif
