// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/rtwThickPrimitives.h"

#include "Frame/rtwFaceThick.h"
#include "Frame/rtwMeshData.h"
#include "Frame/rtwSceneActor.h"
#include "Frame/rtwView.h"
#include "GL/rtwDrawing.h"
#include "GL/rtwOpenGL.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace rtw
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
// Widths, in pixels, up to which a half circle of one, two and four pieces is round enough. Single
// pixels are cheap, because they are many.
constexpr double Single = 1.5, Thin = 3, Medium = 10;
constexpr int MostGroups = 32768; // work groups of a dispatch along an axis

// A ThickGroup as rtwFaceThick.glsl declares it.
struct GpuGroup
{
  glm::vec4 ToWorld[3];
  glm::vec4 Distance;
  glm::vec4 Light;
  glm::vec2 Radii;
  glm::vec2 Unused;
};
static_assert(sizeof(GpuGroup) == 96, "the shader reads it with this stride");
struct GpuRun
{
  std::uint32_t FirstSegment, Segments, Group, Sides, FirstPoint, Cluster, IsBalls, Unused;
};

std::uint32_t ClassOf(double width, bool isBalls)
{
  const double few = isBalls ? Thin : Single;
  return width <= few ? 0 : width <= Thin ? 1 : width <= Medium ? 2 : 3;
}

// The width of a pixel in the world per unit of w in clip coordinates.
double PixelSize(const View& view)
{
  return 2 / (std::abs(view.ViewToClip[1][1]) * view.Height);
}

glm::dvec4 RowW(const View& view)
{
  const glm::dmat4 toClip = view.ViewToClip * view.WorldToView;
  return { toClip[0][3], toClip[1][3], toClip[2][3], toClip[3][3] };
}
}

bool ThickRun::operator==(const ThickRun& other) const
{
  return this->FirstSegment == other.FirstSegment && this->Segments == other.Segments &&
    this->Group == other.Group && this->Class == other.Class && this->IsBalls == other.IsBalls;
}

std::array<Buffer*, 4> ThickPrimitives::Buffers()
{
  return { &this->Points, &this->Segments, &this->Groups, &this->Runnings };
}

bool ThickPrimitives::Build()
{
  return this->Facing.Build({ { GL_COMPUTE_SHADER, { rtwFaceThick } } });
}

ThickPrimitives::Mesh& ThickPrimitives::Find(const ScenePart& part)
{
  Mesh& mesh = this->Meshes[{ part.Data, part.Look.Drawn, part.Look.AllPoints }];
  const std::uint64_t time = MeshTime(part.Data);
  if (mesh.Time != time)
  {
    mesh.Data = BuildThickData(part.Data, part.Look.Drawn, part.Look.AllPoints);
    mesh.Time = time;
    this->Changed = true;
  }
  mesh.Used = true;
  return mesh;
}

void ThickPrimitives::AddRuns(const Mesh& mesh, const ThickLook& look)
{
  const auto group = static_cast<std::uint32_t>(this->Placed.size());
  for (const bool isBalls : { false, true })
  {
    const std::uint32_t kind = ClassOf(isBalls ? look.PointSize : look.LineWidth, isBalls);
    const auto most =
      static_cast<std::uint32_t>(MeshCluster::MaximumTriangles / 2) / ThickRun::Sides[kind];
    for (const ThickBlock& block : isBalls ? mesh.Data.Balls : mesh.Data.Lines)
    {
      for (std::uint32_t first = 0; first < block.Count; first += most)
      {
        const ThickRun run{ block.First + first, std::min(most, block.Count - first), group, kind,
          isBalls };
        this->Runs.push_back(run);
        this->NumberOfPoints += run.GetPoints();
      }
    }
  }
}

void ThickPrimitives::Update(const std::vector<ScenePart>& parts, const View& view)
{
  this->Placed.clear();
  this->Runs.clear();
  this->NumberOfPoints = 0;
  this->HasPlaced = false;
  const glm::dvec4 row = RowW(view);
  const double radius = 0.5 * PixelSize(view);
  for (const ScenePart& part : parts)
  {
    if (!part.Casts)
    {
      continue;
    }
    const Mesh& mesh = this->Find(part);
    if (mesh.Data.IsEmpty())
    {
      continue;
    }
    this->AddRuns(mesh, part.Look);
    const glm::dvec3 centre(part.ToWorld * glm::dvec4(mesh.Data.Centre, 1));
    this->Placed.push_back({ &mesh, glm::dmat3(part.ToWorld), centre,
      glm::dvec4(glm::dvec3(row), glm::dot(row, glm::dvec4(centre, 1))),
      radius * glm::dvec2(part.Look.LineWidth, part.Look.PointSize) });
  }
  this->DropUnused();
  this->Upload();
}

void ThickPrimitives::DropUnused()
{
  for (auto at = this->Meshes.begin(); at != this->Meshes.end();)
  {
    const bool used = at->second.Used;
    at->second.Used = false;
    this->Changed = this->Changed || !used;
    at = used ? std::next(at) : this->Meshes.erase(at);
  }
}

// Points and segments of all meshes, one after another.
void ThickPrimitives::Upload()
{
  if (!this->Changed)
  {
    return;
  }
  this->Changed = false;
  std::vector<glm::vec3> points;
  std::vector<ThickSegment> segments;
  for (auto& [key, mesh] : this->Meshes)
  {
    const auto first = static_cast<std::uint32_t>(points.size());
    mesh.FirstSegment = static_cast<std::uint32_t>(segments.size());
    points.insert(points.end(), mesh.Data.Points.begin(), mesh.Data.Points.end());
    for (const ThickSegment& segment : mesh.Data.Segments)
    {
      segments.push_back({ segment.Start + first, segment.End + first });
    }
  }
  this->Points.Assign(points);
  this->Segments.Assign(segments);
}

