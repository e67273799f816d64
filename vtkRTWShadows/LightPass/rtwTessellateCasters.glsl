// A bent triangle as pieces whose edges on the map are no longer than they may be (Rosen 2012, section 6.2), in patches: what a draw call
// with a fixed number of vertices a patch can make of it. What is a single piece, as most of a fine mesh, has a draw call of its own, and
// its place at the end of the covers, which never fill theirs up where there are such triangles.
uniform float rtwEdgeLength; // of the map's side

const int MOST_PIECES = 256; // along an edge
const uint FEW_PATCHES = MOST_TRIANGLES; // that there is always room for

int rtwPieces(vec2 a, vec2 b)
{
  return clamp(int(ceil(distance(a, b) / rtwEdgeLength)), 1, MOST_PIECES);
}

void rtwAddPatch(uint i, uint caster, vec2 a, vec2 b, vec2 c, int side)
{
  rtwCovers[i].corners[0] = a;
  rtwCovers[i].corners[1] = b;
  rtwCovers[i].corners[2] = c;
  rtwCovers[i].caster = caster;
  rtwCovers[i].depth = float(side);
}

void rtwAddPieces(uint caster, vec2 a, vec2 b, vec2 c, int side)
{
  uint i = atomicAdd(rtwWork[gl_WorkGroupID.x].patchDraw[0], PATCH_VERTICES) / PATCH_VERTICES;
  i += MOST_COVERS * (gl_WorkGroupID.x + MOST_CLUSTERS); // behind the covers
  rtwAddPatch(i, caster, float(side) * a, float(side) * b, float(side) * c, side);
}

void rtwKeepPlane(Caster t, vec2 slope, uint caster, vec2 pieces)
{
  for (int k = 0; k < 3; ++k)
  {
    rtwBent[caster].edges[k] = t.points[k];
  }
  rtwBent[caster].anchor = vec4(slope, pieces);
}

// u: its corners on the map.
void rtwDrawWhole(Caster t, vec2 slope, uint caster, vec2 u[3])
{
  uint i = rtwPlaceOfWhole(atomicAdd(rtwWork[gl_WorkGroupID.x].wholeDraw[0], 3u) / 3u);
  rtwKeepPlane(t, slope, caster, vec2(0.0));
  rtwAddPatch(MOST_COVERS * gl_WorkGroupID.x + i, caster, u[0], u[1], u[2], 1);
}

void rtwTessellate(Caster t, vec2 slope, uint caster, vec2 u[3])
{
  ivec3 edges = ivec3(rtwPieces(u[0], u[1]), rtwPieces(u[1], u[2]), rtwPieces(u[2], u[0]));
  int pieces = max(edges.x, max(edges.y, edges.z));
  if (pieces == 1)
  {
    rtwDrawWhole(t, slope, caster, u);
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
  for (int y = 0; y < rows; ++y)
  {
    for (int x = 0; x < rows - y; ++x)
    {
      vec2 at = vec2(float(x), float(y));
      rtwAddPieces(caster, at, at + vec2(1.0, 0.0), at + vec2(0.0, 1.0), side);
      if (x + y + 1 < rows)
      {
        rtwAddPieces(caster, at + vec2(1.0), at + vec2(0.0, 1.0), at + vec2(1.0, 0.0), side);
      }
    }
  }
}
