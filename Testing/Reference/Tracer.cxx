// SPDX-License-Identifier: BSD-3-Clause
#include "rtwTracer.h"

#include "rtwEmbree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rtw
{
namespace
{
constexpr float INFINITE = std::numeric_limits<float>::infinity();

// A query with what its callbacks must know. The context comes first: Embree gives that back.
struct Query
{
  EmbreeContext Context;
  const Geometry* Scene;
  RayKind Kind;
  Primitive But;
};

bool IsClipped(const PropTraits& traits, const dvec3& p)
{
  return std::any_of(traits.ClippingPlanes.begin(), traits.ClippingPlanes.end(),
    [&](const glm::dvec4& plane) { return glm::dot(plane, glm::dvec4(p, 1)) < 0; });
}

// Whether a ray goes on behind a primitive that it meets at p. `facing` is negative where it comes
// from the front.
bool PassesThrough(const Query& query, const Primitive& primitive, const dvec3& p, double facing)
{
  const PropTraits& traits = Traits(*query.Scene, primitive);
  const bool isOut = query.Kind == RayKind::SHADOW
    ? !traits.Casts || primitive == query.But
    : !traits.IsSeen || (facing < 0 ? traits.CullsFront : traits.CullsBack);
  return isOut || IsClipped(traits, p);
}

void FilterTriangle(const RTCFilterFunctionNArguments* arguments)
{
  const auto* query = reinterpret_cast<const Query*>(arguments->context);
  const RTCRay ray = rtcGetRayFromRayN(arguments->ray, arguments->N, 0);
  const RTCHit hit = rtcGetHitFromHitN(arguments->hit, arguments->N, 0);
  const dvec3 direction(ray.dir_x, ray.dir_y, ray.dir_z);
  const dvec3 p = dvec3(ray.org_x, ray.org_y, ray.org_z) + double(ray.tfar) * direction;
  const double facing = glm::dot(dvec3(hit.Ng_x, hit.Ng_y, hit.Ng_z), direction);
  if (PassesThrough(*query, { Shape::TRIANGLE, hit.primID }, p, facing))
  {
    arguments->valid[0] = 0;
  }
}

void SetBounds(const dvec3& centre, const dvec3& reach, RTCBounds* bounds)
{
  // To the next number outwards, so that nothing of the solid is lost to rounding.
  const auto below = [](double x) { return std::nextafter(float(x), -INFINITE); };
  const auto above = [](double x) { return std::nextafter(float(x), INFINITE); };
  const dvec3 low = centre - reach, high = centre + reach;
  bounds->lower_x = below(low.x);
  bounds->lower_y = below(low.y);
  bounds->lower_z = below(low.z);
  bounds->upper_x = above(high.x);
  bounds->upper_y = above(high.y);
  bounds->upper_z = above(high.z);
}

dvec3 Reach(const Ball& ball)
{
  return dvec3(ball.Radius);
}

dvec3 Reach(const Stick& stick)
{
  return glm::abs(stick.Axis) * stick.HalfLength + dvec3(stick.Radius);
}

// A list of solids as Embree's user geometry. Solids are intersected in double precision.
template <class Solid, Shape KIND>
struct Solids
{
  static void Bounds(const RTCBoundsFunctionArguments* arguments)
  {
    const Solid& solid = static_cast<const Solid*>(arguments->geometryUserPtr)[arguments->primID];
    SetBounds(solid.Centre, Reach(solid), arguments->bounds_o);
  }

  // The nearest crossing within the ray that the ray does not pass through.
  static std::optional<double> Crossing(
    const Query& query, const Solid& solid, uint32_t index, const RTCRay& from)
  {
    const Ray ray{ { from.org_x, from.org_y, from.org_z }, { from.dir_x, from.dir_y, from.dir_z },
      from.tnear, from.tfar };
    double distances[2];
    if (!Cross(solid, ray, distances))
    {
      return std::nullopt;
    }
    for (int i = 0; i < 2; ++i)
    {
      const double distance = distances[i], facing = i == 0 ? -1 : 1;
      if (distance >= ray.Nearest && distance <= ray.Farthest &&
        !PassesThrough(query, { KIND, index }, ray.At(distance), facing))
      {
        return distance;
      }
    }
    return std::nullopt;
  }

  static void Intersect(const RTCIntersectFunctionNArguments* arguments)
  {
    const auto* query = reinterpret_cast<const Query*>(arguments->context);
    auto* solids = static_cast<const Solid*>(arguments->geometryUserPtr);
    auto* rayHit = reinterpret_cast<RTCRayHit*>(arguments->rayhit);
    const auto distance =
      Crossing(*query, solids[arguments->primID], arguments->primID, rayHit->ray);
    if (distance)
    {
      rayHit->ray.tfar = float(*distance);
      rayHit->hit.geomID = arguments->geomID;
      rayHit->hit.primID = arguments->primID;
    }
  }

  static void Occlude(const RTCOccludedFunctionNArguments* arguments)
  {
    const auto* query = reinterpret_cast<const Query*>(arguments->context);
    auto* solids = static_cast<const Solid*>(arguments->geometryUserPtr);
    auto* ray = reinterpret_cast<RTCRay*>(arguments->ray);
    if (Crossing(*query, solids[arguments->primID], arguments->primID, *ray))
    {
      ray->tfar = -INFINITE;
    }
  }

  static void Attach(RTCDevice device, RTCScene scene, const std::vector<Solid>& solids)
  {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, unsigned(solids.size()));
    rtcSetGeometryUserData(geometry, const_cast<Solid*>(solids.data()));
    rtcSetGeometryBoundsFunction(geometry, Bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, Intersect);
    rtcSetGeometryOccludedFunction(geometry, Occlude);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, unsigned(KIND));
    rtcReleaseGeometry(geometry);
  }
};

