// The shadow of one light on one receiver: where it lies on the map, and which of the texels there are in front of it.
//
// A receiver at q is in shadow by the texel with centre c if the stored depth is in front of the receiver's tangent plane
// at c, and the occluder's plane at q is in front of the receiver. On a convex surface the first condition rejects
// self-shadowing, on a concave one the second.
uniform sampler2DArray rtwDepths;
uniform sampler2DArray rtwGradients;
uniform int rtwFirstLayer;  // that the first of these lights has
uniform int rtwOtherLayers; // how far behind each light's layer that of its other casters lies
uniform mat4 rtwToLight[RTW_LIGHTS];   // from view coordinates to (l · w, depth · w, w)
uniform vec4 rtwCone[RTW_LIGHTS];      // a spot's: centre, tangent; tangent 0 for a directional light
uniform vec4 rtwTolerance[RTW_LIGHTS]; // of depth: of its format; of a length over w²; of the constant bias over w²; of l over w

const float RTW_NOT_LIT = -1.0; // averted or out of reach: VTK's lighting knows that already

// Light-plane coordinates, depth, and w.
vec4 rtwOnLightPlane(int light, vec3 p)
{
  vec4 h = rtwToLight[light] * vec4(p, 1.0);
  return vec4(h.xyz * (1.0 / h.w), h.w);
}

// Where a texel is wide beside the triangles, a triangle's plane says little of the surface half a texel away; the difference of the
// two planes tells how little.
const float RTW_ROUGHNESS = 0.35;

// Both conditions are computed always: four taps with a branch each cost more than the reads that they save. The occluder's slope is
// compared with the receiver's as `rough` says.
float rtwOccluded(int layer, ivec2 texel, vec2 centre, vec3 q, vec2 gradient, vec2 slope, float rough, float tolerance)
{
  float depth = texelFetch(rtwDepths, ivec3(texel, layer), 0).r;
#if RTW_DEPTH_TEST == 2
  return float(depth < q.z - tolerance);
#else
  vec2 away = q.xy - centre;
  // Bounded, because the tangent plane of a receiver that the light grazes is steep.
  float plane = q.z - max(dot(gradient, away), -0.5);
#if RTW_DEPTH_TEST == 0
  float margin = rough * dot(abs(slope - gradient), abs(away));
  return float(max(depth - plane, depth + dot(slope, away) - q.z) < -tolerance - margin);
#else
  return float(depth - plane < -tolerance);
#endif
#endif
}

vec2 rtwSlope(int layer, ivec2 texel)
{
#if RTW_DEPTH_TEST == 0
  return texelFetch(rtwGradients, ivec3(texel, layer), 0).rg;
#else
  return vec2(0.0);
#endif
}

// 1 lit, 0 in shadow.
float rtwFiltered(int layer, vec3 q, vec2 gradient, float tolerance)
{
  int last = rtwWarpSize.y - 1;
  vec2 at = rtwWarp(layer, q.xy) * float(rtwWarpSize.y);
#if RTW_FILTER == 0
  ivec2 texel = clamp(ivec2(floor(at)), 0, last);
  return 1.0 -
    rtwOccluded(layer, texel, rtwTexelCentres(layer, texel).xz, q, gradient, rtwSlope(layer, texel), 0.0, tolerance);
#else
  ivec2 corner = clamp(ivec2(floor(at - 0.5)), 0, last - 1);
  ivec2 right = corner + ivec2(1, 0);
  ivec2 above = corner + ivec2(0, 1);
  vec2 f = clamp(at - 0.5 - vec2(corner), 0.0, 1.0);
  vec4 c = rtwTexelCentres(layer, corner);
  vec2 a = rtwSlope(layer, corner);
  vec2 b = rtwSlope(layer, right);
  vec2 d = rtwSlope(layer, above);
  vec2 e = rtwSlope(layer, corner + 1);
  // No two neighbours see the same triangle.
  float rough = a != b && a != d && e != b && e != d ? RTW_ROUGHNESS : 0.0;
  vec4 dark = vec4(rtwOccluded(layer, corner, c.xz, q, gradient, a, rough, tolerance),
    rtwOccluded(layer, right, c.yz, q, gradient, b, rough, tolerance),
    rtwOccluded(layer, above, c.xw, q, gradient, d, rough, tolerance),
    rtwOccluded(layer, corner + 1, c.yw, q, gradient, e, rough, tolerance));
  vec2 rows = mix(dark.xz, dark.yw, f.x);
  return 1.0 - mix(rows.x, rows.y, f.y);
#endif
}

// How much of a light reaches a receiver, between 0 and 1, or RTW_NOT_LIT. dx and dy lead to the points of its tangent plane one
// pixel to the right and one above, on the light plane and in depth.
float rtwVisibility(int light, vec4 l, vec3 dx, vec3 dy)
{
  float area = dx.x * dy.y - dx.y * dy.x;
  // A surface that faces both viewer and light is seen the other way round from the light plane's back.
  vec3 cone = rtwCone[light].xyz;
  bool faces = area < 0.0 && l.w > 0.0 && (cone.z == 0.0 || distance(l.xy, cone.xy) <= cone.z);
  float visibility = faces ? 1.0 : RTW_NOT_LIT;
  int layer = light + rtwFirstLayer;
  vec4 focus = rtwFocus(layer);
  vec3 q = vec3(rtwFocused(focus, l.xy), l.z);
  if (faces && all(equal(clamp(q.xy, 0.0, 1.0), q.xy)))
  {
    // Differences on one plane give its gradient whatever their length.
    vec2 gradient = vec2(dx.z * dy.y - dy.z * dx.y, dx.x * dy.z - dy.x * dx.z) / (area * focus.yw);
    vec4 t = rtwTolerance[light];
    // A length in units of depth shrinks with the square of the distance to a spot; w is 1 elsewhere.
#if RTW_DEPTH_TEST == 2
    float tolerance = t.z / (l.w * l.w);
#else
    // A rounded position is off sideways too: by as much more as it is nearer to the plane of a spot and farther from its axis.
    vec2 aside = 1e-6 + t.w / l.w * (1.0 + distance(l.xy, cone.xy)) * focus.yw;
    float tolerance = t.x + t.y / (l.w * l.w) + dot(abs(gradient), aside);
#endif
    visibility = rtwFiltered(layer, q, gradient, tolerance);
#if RTW_OTHER_LAYERS
    visibility = min(visibility, rtwFiltered(layer + rtwOtherLayers, q, gradient, tolerance));
#endif
  }
  return visibility;
}
