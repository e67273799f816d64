// Where a pixel's surface lies on the light plane, and how far that moves from pixel to pixel. By derivatives, because perspective and a
// spot bend differences to the next pixel.
struct MovingSample
{
  bool seen;   // there is a receiver
  bool lit; // the receiver faces the light and lies in its reach
  vec3 here;   // its place in view coordinates
  vec3 right;  // the step from there to the pixel on the right; `above`: to the one above
  vec3 above;
  vec4 h;      // its homogeneous light-plane coordinates
  mat2 moves;  // the two steps on the light plane
};

// The step on the light plane of a point with the homogeneous light-plane coordinates h that moves by `step` in view
// coordinates.
vec2 rtwMovesOnLight(vec4 h, vec3 step)
{
  vec4 change = rtwViewToLight * vec4(step, 0.0);
  return (change.xy - h.xy / h.w * change.w) / h.w;
}

MovingSample rtwLoadMovingSample(ivec2 pixel)
{
  vec4 s = texelFetch(rtwSamples, pixel, 0);
  vec2 step = 2.0 / vec2(textureSize(rtwSamples, 0));
  vec2 ray = step * rtwRay.xy;
  float divisor = rtwDivisor(s.x);
  MovingSample m;
  m.here = rtwViewPosition((vec2(pixel) + 0.5) * step - 1.0, s.x);
  m.right = (vec3(ray.x + rtwShear.x * s.y, rtwShear.y * s.y, rtwOfSample.y * s.y) - m.here * (rtwOfSample.w * s.y)) / divisor;
  m.above = (vec3(rtwShear.x * s.z, ray.y + rtwShear.y * s.z, rtwOfSample.y * s.z) - m.here * (rtwOfSample.w * s.z)) / divisor;
  m.h = rtwViewToLight * vec4(m.here, 1.0);
  m.moves = mat2(rtwMovesOnLight(m.h, m.right), rtwMovesOnLight(m.h, m.above));
  m.seen = s.w > 0.0;
  // A surface that faces both viewer and light is seen the other way round from the light plane's back, as in the
  // lookup.
  m.lit = m.seen && m.h.w > 0.0 && determinant(m.moves) < 0.0 && rtwReached(m.h.xy / m.h.w);
  return m;
}
