// A triangle as the light sees it, and which squares of the grid hold samples that it may shadow.
struct ExactCaster
{
  vec4 a; // light-plane coordinates and depth; w: the slope of depth
  vec4 b;
  vec4 c; // w: the nearest depth
};

layout(std430, binding = 5) buffer ExactCasters
{
  ExactCaster rtwExactCasters[];
};

const float EDGE_ROUNDING = 1e-6; // a share of the coordinates
const float STEEP = 1e24;         // a slope that tells nothing
const uint FEW_SAMPLES = 12u;     // squares with no more samples are tested rather than divided

bool rtwIsOutside(vec2 a, vec2 b, float turn, vec2 middle, vec2 reach)
{
  vec2 along = b - a;
  vec2 away = middle - a;
  float side = turn * (along.x * away.y - along.y * away.x);
  vec2 size = abs(along.yx);
  return side < -dot(size, reach) - EDGE_ROUNDING * dot(size, abs(away) + reach);
}

// Whether a triangle may be in front of any sample of a square.
bool rtwMeets(ExactCaster t, GridNode node)
{
  vec2 low = min(min(t.a.xy, t.b.xy), t.c.xy);
  vec2 high = max(max(t.a.xy, t.b.xy), t.c.xy);
  if (any(lessThan(node.high, low)) || any(greaterThan(node.low, high)) || t.c.w >= node.deepest)
  {
    return false;
  }
  vec2 middle = 0.5 * (node.low + node.high);
  vec2 reach = 0.5 * (node.high - node.low);
  vec2 slope = vec2(t.a.w, t.b.w);
  vec2 away = middle - t.a.xy;
  float nearest = t.a.z + dot(slope, away) - dot(abs(slope), reach + 1e-5 * (abs(away) + reach));
  vec2 ab = t.b.xy - t.a.xy;
  vec2 ac = t.c.xy - t.a.xy;
  float turn = sign(ab.x * ac.y - ab.y * ac.x);
  return (t.a.w >= STEEP || nearest < node.deepest) && !rtwIsOutside(t.a.xy, t.b.xy, turn, middle, reach) &&
    !rtwIsOutside(t.b.xy, t.c.xy, turn, middle, reach) && !rtwIsOutside(t.c.xy, t.a.xy, turn, middle, reach);
}

// Queues a square that a triangle meets: to be divided in that step, or to be tested.
void rtwPushNode(uint step, uint caster, uint node, uint level)
{
  uint first = rtwNodes[node].first;
  uint count = rtwNodes[node].count;
  if (count > FEW_SAMPLES && level > 0u)
  {
    rtwPush(step, caster, level << LEVEL_SHIFT | node);
    return;
  }
  for (uint k = 0u; k < count; k += CHUNK)
  {
    rtwPush(TEST, caster, first + k | (min(count - k, CHUNK) - 1u) << (32u - CHUNK_BITS));
  }
}