void AttachTriangles(RTCDevice device, RTCScene scene, const Geometry& from)
{
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
    geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), from.Points.size()));
  auto* corners = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX,
    0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), from.Triangles.size()));
  if ((!points && !from.Points.empty()) || (!corners && !from.Triangles.empty()))
  {
    throw std::runtime_error("Embree has no memory for the triangles");
  }
  for (size_t i = 0; i < from.Points.size(); ++i)
  {
    points[i] = from.Points[i];
  }
  for (size_t i = 0; i < from.Triangles.size(); ++i)
  {
    corners[i] = from.Triangles[i].Corners;
  }
  rtcSetGeometryIntersectFilterFunction(geometry, FilterTriangle);
  rtcSetGeometryOccludedFilterFunction(geometry, FilterTriangle);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, unsigned(Shape::TRIANGLE));
  rtcReleaseGeometry(geometry);
}

RTCRay MakeRay(const Ray& from)
{
  const glm::vec3 o(from.Origin), d(from.Direction);
  RTCRay ray{};
  ray.org_x = o.x;
  ray.org_y = o.y;
  ray.org_z = o.z;
  ray.dir_x = d.x;
  ray.dir_y = d.y;
  ray.dir_z = d.z;
  ray.tnear = float(from.Nearest);
  ray.tfar = float(from.Farthest);
  ray.mask = ~0u;
  return ray;
}
}

struct Tracer::Internals
{
  Geometry Shapes;
  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;
};

Tracer::Tracer(Geometry geometry)
  : Inside(std::make_unique<Internals>())
{
  Internals& inside = *this->Inside;
  inside.Shapes = std::move(geometry);
  inside.Device = rtcNewDevice(nullptr);
  if (!inside.Device)
  {
    throw std::runtime_error("Embree cannot be started");
  }
  inside.Scene = rtcNewScene(inside.Device);
  AttachTriangles(inside.Device, inside.Scene, inside.Shapes);
  Solids<Ball, Shape::BALL>::Attach(inside.Device, inside.Scene, inside.Shapes.Balls);
  Solids<Stick, Shape::STICK>::Attach(inside.Device, inside.Scene, inside.Shapes.Sticks);
  rtcSetSceneFlags(inside.Scene, RTC_SCENE_FLAG_ROBUST);
  rtcCommitScene(inside.Scene);
}

Tracer::~Tracer()
{
  rtcReleaseScene(this->Inside->Scene);
  rtcReleaseDevice(this->Inside->Device);
}

const Geometry& Tracer::Scene() const
{
  return this->Inside->Shapes;
}

std::optional<Hit> Tracer::First(const Ray& ray) const
{
  Query query{ {}, &this->Inside->Shapes, RayKind::VIEW, {} };
  InitContext(&query.Context);
  RTCRayHit rayHit{};
  rayHit.ray = MakeRay(ray);
  rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  Intersect(this->Inside->Scene, &query.Context, &rayHit);
  if (rayHit.hit.geomID == RTC_INVALID_GEOMETRY_ID)
  {
    return std::nullopt;
  }
  return Hit{ rayHit.ray.tfar, { Shape(rayHit.hit.geomID), rayHit.hit.primID } };
}

bool Tracer::IsBlocked(const Ray& ray, const Primitive& but) const
{
  Query query{ {}, &this->Inside->Shapes, RayKind::SHADOW, but };
  InitContext(&query.Context);
  RTCRay shadowRay = MakeRay(ray);
  Occluded(this->Inside->Scene, &query.Context, &shadowRay);
  return shadowRay.tfar < 0;
}
}
