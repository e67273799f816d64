// SPDX-License-Identifier: BSD-3-Clause
#include "rtwMakeScenes.h"
#include "rtwMeshBuilder.h"
#include "rtwRandom.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <glm/gtc/matrix_transform.hpp>

namespace rtw
{
namespace
{
const double PI = std::acos(-1.0);
constexpr int HELICES = 3;
constexpr int RESIDUES = 26; // of a helix
constexpr double STICK = .22;

enum Element
{
  CARBON,
  NITROGEN,
  OXYGEN,
  HYDROGEN
};
const double RADII[] = { .62, .58, .55, .32 };
const dvec3 COLOURS[] = { { .55, .57, .60 }, { .30, .42, .85 }, { .85, .28, .24 }, { .9, .9, .9 } };

struct Atom
{
  Element Kind;
  dvec3 Position;
};

struct Bond
{
  dvec3 From, To;
};

struct Protein
{
  std::vector<Atom> Atoms;
  std::vector<Bond> Bonds;
};

// In cylindrical coordinates about the axis of an alpha helix, in Angstroms and degrees; bound to
// another atom of the same residue.
struct Place
{
  Element Kind;
  double Radius, Angle, Rise;
  int BoundTo;
};
const Place RESIDUE[] = {
  { NITROGEN, 1.57, -27.7, -.95, 1 },
  { CARBON, 2.29, 0, 0, 2 },
  { CARBON, 1.66, 26.3, 1.11, 1 },
  { OXYGEN, 2.03, 20.6, 2.32, 2 },
  { CARBON, 3.30, -19.6, -.60, 1 }, // from here on the side chain
  { CARBON, 4.55, -15.0, .15, 4 },
  { NITROGEN, 5.70, -21.0, -.55, 5 },
};

// 3.6 residues a turn, of 1.5 Angstroms' rise each.
void AddHelix(Protein& to, const glm::dmat4& placement)
{
  dvec3 lastCarbon(0);
  for (int i = 0; i < RESIDUES; ++i)
  {
    const size_t first = to.Atoms.size();
    // Side chains of three lengths.
    const int atoms = int(std::size(RESIDUE)) - i % 3;
    for (int k = 0; k < atoms; ++k)
    {
      const Place& place = RESIDUE[k];
      const double angle = (place.Angle + 100 * i) * PI / 180;
      const glm::dvec4 p(
        place.Radius * std::cos(angle), place.Rise + 1.5 * i, -place.Radius * std::sin(angle), 1);
      to.Atoms.push_back({ place.Kind, dvec3(placement * p) });
    }
    for (int k = 1; k < atoms; ++k)
    {
      const int other = k == 1 ? 0 : RESIDUE[k].BoundTo;
      to.Bonds.push_back(
        { to.Atoms[first + size_t(k)].Position, to.Atoms[first + size_t(other)].Position });
    }
    if (i > 0)
    {
      to.Bonds.push_back({ lastCarbon, to.Atoms[first].Position });
    }
    lastCarbon = to.Atoms[first + 2].Position;
  }
}

Protein MakeProtein()
{
  Protein protein;
  for (int helix = 0; helix < HELICES; ++helix)
  {
    glm::dmat4 placement(1);
    placement = glm::rotate(placement, 2 * PI * helix / HELICES + .4, dvec3(0, 1, 0));
    placement = glm::translate(placement, dvec3(7.2, 3, 0));
    placement = glm::rotate(placement, .22, dvec3(1, 0, 0)); // they cross
    AddHelix(protein, placement);
  }
  return protein;
}

// Each with a cell, or VTK finds no bounds and draws nothing.
vtkSmartPointer<vtkPolyData> PointsAt(const std::vector<dvec3>& positions)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  vtkNew<vtkCellArray> cells;
  for (const dvec3& p : positions)
  {
    const vtkIdType id = points->InsertNextPoint(p.x, p.y, p.z);
    cells->InsertNextCell(1, &id);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(cells);
  return data;
}

vtkSmartPointer<vtkFloatArray> AddArray(vtkPolyData* data, const char* name, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  data->GetPointData()->AddArray(array);
  return array;
}

// Of one element.
ScenePart MakeBalls(const std::vector<Atom>& atoms, Element element, double size)
{
  std::vector<dvec3> positions;
  for (const Atom& atom : atoms)
  {
    if (atom.Kind == element)
    {
      positions.push_back(atom.Position);
    }
  }
  ScenePart part;
  part.Kind = PartKind::SPHERES;
  part.Data = PointsAt(positions);
  AddArray(part.Data, RADIUS_ARRAY, 1)->FillComponent(0, RADII[element] * size);
  part.Colour = COLOURS[element];
  return part;
}

ScenePart MakeSticks(const std::vector<Bond>& bonds)
{
  std::vector<dvec3> middles;
  for (const Bond& bond : bonds)
  {
    middles.push_back((bond.From + bond.To) / 2.0);
  }
  ScenePart part;
  part.Kind = PartKind::STICKS;
  part.Data = PointsAt(middles);
  const auto sizes = AddArray(part.Data, SIZE_ARRAY, 3), axes = AddArray(part.Data, AXIS_ARRAY, 3);
  vtkNew<vtkUnsignedCharArray> colours; // without any, vtkOpenGLStickMapper of VTK 9.1 crashes
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(part.Data->GetNumberOfPoints());
  part.Data->GetPointData()->SetScalars(colours);
  for (vtkIdType i = 0; i < vtkIdType(bonds.size()); ++i)
  {
    const dvec3 along = bonds[size_t(i)].To - bonds[size_t(i)].From, axis = Unit(along);
    sizes->SetTuple3(i, glm::length(along), STICK, STICK);
    axes->SetTuple3(i, axis.x, axis.y, axis.z);
    colours->SetTuple3(i, 184, 184, 178);
  }
  return part;
}

// Molecules in a shell about the bundle.
std::vector<Atom> MakeWater(int molecules, double size)
{
  Random random(9);
  std::vector<Atom> atoms;
  for (int i = 0; i < molecules; ++i)
  {
    const double angle = random.Uniform(0, 2 * PI), radius = 15 + 13 * std::sqrt(random.Uniform());
    const double y = random.Uniform(1.5, 44);
    const dvec3 centre(radius * std::cos(angle), y, radius * std::sin(angle));
    atoms.push_back({ OXYGEN, centre });
    const double turn = random.Uniform(0, 2 * PI), tilt = random.Uniform(0, 2 * PI);
    for (const double bend : { -.91, .91 }) // half of 104.5 degrees
    {
      const dvec3 way(std::sin(bend), std::cos(bend), 0);
      atoms.push_back({ HYDROGEN, centre + TurnY(TurnX(way, tilt), turn) * (.96 * size) });
    }
  }
  return atoms;
}

// A table whose back curves up into a wall.
vtkSmartPointer<vtkPolyData> MakeBackdrop(double root)
{
  MeshBuilder mesh;
  const auto sweep = [](double u, double v) {
    const double x = -160 + 320 * u, bend = 30, along = 300 * v - 150;
    const double angle = std::clamp(along / bend, 0.0, PI / 2);
    const double rest = std::max(0.0, along - bend * PI / 2);
    return dvec3(
      x, bend * (1 - std::cos(angle)) + rest, -30 - bend * std::sin(angle) - std::min(0.0, along));
  };
  mesh.Grid(sweep, Finer(4, root, 1), Finer(240, root, 40));
  return mesh.Build();
}
}

// There is more water, and its molecules are finer: smaller ones, so that the protein stays in
// sight.
Scene MakeMolecule(double scale)
{
  const double number = std::sqrt(scale), size = 1.35 / std::max(1.0, std::cbrt(number));
  const Protein protein = MakeProtein();
  const std::vector<Atom> water = MakeWater(Finer(260, number, 20), size);
  MeshBuilder ball;
  ball.Sphere({ 0, 0, 0 }, 1, Finer(8, std::sqrt(number), 3));
  const auto sphere = ball.Build();

  Scene scene;
  scene.Mesh = MakeBackdrop(std::sqrt(number));
  for (const Element element : { CARBON, NITROGEN, OXYGEN })
  {
    scene.Parts.push_back(MakeBalls(protein.Atoms, element, 1));
  }
  scene.Parts.push_back(MakeSticks(protein.Bonds));
  for (const Element element : { OXYGEN, HYDROGEN })
  {
    ScenePart part = MakeBalls(water, element, size);
    part.Kind = PartKind::GLYPHS;
    part.Glyph = sphere;
    scene.Parts.push_back(part);
  }
  scene.Camera = { { 31, 33, 66 }, { 0, 19.5, -2 }, { 0, 1, 0 }, 40, 5, 400 };
  scene.Path = { { { 58, 28, 42 }, { 0, 20, -1 } }, { { 40, 18, 60 }, { 0, 21, 0 } },
    { { 4, 40, 72 }, { 0, 18, -2 } } };
  scene.Light.Direction = Unit({ -.42, -.70, -.52 });
  return scene;
}
}
