// A shadow's edges on the screen, as a mask has them, and how far they move when a map is a texel off.

// The decision of the mask at a pixel: 0 in shadow, 1 lit, 0.5 neither.
float rtwDecision(sampler2DArray mask, int light, ivec2 pixel)
{
  ivec2 inside = clamp(pixel, ivec2(0), textureSize(mask, 0).xy - 1);
  float value = 255.0 * texelFetch(mask, ivec3(inside, light), 0).r;
  return value < 127.5 ? 0.0 : value > 128.5 ? 1.0 : 0.5;
}

// Whether one of the four pixels around it is of the other decision.
bool rtwBesideEdge(sampler2DArray mask, int light, ivec2 pixel)
{
  float here = rtwDecision(mask, light, pixel);
  bool differs = false;
  for (int k = 0; k < 4; ++k)
  {
    ivec2 step = ivec2(k < 2 ? 2 * k - 1 : 0, k < 2 ? 0 : 2 * k - 5);
    differs = differs || abs(rtwDecision(mask, light, pixel + step) - here) == 1.0;
  }
  return differs;
}

// The direction across the edge that a pixel is beside: the mask's gradient, of length 1; 0 where the edge has no one
// direction.
vec2 rtwEdgeNormal(sampler2DArray mask, int light, ivec2 pixel)
{
  float here = rtwDecision(mask, light, pixel);
  vec2 gradient = vec2(0.0);
  for (int k = 0; k < 25; ++k)
  {
    ivec2 step = ivec2(k % 5, k / 5) - 2;
    float there = rtwDecision(mask, light, pixel + step);
    // A pixel that faces away from the light says nothing of the edge.
    gradient += vec2(step) * (there == 0.5 ? here : there) * exp(-0.5 * float(step.x * step.x + step.y * step.y));
  }
  float size = length(gradient);
  return size > 1e-4 ? gradient / size : vec2(0.0);
}

// The number of pixels by which an edge of that normal (or any, where it is 0) moves on the screen if what casts it is
// off by such a length along either axis of the light plane, in the mean of both. dx and dy lead there to the next
// pixels.
//
// A pixel's extent along an axis alone is too much where its ellipse lies slantwise and thin, as on a wall that the light grazes:
// an edge moves farther. How far along its normal is known by the inverse of the two steps, but no better than the normal is, and
// that is too much on such a wall. The geometric mean of both agrees best with exact rays.
float rtwMisplaced(vec2 dx, vec2 dy, vec2 normal, vec2 off)
{
  vec2 s = vec2(dy.y, -dx.y); // the step on the screen that leads one unit along s, times the determinant
  vec2 t = vec2(-dy.x, dx.x);
  bool known = normal != vec2(0.0);
  vec2 moved = known ? abs(vec2(dot(normal, s), dot(normal, t))) : vec2(length(s), length(t));
  float byInverse = dot(moved, off) / abs(dx.x * dy.y - dx.y * dy.x);
  float byExtent = off.x / length(vec2(dx.x, dy.x)) + off.y / length(vec2(dx.y, dy.y));
  return 0.5 * sqrt(byInverse * byExtent);
}
