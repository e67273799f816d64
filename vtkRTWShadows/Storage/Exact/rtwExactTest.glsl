// Tests some samples against a triangle, in unwarped light space, with the sample as the origin (Woop et al. 2013): an
// edge is computed from its two ends in the same way for both triangles that share it, so that none of them, or both,
// have it, but never neither.
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer Listed
{
  vec4 rtwListed[];
};
layout(std430, binding = 1) readonly buffer Owners
{
  uint rtwOwners[];
};
layout(std430, binding = 2) buffer States
{
  uint rtwStates[];
};

uniform vec3 rtwFrom; // where view coordinates begin, in the coordinates of rtwInSpace()
uniform float rtwReference; // r of rtwCountSamples.glsl

const float SAMPLE_ROUNDING = 2.4e-7; // twice a float's relative rounding error
const float BROAD = 16.0;             // length of a broad triangle, in widths, at most
const float SLIMMEST = 1e4;           // length of a triangle that can be seen, in widths, at most
const float PARALLEL = 0.02;          // the most that parallel normals differ by

// The distance of a depth along the light's axis, in units of the reference.
float rtwDistanceTo(float depth)
{
  return rtwReference > 0.0 ? rtwReference / (rtwReference - depth) : 1.0;
}

// Light-plane coordinates and depth as a place in space, along the light from the reference.
vec3 rtwInSpace(vec3 l)
{
  float w = rtwDistanceTo(l.z);
  return rtwReference > 0.0 ? vec3(l.xy * rtwReference, l.z) * w : l;
}

// The factor that makes a slope of lengths of a slope of depth on the light plane.
float rtwSlopeUnit(float depth)
{
  return rtwReference > 0.0 ? rtwDistanceTo(depth) / rtwReference : 1.0;
}

// Whether a sample lies on the triangle: the triangle is near and parallel to it. Rasterizers interpolate depth by
// differences between corners, so that the longer a triangle is for its width, the farther off it its samples lie.
bool rtwIsOwn(ExactCaster t, vec4 s)
{
  vec3 a = rtwInSpace(t.a.xyz);
  vec3 ab = rtwInSpace(t.b.xyz) - a;
  vec3 ac = rtwInSpace(t.c.xyz) - a;
  vec3 bc = ac - ab;
  vec3 area = cross(ab, ac);
  float aspect = max(max(dot(ab, ab), dot(ac, ac)), dot(bc, bc)) / max(length(area), 1e-30);
  if (aspect < BROAD)
  {
    return false;
  }
  vec3 onLight = cross(t.b.xyz - t.a.xyz, t.c.xyz - t.a.xyz);
  onLight = normalize(vec3(onLight.xy * rtwSlopeUnit(s.z), onLight.z)) * (onLight.z < 0.0 ? -1.0 : 1.0);
  vec3 at = rtwInSpace(s.xyz);
  float off = abs(dot(at - a, area)) / max(length(area), 1e-30);
  return distance(onLight, rtwUnpackNormal(s.w)) < PARALLEL && off < SAMPLE_ROUNDING * min(aspect, SLIMMEST) * distance(at, rtwFrom);
}

bool rtwShadows(ExactCaster t, vec3 s)
{
  precise vec3 a = t.a.xyz - s;
  precise vec3 b = t.b.xyz - s;
  precise vec3 c = t.c.xyz - s;
  precise float u = b.x * c.y - b.y * c.x;
  precise float v = c.x * a.y - c.y * a.x;
  precise float w = a.x * b.y - a.y * b.x;
  bool left = min(min(u, v), w) >= 0.0;
  bool right = max(max(u, v), w) <= 0.0;
  float nearer = u * a.z + v * b.z + w * c.z;
  return (left && nearer < 0.0) || (right && nearer > 0.0);
}

void main()
{
  uint i = gl_GlobalInvocationID.x;
  if (i >= rtwItems(TEST))
  {
    return;
  }
  uint place = rtwQueuePlace(TEST, i);
  ExactCaster t = rtwExactCasters[rtwQueue[place]];
  uint item = rtwQueue[place + 1u];
  uint first = item & (1u << (32u - CHUNK_BITS)) - 1u;
  uint end = first + (item >> (32u - CHUNK_BITS)) + 1u;
  for (uint k = first; k < end; ++k)
  {
    vec4 s = rtwListed[k];
    if (rtwShadows(t, s.xyz) && !rtwIsOwn(t, s))
    {
      uint owner = rtwOwners[k];
      rtwListed[k].z = NO_DEPTH;
      atomicOr(rtwStates[owner & OWNER_PIXELS], 1u << (owner >> OWNER_PIXEL_BITS));
    }
  }
}
