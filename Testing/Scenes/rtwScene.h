// SPDX-License-Identifier: BSD-3-Clause
#ifndef rtwScene_h
#define rtwScene_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <string>
#include <vector>

class vtkCamera;
class vtkLight;
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
  bool IsSpot = false;              // or, with a cone of 90 degrees or more, a point light
  glm::dvec3 Position{ 0, 0, 0 };   // of a spot
  glm::dvec3 Direction{ 0, -1, 0 }; // the way light goes, of length one
  double Cone = 180;                // of a spot: half its opening, in degrees
};

enum class PartKind
{
  SURFACE, // triangles
  GLYPHS,  // copies of a surface, one a point, of the size that the array RADIUS_ARRAY gives
  SPHERES, // imposters about points, of the radii in RADIUS_ARRAY
  STICKS   // imposters of cylinders about points: (length, radius, radius) is in SIZE_ARRAY, the
           // direction of length one in AXIS_ARRAY
};
constexpr const char* RADIUS_ARRAY = "Radius";
constexpr const char* SIZE_ARRAY = "Size";
constexpr const char* AXIS_ARRAY = "Axis";

/// What is an actor of its own.
struct ScenePart
{
  PartKind Kind = PartKind::SURFACE;
  vtkSmartPointer<vtkPolyData> Data;  // which parts may share
  vtkSmartPointer<vtkPolyData> Glyph; // of GLYPHS
  glm::dmat4 Placement{ 1 };          // of a SURFACE: into the world
  glm::dvec3 Colour{ 0.86, 0.83, 0.78 };
  double Ambient = 0.12; // how bright it is in shadow
};

/// Where a camera passes, and what it looks at there.
struct WayPoint
{
  glm::dvec3 Position;
  glm::dvec3 Focal;
};

/// A mesh, or parts, or both, with a view and a light. Lengths are metres and +y is up in those
/// that are made here.
struct Scene
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Mesh; // triangles without normals, so that shading is flat; never
                                     // null, and empty where there are only parts
  std::vector<ScenePart> Parts;
  SceneCamera Camera;
  std::vector<WayPoint> Path; // from the camera through these and back; if empty, it sways
  SceneLight Light;
  double LightSwing = 20;       // degrees about the camera's up, at most, of a light that moves
  int Size[2] = { 1024, 1024 }; // of the picture, in pixels
};

/// What a scene has to draw: of its mesh, of each glyph, and of imposters the boxes (sticks) and
/// the single triangles (spheres) that are drawn in their place.
std::size_t NumberOfTriangles(const Scene& scene);

struct SceneBounds
{
  glm::dvec3 Low, High;
};
SceneBounds BoundsOf(const Scene& scene);

/// The scenes that MakeScene() knows.
std::vector<std::string> SceneNames();

/// Makes a scene, always the same for the same arguments. `scale` multiplies the number of
/// triangles, roughly. The view and the light stay.
/// Throws std::invalid_argument if there is no such scene or the scale is not above zero.
Scene MakeScene(const std::string& name, double scale = 1);

/// Makes a scene of as nearly so many triangles as its construction allows: within 15 percent from
/// 10 000 to 5 000 000. It takes several attempts, a few seconds for millions.
/// Throws std::invalid_argument if there is no such scene or the budget is 0.
Scene MakeSceneWithBudget(const std::string& name, std::size_t triangles);

/// The scene "assembly" with other numbers: so many actors, of about so many triangles each, but 50
/// at least, in the same space. Throws std::invalid_argument if there are no actors.
Scene MakeAssemblyOf(int actors, int trianglesPerActor = 100);

/// Boxes and a roof over a floor of two triangles that reaches to the horizon: edges that a warp
/// bends far more than those of finer meshes. MakeScene() does not know it.
Scene MakeFloor();

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
/// same), each part as an actor, and sets the renderer's camera and its only light.
void AddToRenderer(const Scene& scene, vtkRenderer* renderer, int pieces = 1);

void Apply(const SceneCamera& from, vtkCamera* to);
vtkSmartPointer<vtkLight> MakeLight(const Scene& scene);
void Apply(const SceneLight& from, const Scene& scene, vtkLight* to);

/// Along a smooth closed path, through no walls, meant for 60 frames or more: t = 0 and t = 1 are
/// the scene's own camera.
SceneCamera CameraOnPath(const Scene& scene, double t);

/// The camera at `t` of the path after so many moves of about so many pixels each: small enough
/// that shadows which change from frame to frame more than the truth does are seen to flicker.
SceneCamera CameraOnTinyPath(const Scene& scene, int frame, double t = 0, double pixels = 0.1);

/// To and fro: t = 0 and t = 1 are the scene's own light.
SceneLight LightOnPath(const Scene& scene, double t);
}

#endif
