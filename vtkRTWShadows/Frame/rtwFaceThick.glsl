// Lines and points as rods and balls: what a light sees of each, a flat piece through its middle that faces the light, so that it shadows
// as the round thing does and nothing of that thing. A cluster a work group.
layout(local_size_x = 64) in;

// A group of lines or points, laid out by the rules of std430.
struct ThickGroup
{
  vec4 toWorld[3]; // columns: from the mesh to the world, less where its centre lies
  vec4 distance;   // along the view, there: of (point, 1); negative behind the eye
  vec4 light;      // where it stands there, or with w = 0 the way to it
  vec2 radii;      // radii of lines and points per unit of that distance
  vec2 unused;
};
struct ThickCluster
{
  uint firstSegment;
  uint segments;
  uint group;
  uint sides;      // pieces of a half circle
  uint firstPoint; // number of the first point that is written
  uint cluster; // number of the cluster that is written
  uint isBalls;
  uint unused;
};
struct Cluster // the same as in rtwClusterDraw.glsl
{
  vec3 low;
  float largestExtent;
  vec3 high;
  uint firstIndex;
  uint baseVertex;
  uint unused[3];
  uint classEnd[8];
};

layout(std430, binding = 0) readonly buffer ThickPoints
{
  float rtwThickPoints[];
};
layout(std430, binding = 1) readonly buffer Segments
{
  uvec2 rtwSegments[];
};
layout(std430, binding = 2) readonly buffer ThickGroups
{
  ThickGroup rtwGroups[];
};
layout(std430, binding = 3) readonly buffer ThickClusters
{
  ThickCluster rtwThickClusters[];
};
layout(std430, binding = 4) buffer Points
{
  float rtwPoints[];
};
layout(std430, binding = 5) buffer Clusters
{
  Cluster rtwClusters[];
};
uniform int rtwNumberOfThick;

const uint JOINED = 1u << 31u;
const float PI = 3.14159265;
// The share of the squared distance to a lamp: one of a larger squared radius has the lamp inside.
const float MOST_OF_DISTANCE = 0.25;
const float PARALLEL = 1e-6;         // the sine of an angle

shared vec3 rtwLow[64];
shared vec3 rtwHigh[64];
shared float rtwLargest[64];

vec3 low = vec3(1e30);
vec3 high = vec3(-1e30);

void rtwWrite(uint place, vec3 p)
{
  low = min(low, p);
  high = max(high, p);
  rtwPoints[3u * place] = p.x;
  rtwPoints[3u * place + 1u] = p.y;
  rtwPoints[3u * place + 2u] = p.z;
}

vec3 rtwPlaced(uint end, ThickGroup group)
{
  uint i = 3u * (end & ~JOINED);
  return group.toWorld[0].xyz * rtwThickPoints[i] + group.toWorld[1].xyz * rtwThickPoints[i + 1u] +
    group.toWorld[2].xyz * rtwThickPoints[i + 2u];
}

vec3 rtwToLight(vec3 p, vec4 light)
{
  vec3 to = light.xyz - light.w * p;
  return to / max(length(to), 1e-30);
}

// What a lamp sees of a round thing is as wide in its middle as its tangents are there.
float rtwWidened(float radius, float away, vec4 light)
{
  float share = light.w > 0.0 ? radius * radius / max(away * away, 1e-30) : 0.0;
  return radius * inversesqrt(1.0 - min(share, MOST_OF_DISTANCE));
}