std::vector<glm::dvec3> ThickPrimitives::GetCentres() const
{
  std::vector<glm::dvec3> centres;
  for (const Group& group : this->Placed)
  {
    centres.push_back(group.Centre);
  }
  return centres;
}

// Two triangles between the ends' points, which are 0 to 5, and a fan at each end.
std::vector<std::uint32_t> ThickPrimitives::IndicesOf(std::uint32_t sides)
{
  std::vector<std::uint32_t> indices;
  const std::size_t most = MeshCluster::MaximumTriangles / 2 / sides;
  for (std::size_t segment = 0; segment < most; ++segment)
  {
    const auto first = static_cast<std::uint32_t>(segment * (4 + 2 * sides));
    indices.insert(indices.end(), { first, first + 1, first + 4, first + 2, first + 3, first + 5 });
    for (std::uint32_t end = 0; end < 2; ++end)
    {
      const std::uint32_t corner = first + 2 * end, fan = first + 6 + end * (sides - 1);
      for (std::uint32_t i = 0; i + 1 < sides; ++i)
      {
        const std::uint32_t next = i + 2 < sides ? fan + i + 1 : corner + 1;
        indices.insert(indices.end(), { corner, fan + i, next });
      }
    }
  }
  return indices;
}

// The greatest product of a direction in the mesh with its points, of lines and points each with what their widths add.
double ThickPrimitives::GreatestOf(
  const Group& group, const glm::dvec3& direction, double least) const
{
  double greatest = least;
  const ThickData& data = group.Of->Data;
  for (const bool isBalls : { false, true })
  {
    const double radius = isBalls ? group.Radii.y : group.Radii.x;
    for (const double sign : { 1.0, -1.0 }) // before and behind the eye
    {
      const glm::dvec3 world = direction + sign * radius * glm::dvec3(group.Distance);
      const glm::dvec3 local = glm::transpose(group.ToWorld) * world;
      const double offset =
        glm::dot(group.Centre, direction) + sign * radius * group.Distance.w;
      for (const ThickBlock& block : isBalls ? data.Balls : data.Lines)
      {
        const glm::dvec3 farthest(local.x > 0 ? block.High.x : block.Low.x,
          local.y > 0 ? block.High.y : block.Low.y, local.z > 0 ? block.High.z : block.Low.z);
        if (offset + glm::dot(farthest, local) <= greatest)
        {
          continue;
        }
        for (std::uint32_t i = block.First; i < block.First + block.Count; ++i)
        {
          for (const std::uint32_t end : { data.Segments[i].Start, data.Segments[i].End })
          {
            const glm::dvec3 point(data.Points[ThickSegment::Point(end)]);
            greatest = std::max(greatest, offset + glm::dot(point, local));
          }
        }
      }
    }
  }
  return greatest;
}

glm::dvec2 ThickPrimitives::Extent(const glm::dvec3& direction) const
{
  double least = Infinity, greatest = -Infinity;
  for (const Group& group : this->Placed)
  {
    greatest = this->GreatestOf(group, direction, greatest);
    least = -this->GreatestOf(group, -direction, -least);
  }
  return { least, greatest };
}

// Places the runs, once after each update.
void ThickPrimitives::PlaceRuns(const ThickPlace& place)
{
  if (this->HasPlaced)
  {
    return;
  }
  this->HasPlaced = true;
  std::vector<GpuRun> runs;
  auto point = static_cast<std::uint32_t>(place.FirstPoint);
  auto cluster = static_cast<std::uint32_t>(place.FirstCluster);
  for (const ThickRun& run : this->Runs)
  {
    runs.push_back({ run.FirstSegment + this->Placed[run.Group].Of->FirstSegment, run.Segments,
      run.Group, ThickRun::Sides[run.Class], point, cluster++, run.IsBalls ? 1u : 0u, 0 });
    point += run.GetPoints();
  }
  this->Runnings.Assign(runs);
}

void ThickPrimitives::Face(const glm::dvec4& light, const ThickPlace& place, const Buffer& points,
  const Buffer& clusters)
{
  if (this->IsEmpty() || !this->Build())
  {
    return;
  }
  std::vector<GpuGroup> groups;
  for (const Group& group : this->Placed)
  {
    const glm::dmat3& m = group.ToWorld;
    groups.push_back({ { glm::vec4(m[0], 0), glm::vec4(m[1], 0), glm::vec4(m[2], 0) },
      glm::vec4(group.Distance), glm::vec4(glm::dvec3(light) - light.w * group.Centre, light.w),
      glm::vec2(group.Radii), {} });
  }
  this->Groups.Assign(groups);
  this->PlaceRuns(place);
  this->Facing.Use();
  this->Points.BindStorage(0);
  this->Segments.BindStorage(1);
  this->Groups.BindStorage(2);
  this->Runnings.BindStorage(3);
  points.BindStorage(4);
  clusters.BindStorage(5);
  const int count = static_cast<int>(this->Runs.size());
  this->Facing.Set("rtwNumberOfThick", count);
  Dispatch(std::min(count, MostGroups), rtw::Groups(count, MostGroups));
}

std::size_t ThickPrimitives::GetMemory() const
{
  return this->Points.GetSize() + this->Segments.GetSize() + this->Groups.GetSize() +
    this->Runnings.GetSize();
}

void ThickPrimitives::Dispose(Disposal dispose)
{
  dispose(this->Facing, this->Buffers());
  this->Meshes.clear();
  this->Placed.clear();
  this->Runs.clear();
  this->NumberOfPoints = 0;
  this->Changed = true;
}
}
