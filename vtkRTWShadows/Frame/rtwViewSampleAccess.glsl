// A view sample, as every analysis sees it: the point on the surface, its normal towards the viewer, where it lies on the light
// plane, and how far the pixel reaches there.
layout(binding = 0) uniform sampler2D rtwSampleDepth; // window-space depth
layout(binding = 1) uniform sampler2D rtwSampleSlope; // its change from sample to sample, exact on a plane
uniform mat4 rtwClipToView;
uniform mat4 rtwViewToLight;
uniform vec4 rtwTowardsLight; // w 0: the direction to the light in view coordinates; w 1: its position
uniform vec3 rtwCone;         // a spot's: centre and tangent
uniform int rtwParallel;      // whether the camera is

struct ViewSample
{
  bool used; // there is a surface, and it faces the light and lies in its reach
  vec3 position;
  vec3 normal;
  vec2 onLight;
  vec2 footprint;
};

vec4 rtwUnproject(vec3 clip)
{
  vec4 p = rtwClipToView * vec4(clip, 1.0);
  return vec4(p.xyz / p.w, p.w);
}

vec2 rtwOnLight(vec3 position)
{
  vec4 p = rtwViewToLight * vec4(position, 1.0);
  return p.xy / p.w;
}

ViewSample rtwLoadSample(ivec2 pixel)
{
  ViewSample s;
  s.used = false;
  float depth = texelFetch(rtwSampleDepth, pixel, 0).r;
  if (!(depth < 1.0))
  {
    return s;
  }
  vec2 slope = texelFetch(rtwSampleSlope, pixel, 0).rg;
  vec2 size = vec2(textureSize(rtwSampleDepth, 0));
  vec3 clip = vec3((vec2(pixel) + 0.5) / size * 2.0 - 1.0, 2.0 * depth - 1.0);
  vec4 here = rtwUnproject(clip);
  vec4 right = rtwUnproject(clip + vec3(2.0 / size.x, 0.0, 2.0 * slope.x));
  vec4 above = rtwUnproject(clip + vec3(0.0, 2.0 / size.y, 2.0 * slope.y));
  s.position = here.xyz;
  vec3 normal = cross(right.xyz - here.xyz, above.xyz - here.xyz);
  normal = (rtwParallel != 0 ? normal.z < 0.0 : dot(normal, s.position) > 0.0) ? -normal : normal;
  s.normal = normal / max(length(normal), 1e-30);
  vec3 towards = rtwTowardsLight.w > 0.0 ? rtwTowardsLight.xyz - s.position : rtwTowardsLight.xyz;
  bool facing = dot(s.normal, towards) > 1e-3 * length(towards);
  vec4 onLight = rtwViewToLight * vec4(s.position, 1.0);
  s.onLight = onLight.xy / onLight.w;
  bool reached = rtwTowardsLight.w == 0.0 ||
    (onLight.w > 0.0 && distance(s.onLight, rtwCone.xy) <= rtwCone.z);
  vec2 dx = rtwOnLight(right.xyz) - s.onLight;
  vec2 dy = rtwOnLight(above.xyz) - s.onLight;
  s.footprint = vec2(length(vec2(dx.x, dy.x)), length(vec2(dx.y, dy.y)));
  s.used = facing && reached && here.w * right.w > 0.0 && here.w * above.w > 0.0;
  return s;
}
