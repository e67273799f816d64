// Which texels of a map are in front of a receiver.
//
// A receiver at q is in shadow by the texel with centre c if the stored depth is in front of the receiver's tangent plane
// at c, and the occluder's plane at q is in front of the receiver. On a convex surface the first condition rejects
// self-shadowing, on a concave one the second.
uniform sampler2DArray rtwDepths;
uniform sampler2DArray rtwGradients;

struct rtwReceiver
{
  vec3 q;          // focus coordinates, and depth
  vec2 gradient;   // of depth over the receiver's tangent plane, in focus coordinates
  float tolerance; // of depth
};

// Where a texel is wide beside the triangles, a triangle's plane says little of the surface half a texel away; the difference of the
// two planes tells how little.
const float RTW_ROUGHNESS = 0.35;

vec2 rtwSlope(int layer, ivec2 texel)
{
#if RTW_DEPTH_TEST == 0
  return texelFetch(rtwGradients, ivec3(texel, layer), 0).rg;
#else
  return vec2(0.0);
#endif
}

// Both conditions are computed always: four taps with a branch each cost more than the reads that they save. The occluder's slope is
// compared with the receiver's as `rough` says.
float rtwOccluded(int layer, ivec2 texel, vec2 centre, rtwReceiver r, vec2 slope, float rough)
{
  float depth = texelFetch(rtwDepths, ivec3(texel, layer), 0).r;
#if RTW_DEPTH_TEST == 2
  return float(depth < r.q.z - r.tolerance);
#else
  vec2 away = r.q.xy - centre;
  // Bounded, because the tangent plane of a receiver that the light grazes is steep.
  float plane = r.q.z - max(dot(r.gradient, away), -0.5);
#if RTW_DEPTH_TEST == 0
  float margin = rough * dot(abs(slope - r.gradient), abs(away));
  return float(max(depth - plane, depth + dot(slope, away) - r.q.z) < -r.tolerance - margin);
#else
  return float(depth - plane < -r.tolerance);
#endif
#endif
}
