// What a pixel shows, as a point of a light's map: where it lies, and how far that moves from pixel to pixel. By derivatives, because
// perspective and a spot bend differences to the next pixel.
uniform int rtwFirstLayer; // of the light
uniform int rtwParts;      // its layers
uniform vec4 rtwBeam;

struct MapSample
{
  bool seen;     // there is a receiver
  bool lit;      // that faces the light and lies in its reach
  int layer;     // that it is looked up in
  float facing;  // the surface and the viewer: 1 head on, 0 edge on
  vec2 q;        // on the focus
  mat2 moves;    // what q moves by to the pixel on the right, and to the one above
};

// The same of a point that moves by that in view coordinates; h is where it is projected.
vec2 rtwMovesOnLight(vec4 h, vec3 step)
{
  vec4 change = rtwViewToLight * vec4(step, 0.0);
  return (change.xy - h.xy / h.w * change.w) / h.w;
}

MapSample rtwLoadMapSample(ivec2 pixel)
{
  vec4 s = texelFetch(rtwSamples, pixel, 0);
  vec2 step = 2.0 / vec2(textureSize(rtwSamples, 0));
  bool parallel = rtwParallelView.x != 0.0;
  vec3 here = rtwViewPosition((vec2(pixel) + 0.5) * step - 1.0, s.x);
  vec2 ray = step * rtwRay.xy;
  vec2 away = s.yz * rtwParallelView.x;
  vec3 right = parallel ? vec3(ray.x, 0.0, -away.x) : (vec3(ray.x, 0.0, 0.0) - here * s.y) / s.x;
  vec3 above = parallel ? vec3(0.0, ray.y, -away.y) : (vec3(0.0, ray.y, 0.0) - here * s.z) / s.x;
  vec3 normal = normalize(cross(right, above));
  vec4 h = rtwViewToLight * vec4(here, 1.0);
  mat2 moves = mat2(rtwMovesOnLight(h, right), rtwMovesOnLight(h, above));
  MapSample m;
  m.layer = rtwLayerAt(rtwFirstLayer, rtwParts, here, rtwBeam);
  vec4 focus = rtwFocus(m.layer);
  m.seen = s.w > 0.0;
  // As in the lookup: seen the other way round from the light plane's back.
  m.lit = m.seen && h.w > 0.0 && determinant(moves) < 0.0 && rtwReached(h.xy / h.w);
  m.facing = abs(dot(normal, parallel ? vec3(0.0, 0.0, 1.0) : normalize(here)));
  m.q = rtwFocused(focus, h.xy / h.w);
  m.moves = mat2(moves[0] * focus.yw, moves[1] * focus.yw);
  return m;
}
