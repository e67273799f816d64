// What a pixel shows, as a point of a light's map: where it lies, and how far that moves from pixel to pixel.
uniform int rtwFirstLayer; // the light's first layer
uniform int rtwParts;      // layers of the light
uniform vec4 rtwBeam;

struct MapSample
{
  bool seen;     // there is a receiver
  bool lit; // the receiver faces the light and lies in its reach
  int layer;     // the layer that it is looked up in
  float facing;  // the surface and the viewer: 1 head on, 0 edge on
  vec2 q;        // its focus coordinates
  mat2 moves;    // what q moves by to the pixel on the right, and to the one above
};

MapSample rtwLoadMapSample(ivec2 pixel)
{
  MovingSample s = rtwLoadMovingSample(pixel);
  vec3 normal = normalize(cross(s.right, s.above));
  MapSample m;
  m.seen = s.seen;
  m.lit = s.lit;
  m.layer = rtwLayerAt(rtwFirstLayer, rtwParts, s.here, rtwBeam);
  vec4 focus = rtwFocus(m.layer);
  m.facing = abs(dot(normal, normalize(rtwToViewer(s.here))));
  m.q = rtwFocused(focus, s.h.xy / s.h.w);
  m.moves = mat2(s.moves[0] * focus.yw, s.moves[1] * focus.yw);
  return m;
}
