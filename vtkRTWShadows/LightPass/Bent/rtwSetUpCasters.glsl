// The triangles of a cluster that hide anything, made ready to be drawn: straight where the warp doesn't bend them measurably, and
// otherwise covered, so that each fragment decides in unwarped light space, or tessellated.
//
// Edges and plane are homogeneous (Olano and Greer 1997), so that a triangle that reaches behind a spot needs no clipping but for its
// bounds.
layout(local_size_x = SET_UP_GROUP) in;
layout(std430, binding = 4) writeonly buffer StraightCasters
{
  StraightCaster rtwStraight[];
};
uniform float rtwAllowedBend; // a share of the map's side
uniform int rtwTessellating;  // whether what is bent more is tessellated instead of covered

// The error of depth that the bends inside a triangle may amount to where its depth is interpolated, without being seen
// as acne.
const float ALLOWED_ERROR = 5e-7;

// The plane relative to the corner that is farthest from the light: differences of large numbers would leave nothing of
// a small triangle.
bool rtwSetPlane(Caster t, out CasterPlane p)
{
  int a = t.points[1].w > t.points[0].w ? 1 : 0;
  a = t.points[2].w > t.points[a].w ? 2 : a;
  vec4 far = t.points[a];
  p.anchor = far.xyz / far.w;
  vec4 h[3]; // homogeneous, the anchor at the origin
  for (int i = 0; i < 3; ++i)
  {
    vec4 at = t.points[i];
    h[i] = i == a ? vec4(0.0, 0.0, 0.0, at.w) : vec4(at.xyz - p.anchor * at.w, at.w);
  }
  vec4 b = h[(a + 1) % 3];
  vec4 c = h[(a + 2) % 3];
  float area = b.x * c.y - b.y * c.x;
  p.slope = vec2(b.z * c.y - b.y * c.z, b.x * c.z - b.z * c.x) / area;
  for (int i = 0; i < 3; ++i)
  {
    vec3 e = cross(h[(i + 1) % 3].xyw, h[(i + 2) % 3].xyw);
    p.edges[i] = e * (area < 0.0 ? -1.0 : 1.0) / max(length(e.xy), 1e-30);
  }
  return abs(p.slope.x) + abs(p.slope.y) < 1e30; // false where the light sees it edge on
}

void rtwDrawStraight(Caster t, vec2 slope, vec2 u[3])
{
  uint cluster = gl_WorkGroupID.x;
  uint i = MOST_TRIANGLES * cluster + atomicAdd(rtwWork[cluster].straightDraw[0], 3u) / 3u;
  for (int k = 0; k < 3; ++k)
  {
    rtwStraight[i].onMap[k] = u[k];
    rtwStraight[i].depth[k] = t.points[k].z / t.points[k].w;
  }
  rtwStraight[i].slope = slope;
}

void rtwDrawPlane(Caster t, CasterPlane p, vec2 u[3])
{
  uint cluster = gl_WorkGroupID.x;
  uint i = MOST_TRIANGLES * (cluster + 1u) - 1u - atomicAdd(rtwWork[cluster].planeDraw[0], 3u) / 3u;
  for (int k = 0; k < 3; ++k)
  {
    rtwStraight[i].onMap[k] = u[k];
    rtwStraight[i].depth[k] = p.anchor[k];
  }
  rtwStraight[i].slope = p.slope;
  rtwStraight[i].depthRange = t.depths;
}

void rtwDrawBent(Caster t, CasterPlane p, uint place, uint caster, vec2 u[3], vec2 bend)
{
  rtwBent[caster].edges[0] = vec4(p.edges[0], p.slope.x);
  rtwBent[caster].edges[1] = vec4(p.edges[1], p.slope.y);
  rtwBent[caster].edges[2] = vec4(p.edges[2], t.depths.x);
  rtwBent[caster].anchor = vec4(p.anchor, t.depths.y);
  rtwCover(t, place, caster, u, bend);
}

// Whether any texel's centre can lie in a triangle with these corners on the map, whose edges stray from straight lines by no more than
// that. Of a fine mesh most bounds hold few centres, and half of them lie beside the triangle.
bool rtwHidesACentre(vec2 u[3], vec2 bend)
{
  vec2 texel = 1.0 / vec2(rtwMapSize);
  vec2 stray = bend + MARGIN * texel;
  ivec4 texels = rtwTexels(vec4(min(u[0], min(u[1], u[2])) - stray, max(u[0], max(u[1], u[2])) + stray));
  bool few = all(lessThan(texels.zw - texels.xy, ivec2(2)));
  float turn = (u[1].x - u[0].x) * (u[2].y - u[0].y) - (u[1].y - u[0].y) * (u[2].x - u[0].x) < 0.0 ? -1.0 : 1.0;
  bvec4 beside = bvec4(false);
  vec2 first = (vec2(texels.xy) + 0.5) * texel;
  vec2 last = (vec2(texels.zw) + 0.5) * texel;
  for (int i = 0; i < 3; ++i)
  {
    vec2 along = u[(i + 1) % 3] - u[i];
    vec2 away = turn * vec2(along.y, -along.x);
    float far = dot(away, u[i]) + dot(abs(away), stray);
    vec4 at = vec4(away.x * first.x, away.x * last.x, away.x * first.x, away.x * last.x) +
      away.y * vec4(first.y, first.y, last.y, last.y);
    beside = bvec4(uvec4(beside) | uvec4(greaterThan(at, vec4(far))));
  }
  return !few || !all(beside);
}

// Sets up the triangle at a place in the list.
void rtwSetUp(uint place)
{
  uint triangle = rtwWork[gl_WorkGroupID.x].casters[place];
  Caster t;
  CasterPlane p;
  if (!rtwLoadCaster(triangle, t) || !rtwSetPlane(t, p))
  {
    return;
  }
  vec2 u[3];
  for (int k = 0; k < 3; ++k)
  {
    u[k] = rtwWarp(rtwLayer, t.points[k].xy / t.points[k].w);
  }
  vec2 bend = rtwBends(rtwLayer, t.low, t.high);
  if (!t.crosses && !rtwHidesACentre(u, bend))
  {
    return;
  }
  vec2 shift = rtwShifts(rtwLayer, t.low, t.high);
  bool unbent = 3u * triangle >= rtwWork[gl_WorkGroupID.x].bentEnd;
  bool straight = !t.crosses && (unbent || max(bend.x, bend.y) <= rtwAllowedBend);
  uint caster = MOST_TRIANGLES * gl_WorkGroupID.x + triangle;
  if (straight && (unbent || dot(abs(p.slope), shift) <= ALLOWED_ERROR))
  {
    rtwDrawStraight(t, p.slope, u);
  }
  else if (straight)
  {
    rtwDrawPlane(t, p, u);
  }
  else if (rtwTessellating != 0 && !t.crosses)
  {
    rtwTessellate(t, p.slope, caster, u);
  }
  else
  {
    rtwDrawBent(t, p, place, caster, u, bend);
  }
}

void main()
{
  for (uint i = gl_LocalInvocationID.x; i < rtwWork[gl_WorkGroupID.x].numberOfCasters; i += gl_WorkGroupSize.x)
  {
    rtwSetUp(i);
  }
}
