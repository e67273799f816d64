// What a sample asks for: the product of the chosen functions (Rosen 2012, section 5), and how a column and a row collect it.
//
// Published: the largest in a column counts (section 4.2). √demand: the sum of one over the footprint, because a shadow edge that
// is a texel off costs a pixel that share; its square root is taken where the warping map is built.
layout(local_size_x = 16, local_size_y = 16) in;
const int DISTANCE_TO_EYE = 2;
const int SURFACE_NORMAL = 4;
const int SQRT_DEMAND = 8;
const int SHADOW_EDGE = 16;
const int CENTRE_OF_INTEREST = 32;
const int USER_FUNCTION = 64;
const int FOOTPRINT = 128;
const int SAMPLE_COUNT = 256;
const float ALPHA = 0.001;         // share of its importance that a sample keeps away from shadow edges (section 5.3)
const float GRAZING = 1e-3;        // least area of a footprint, as a share of the square over its longer side
const float LARGEST = 1048575.0;   // the most that a sample asks for: 4096 samples of a tile don't overflow a sum

layout(std430, binding = 0) buffer Profile
{
  uint rtwProfile[]; // for each axis of a layer, profile and cell: low and high part of a sum, or the bits of a maximum
};
uniform int rtwLayer;
uniform float rtwNearest; // distance that has the importance 1
uniform float rtwBeta;    // bonus of a surface that is seen head on, β of section 5.4
uniform mat4 rtwViewToClip;
uniform vec2 rtwAspect;      // from clip coordinates to halves of the picture's smaller side
uniform vec4 rtwInterest;    // centre in view coordinates, and radius there or on the screen
uniform int rtwInterestSide; // 1: the screen's centre
uniform float rtwInterestBonus;
uniform vec4 rtwTowardsLight; // in view coordinates: where the light stands, or its direction and 0

bool rtwIsOn(int function)
{
  return (FUNCTIONS & function) != 0;
}

bool rtwIsSum()
{
  return rtwIsOn(SQRT_DEMAND | SAMPLE_COUNT);
}

// The share of the bonus at a position: 1 in the sphere, 0 from twice its radius on.
float rtwInterestAt(vec3 position)
{
  vec4 clip = rtwViewToClip * vec4(position, 1.0);
  float away = rtwInterestSide != 0 ? length(clip.xy / clip.w * rtwAspect) : distance(position, rtwInterest.xyz);
  return 1.0 + rtwInterestBonus * (1.0 - smoothstep(1.0, 2.0, away / rtwInterest.w));
}

// What the light alone, unshadowed, gives a white matte surface: the cosine of its angle, 0 to 1.
float rtwLuminance(LitSample s)
{
  return clamp(dot(s.normal, normalize(rtwTowardsLight.xyz - rtwTowardsLight.w * s.position)), 0.0, 1.0);
}

float rtwUserValue(LitSample s, vec4 focus)
{
  vec3 fromCamera = s.position - vec3(0.0, 0.0, rtwViewBegin);
  float value = rtwUserFunction(fromCamera, s.normal, -fromCamera.z, rtwLuminance(s), s.footprint * focus.yw);
  return value > 0.0 ? min(value, LARGEST) : 0.0; // 0 also where it is not a number
}

float rtwFunction(LitSample s, vec4 focus, bool edge)
{
  float value = 1.0;
  if (rtwIsOn(DISTANCE_TO_EYE) && rtwViewer.w != 0.0)
  {
    value *= rtwNearest / max(rtwDistance(s.position), 1e-30);
  }
  if (rtwIsOn(SURFACE_NORMAL))
  {
    value *= 1.0 + rtwBeta * clamp(s.normal.z, 0.0, 1.0);
  }
  if (rtwIsOn(CENTRE_OF_INTEREST))
  {
    value *= rtwInterestAt(s.position);
  }
  if (rtwIsOn(FOOTPRINT))
  {
    vec2 footprint = s.footprint * focus.yw;
    float longer = max(footprint.x, footprint.y);
    // A surface that the light grazes would ask for all there is.
    value *= inversesqrt(max(max(s.area * focus.y * focus.w, GRAZING * longer * longer), 1e-30));
  }
  if (rtwIsOn(USER_FUNCTION))
  {
    value *= rtwUserValue(s, focus);
  }
  return edge || rtwIsOn(SQRT_DEMAND) ? value : ALPHA * value; // demand at edges has a profile of its own
}

// What a sample asks for along both axes; if it is to be summed, in the unit of sums.
vec2 rtwAsked(LitSample s, vec4 focus, bool edge)
{
  float value = rtwFunction(s, focus, edge);
  if (rtwIsOn(SQRT_DEMAND))
  {
    return value / max(s.footprint * focus.yw, 1e-30);
  }
  return vec2(value) * (rtwIsSum() ? COUNT_UNIT : 1.0);
}

ivec2 rtwCell(vec2 focused)
{
  return clamp(ivec2(focused * float(rtwWarpSize.x)), 0, rtwWarpSize.x - 1);
}

uint rtwPlace(int profile, int axis, int cell)
{
  return 2u * uint(((2 * rtwLayer + axis) * PROFILES + profile) * rtwWarpSize.x + cell);
}

void rtwAddToProfile(uint at, uint low, uint high)
{
  uint carry = low != 0u && atomicAdd(rtwProfile[at], low) > 0xffffffffu - low ? 1u : 0u;
  if (high + carry != 0u)
  {
    atomicAdd(rtwProfile[at + 1u], high + carry);
  }
}
