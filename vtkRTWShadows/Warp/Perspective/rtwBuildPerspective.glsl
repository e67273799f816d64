// A layer's perspective warp, in two passes: first how strong it is, from the focus and the nearest sample; then, from what samples take so
// warped, where the map ends along s. rtwPerspectiveWarp.cxx has the same in double precision.
layout(local_size_x = 1) in;
layout(std430, binding = 0) readonly buffer Bounds
{
  uint rtwBounds[]; // as in rtwFocusBounds.glsl, but in map coordinates
};
layout(std430, binding = 1) readonly buffer Nearest
{
  float rtwNearestOf[];
};
layout(std430, binding = 2) buffer Table
{
  vec2 rtwTable[];
};
layout(std430, binding = 3) writeonly buffer Report
{
  vec4 rtwReport[]; // a layer: as rtwPerspective() gives it
};
uniform int rtwLayer;
uniform int rtwPass;
uniform int rtwChoice;  // how n' is given: 0 by η, 1 by itself, 2 by the point that lies on the focus line
uniform float rtwValue; // η, n' or the focus point
uniform vec3 rtwView;   // sine between view and light; world units a unit of the light plane there, 0 for no warp; s of the eye
uniform vec4 rtwAlso;   // bounds on the light plane of what the map has to hold besides samples: low, high
uniform vec2 rtwMargin; // for filters, as a share of the map along s and t
const float FOCUS_LINE = 0.8;    // of the map, up to where the focus point lies (Lloyd et al. 2006, section 4.1)
const float STRONGEST = 1e4;     // (f' - n') / n'
const float ROUNDING = 1e-4;     // of the map's side

// 1 / n' for a light overhead: from 1 / n, which is PSM, down to 0, which is no warp.
float rtwInverseOfNear(float n, float f)
{
  float root = sqrt(f / n);
  float inverse = 0.0;
  if (rtwChoice == 0)
  {
    // Equation 11.
    inverse = rtwValue > 0.0 ? (1.0 + rtwValue * root) / (n * (1.0 + root))
                             : (1.0 + rtwValue) / (n * (1.0 + root) * (1.0 - rtwValue * (root - 1.0)));
  }
  else if (rtwChoice == 1)
  {
    inverse = 1.0 / rtwValue;
  }
  else
  {
    // t = f' (z' - n') / (z' (f' - n')) = 0.8 where z' - n' is the focus point's distance from the near end.
    float extent = f - n;
    inverse = (FOCUS_LINE - rtwValue) / ((1.0 - FOCUS_LINE) * rtwValue * extent);
  }
  return clamp(inverse, 0.0, 1.0 / n);
}

// The strength (f' - n') / n'. n' grows with one over the sine between view and light (Wimmer et al. 2004), as does the
// distance from the viewer to a point on the light plane: where view and light are parallel, there is no warp.
float rtwStrength(float extent)
{
  float away = rtwNearestOf[rtwLayer];
  float sine = rtwView.x;
  if (!(rtwView.y > 0.0) || !(sine > 0.0) || !(away > 0.0))
  {
    return 0.0;
  }
  float n = 1.0 / away;
  float depth = extent * rtwView.y / sine; // f - n
  return clamp(sine * sine * depth * rtwInverseOfNear(n, n + depth), 0.0, STRONGEST);
}

int rtwPlaceOf(int axis, int entry)
{
  return rtwWarpPlace(4 * rtwLayer + axis, entry);
}

void rtwWriteStrength()
{
  vec2 s = rtwTable[rtwPlaceOf(0, rtwWarpSize.x)];
  vec2 t = rtwTable[rtwPlaceOf(1, rtwWarpSize.x)];
  float strength = rtwStrength(1.0 / t.y);
  // A filter's texels are wider at the far end than they are on the whole.
  float wider = 1.0 + rtwMargin.y * strength;
  rtwTable[rtwPlaceOf(1, rtwWarpSize.x)].y = t.y / wider;
  rtwTable[rtwPlaceOf(0, 0)] = vec2(0.0, 1.0);
  rtwTable[rtwPlaceOf(1, 0)] = vec2(strength * wider, (rtwView.z - s.x) * s.y);
}

float rtwUnordered(uint bits)
{
  return uintBitsToFloat((bits & 0x80000000u) != 0u ? bits & 0x7fffffffu : ~bits);
}

void rtwWriteEnds()
{
  vec2 s = rtwTable[rtwPlaceOf(0, rtwWarpSize.x)];
  vec2 t = rtwTable[rtwPlaceOf(1, rtwWarpSize.x)];
  vec2 k = rtwTable[rtwPlaceOf(1, 0)];
  int first = 8 * rtwLayer;
  uint low = min(rtwBounds[first], rtwBounds[first + 4]);
  uint high = max(rtwBounds[first + 2], rtwBounds[first + 6]);
  bool any = low != 0xffffffffu;
  vec2 ends = any ? vec2(rtwUnordered(low), rtwUnordered(high)) : vec2(1e30, -1e30);
  bool also = rtwAlso.x <= rtwAlso.z;
  // A layer without samples has no bounds that are known.
  vec4 box = any || also ? clamp((rtwAlso - vec4(s.x, t.x, s.x, t.x)) * vec4(s.y, t.y, s.y, t.y), 0.0, 1.0) : vec4(0.0, 0.0, 1.0, 1.0);
  for (int corner = 0; corner < 4 && (also || !any); ++corner)
  {
    vec2 q = vec2(corner % 2 == 0 ? box.x : box.z, corner / 2 == 0 ? box.y : box.w);
    float column = k.y + (q.x - k.y) / (1.0 + k.x * q.y);
    ends = vec2(min(ends.x, column), max(ends.y, column));
  }
  float margin = max((ROUNDING + rtwMargin.x) * (ends.y - ends.x), 1e-6);
  ends += vec2(-margin, margin);
  rtwTable[rtwPlaceOf(0, 0)] = ends;
  rtwReport[rtwLayer] = vec4(ends, k);
}

void main()
{
  if (rtwPass == 0)
  {
    rtwWriteStrength();
  }
  else
  {
    rtwWriteEnds();
  }
}
