// A bent triangle as pieces whose edges on the map are no longer than they may be (Rosen 2012, section 6.2), in patches: what a draw call
// with a fixed number of vertices a patch can make of it. Each class of patches has twice as many pieces along an edge and a draw call of
// its own: most triangles of a fine mesh are a single piece.
uniform float rtwEdgeLength; // a share of the map's side

const int MOST_PIECES = 256; // along an edge
const uint FEW_PATCHES = MOST_TRIANGLES; // patches that there is always room for

int rtwPieces(vec2 a, vec2 b)
{
  return clamp(int(ceil(distance(a, b) / rtwEdgeLength)), 1, MOST_PIECES);
}

void rtwAddPatch(uint caster, vec2 a, vec2 b, vec2 c, int side)
{
  uint kind = side > 1 ? uint(findMSB(2 * side - 1)) : 0u;
  uint cluster = gl_WorkGroupID.x;
  uint i = atomicAdd(rtwWork[cluster].patchDraw[4u * kind], rtwPatchVertices(kind)) / rtwPatchVertices(kind);
  i += rtwPatchPlace(kind) + rtwPatchesOf(kind) * cluster;
  rtwCovers[i].corners[0] = a;
  rtwCovers[i].corners[1] = b;
  rtwCovers[i].corners[2] = c;
  rtwCovers[i].caster = caster;
  rtwCovers[i].depth = float(side);
}

void rtwKeepPlane(Caster t, vec2 slope, uint caster, vec2 pieces)
{
  for (int k = 0; k < 3; ++k)
  {
    rtwBent[caster].edges[k] = t.points[k];
  }
  rtwBent[caster].anchor = vec4(slope, pieces);
}

vec2 rtwPointAt(Caster t, vec2 share)
{
  vec4 p = t.points[0] + share.x * (t.points[1] - t.points[0]) + share.y * (t.points[2] - t.points[0]);
  return p.xy / p.w;
}

// Adds a patch of the triangle, which has `pieces` along an edge, unless it lies beside the map.
void rtwAddPatchOnMap(Caster t, uint caster, int pieces, vec2 a, vec2 b, vec2 c, int side)
{
  vec2 p = rtwPointAt(t, a / float(pieces));
  vec2 q = rtwPointAt(t, b / float(pieces));
  vec2 r = rtwPointAt(t, c / float(pieces));
  if (all(lessThanEqual(min(p, min(q, r)), vec2(1.0))) && all(greaterThanEqual(max(p, max(q, r)), vec2(0.0))))
  {
    rtwAddPatch(caster, a, b, c, side);
  }
}

void rtwAddPatches(Caster t, uint caster, int rows, int side)
{
  float s = float(side);
  for (int y = 0; y < rows; ++y)
  {
    for (int x = 0; x < rows - y; ++x)
    {
      vec2 at = s * vec2(float(x), float(y));
      vec2 right = at + vec2(s, 0.0);
      vec2 above = at + vec2(0.0, s);
      rtwAddPatchOnMap(t, caster, rows * side, at, right, above, side);
      if (x + y + 1 < rows)
      {
        rtwAddPatchOnMap(t, caster, rows * side, at + s, above, right, side);
      }
    }
  }
}

// u: its corners on the map.
void rtwTessellate(Caster t, vec2 slope, uint caster, vec2 u[3])
{
  ivec3 edges = ivec3(rtwPieces(u[0], u[1]), rtwPieces(u[1], u[2]), rtwPieces(u[2], u[0]));
  int pieces = max(edges.x, max(edges.y, edges.z));
  if (pieces == 1)
  {
    rtwKeepPlane(t, slope, caster, vec2(0.0));
    rtwAddPatch(caster, u[0], u[1], u[2], 1);
    return;
  }
  int rows = (pieces + PATCH_SIDE - 1) / PATCH_SIDE;
  uint patches = uint(rows * rows);
  if (rows > 1 && atomicAdd(rtwWork[gl_WorkGroupID.x].patches, patches) + patches > MOST_COVERS - FEW_PATCHES)
  {
    rows = 1;
    pieces = PATCH_SIDE;
  }
  int side = (pieces + rows - 1) / rows;
  edges = min(edges, ivec3(rows * side));
  rtwKeepPlane(t, slope, caster, vec2(PIECES * float(rows * side) + float(edges.x), PIECES * float(edges.y) + float(edges.z)));
  rtwAddPatches(t, caster, rows, side);
}
