// View samples, as rtwViewSampleFS.glsl and rtwMapperOutput.glsl write them: where the surface that a pixel shows lies, and where
// its tangent plane does under the pixels beside it.
uniform sampler2D rtwSamples;
uniform vec4 rtwRay;          // clip to view coordinates at distance 1, or in a parallel view: scale, offset
uniform vec2 rtwShear;        // of an eye beside the camera: shift, or in a parallel view shift at distance 1
uniform vec2 rtwParallelView; // in a parallel view depth to distance: scale, offset; the scale is 0 otherwise

vec3 rtwViewPosition(vec2 clip, float a)
{
  vec2 xy = clip * rtwRay.xy + rtwRay.zw;
  if (rtwParallelView.x != 0.0)
  {
    float distance = a * rtwParallelView.x + rtwParallelView.y;
    return vec3(xy + rtwShear * distance, -distance);
  }
  return vec3(xy, -1.0) / a + vec3(rtwShear, 0.0);
}

// From a point to the eye, or in a parallel view towards it, one unit of distance.
vec3 rtwToEye(vec3 here)
{
  return rtwParallelView.x != 0.0 ? vec3(-rtwShear, 1.0) : vec3(rtwShear, 0.0) - here;
}

struct SampledPlane
{
  bool seen;
  vec3 here;
  vec3 right; // one pixel on
  vec3 above;
};

// Under a point of a pixel, which lies beside its centre by so many pixels.
SampledPlane rtwPlaneAt(vec4 s, ivec2 pixel, vec2 offset)
{
  vec2 step = 2.0 / vec2(textureSize(rtwSamples, 0));
  vec2 clip = (vec2(pixel) + 0.5 + offset) * step - 1.0;
  bool parallel = rtwParallelView.x != 0.0;
  float a = s.x + dot(s.yz, offset);
  a = parallel ? a : max(a, 0.01 * s.x);
  // A plane that is seen nearly edge on leaves the view within a pixel.
  vec2 beside = parallel ? a + s.yz : max(a + s.yz, vec2(0.01 * a));
  SampledPlane plane;
  plane.seen = s.w > 0.0 && (parallel || a > 0.0);
  plane.here = rtwViewPosition(clip, a);
  plane.right = rtwViewPosition(clip + vec2(step.x, 0.0), beside.x);
  plane.above = rtwViewPosition(clip + vec2(0.0, step.y), beside.y);
  return plane;
}

SampledPlane rtwLoadPlane(ivec2 pixel)
{
  return rtwPlaneAt(texelFetch(rtwSamples, pixel, 0), pixel, vec2(0.0));
}