vec3 rtwAcross(vec3 t)
{
  return normalize(cross(t, abs(t.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
}

// An end from one side to the other: round where the next goes on, facing the light, and elsewhere the face of a rod that is cut off.
void rtwWriteEnd(uint place, uint sides, vec3 p, vec3 across, float radius, vec3 on, vec3 t, bool joined)
{
  float along = dot(on, t);
  vec3 side = joined ? on - along * t : (along > 0.0 ? along * on - t : t - along * on);
  side = length(side) > PARALLEL ? normalize(side) : cross(across, on);
  for (uint i = 1u; i < sides; ++i)
  {
    float turn = PI * float(i) / float(sides);
    rtwWrite(place + i - 1u, p + radius * (cos(turn) * across + sin(turn) * side));
  }
}

void rtwWriteBall(uint first, uint sides, vec3 p, float radius, vec4 light)
{
  vec3 t = rtwToLight(p, light);
  vec3 across = rtwAcross(t);
  vec3 side = cross(across, t);
  if (sides == 1u) // a square
  {
    float corner = rtwWidened(radius, distance(light.xyz, p), light) * sqrt(0.5 * PI);
    for (uint i = 0u; i < 4u; ++i)
    {
      rtwWrite(first + i, p + ((i & 1u) == 0u ? corner : -corner) * across);
    }
    rtwWrite(first + 4u, p + corner * side);
    rtwWrite(first + 5u, p - corner * side);
    return;
  }
  // The polygon has the same area as the circle.
  float turn = PI / float(sides);
  float reach = rtwWidened(radius, distance(light.xyz, p), light) * sqrt(turn / sin(turn));
  for (uint i = 0u; i < 4u; ++i)
  {
    rtwWrite(first + i, p + ((i & 1u) == 0u ? reach : -reach) * across);
  }
  rtwWrite(first + 4u, p - reach * across);
  rtwWrite(first + 5u, p + reach * across);
  for (uint i = 1u; i < sides; ++i)
  {
    vec3 x = reach * cos(turn * float(i)) * across;
    vec3 y = reach * sin(turn * float(i)) * side;
    rtwWrite(first + 5u + i, p + x + y);
    rtwWrite(first + 4u + sides + i, p + x - y);
  }
}

void rtwWriteRod(uint first, uint sides, vec3 a, vec3 b, vec2 radii, vec4 light, bvec2 joined)
{
  vec3 along = b - a;
  float size = length(along);
  vec3 on = along / max(size, 1e-30);
  vec3 ta = rtwToLight(a, light);
  vec3 tb = rtwToLight(b, light);
  vec3 across = cross(on, ta);
  float away = length(across) * distance(light.xyz, a);
  bool isEndOn = length(across) <= PARALLEL;
  across = isEndOn ? rtwAcross(ta) : normalize(across);
  float ra = isEndOn ? abs(radii.x) : rtwWidened(abs(radii.x), away, light);
  float rb = isEndOn ? abs(radii.y) : rtwWidened(abs(radii.y), away, light);
  if (size == 0.0)
  {
    ra = rb = 0.0;
  }
  rtwWrite(first, a + ra * across);
  rtwWrite(first + 1u, a - ra * across);
  rtwWrite(first + 2u, b + rb * across);
  rtwWrite(first + 3u, b - rb * across);
  // What passes beside the eye has no width there.
  bool passes = radii.x * radii.y < 0.0;
  vec3 narrow = mix(a, b, passes ? radii.x / (radii.x - radii.y) : 0.0);
  rtwWrite(first + 4u, passes ? narrow : b - rb * across);
  rtwWrite(first + 5u, passes ? narrow : a + ra * across);
  rtwWriteEnd(first + 6u, sides, a, across, ra, -on, ta, joined.x);
  rtwWriteEnd(first + 5u + sides, sides, b, across, rb, on, tb, joined.y);
}

void rtwWriteSegment(ThickCluster cluster, uint segment)
{
  ThickGroup group = rtwGroups[cluster.group];
  uvec2 ends = rtwSegments[cluster.firstSegment + segment];
  vec3 a = rtwPlaced(ends.x, group);
  vec3 b = rtwPlaced(ends.y, group);
  uint first = cluster.firstPoint + (4u + 2u * cluster.sides) * segment;
  float there = dot(group.distance, vec4(a, 1.0));
  if (cluster.isBalls != 0u)
  {
    rtwWriteBall(first, cluster.sides, a, group.radii.y * abs(there), group.light);
    return;
  }
  vec2 radii = group.radii.x * vec2(there, dot(group.distance, vec4(b, 1.0)));
  rtwWriteRod(first, cluster.sides, a, b, radii, group.light, notEqual(ends & JOINED, uvec2(0u)));
}

void main()
{
  uint i = gl_WorkGroupID.x + gl_NumWorkGroups.x * gl_WorkGroupID.y;
  if (i >= uint(rtwNumberOfThick))
  {
    return;
  }
  ThickCluster cluster = rtwThickClusters[i];
  uint lane = gl_LocalInvocationID.x;
  if (lane < cluster.segments)
  {
    rtwWriteSegment(cluster, lane);
  }
  rtwLow[lane] = low;
  rtwHigh[lane] = high;
  vec3 extent = high - low;
  rtwLargest[lane] = max(max(extent.x, extent.y), max(extent.z, 0.0));
  for (uint other = 32u; other > 0u; other >>= 1u)
  {
    barrier();
    if (lane < other)
    {
      rtwLow[lane] = min(rtwLow[lane], rtwLow[lane + other]);
      rtwHigh[lane] = max(rtwHigh[lane], rtwHigh[lane + other]);
      rtwLargest[lane] = max(rtwLargest[lane], rtwLargest[lane + other]);
    }
  }
  if (lane == 0u)
  {
    rtwClusters[cluster.cluster].low = rtwLow[0];
    rtwClusters[cluster.cluster].high = rtwHigh[0];
    rtwClusters[cluster.cluster].largestExtent = rtwLargest[0];
  }
}
