// View samples, as rtwViewSampleFS.glsl and rtwMapperOutput.glsl write them: where the surface that a pixel shows lies, and where
// its tangent plane does under the pixels beside it.
uniform sampler2D rtwSamples;
uniform vec4 rtwRay;    // clip to view coordinates, before the division: scale, offset
uniform vec2 rtwShear;  // what a sample adds to x and y where the eye is beside the camera, in stereo
uniform vec4 rtwOfSample;  // a sample to view coordinates: z is (x + y a) / (z + w a), and all are divided by the latter
uniform vec4 rtwViewer; // in view coordinates: the eye and 1, or the direction to it and 0
uniform float rtwViewBegin; // distance from the camera along the view at which view coordinates begin

float rtwDivisor(float a)
{
  return rtwOfSample.z + rtwOfSample.w * a;
}

vec3 rtwViewPosition(vec2 clip, float a)
{
  return vec3(clip * rtwRay.xy + rtwRay.zw + rtwShear * a, rtwOfSample.x + rtwOfSample.y * a) / rtwDivisor(a);
}

vec3 rtwToViewer(vec3 p)
{
  return rtwViewer.xyz - rtwViewer.w * p;
}

// The distance of a point from the camera along the view.
float rtwDistance(vec3 p)
{
  return rtwViewBegin - p.z;
}

struct SampledPlane
{
  bool seen;
  vec3 here;
  vec3 right; // the step along the plane to the pixel on the right; `above`: to the one above
  vec3 above;
};

// The plane under a point of a pixel, which lies `offset` pixels beside the pixel's centre.
SampledPlane rtwPlaneAt(vec4 s, ivec2 pixel, vec2 offset)
{
  vec2 step = 2.0 / vec2(textureSize(rtwSamples, 0));
  vec2 clip = (vec2(pixel) + 0.5 + offset) * step - 1.0;
  // A plane that is seen nearly edge on leaves the view within a pixel.
  float least = rtwOfSample.w > 0.0 ? (0.01 * rtwDivisor(s.x) - rtwOfSample.z) / rtwOfSample.w : -1e30;
  float a = max(s.x + dot(s.yz, offset), least);
  least = rtwOfSample.w > 0.0 ? (0.01 * rtwDivisor(a) - rtwOfSample.z) / rtwOfSample.w : -1e30;
  vec2 beside = max(a + s.yz, vec2(least));
  SampledPlane plane;
  plane.seen = s.w > 0.0 && rtwDivisor(a) > 0.0;
  plane.here = rtwViewPosition(clip, a);
  plane.right = rtwViewPosition(clip + vec2(step.x, 0.0), beside.x);
  plane.above = rtwViewPosition(clip + vec2(0.0, step.y), beside.y);
  return plane;
}

SampledPlane rtwLoadPlane(ivec2 pixel)
{
  return rtwPlaneAt(texelFetch(rtwSamples, pixel, 0), pixel, vec2(0.0));
}
