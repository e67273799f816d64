// Non-orthogonal texture warping (Milet et al. 2015, equation 6): each row of the focus has a function along s, and each column of what that
// makes of it one along t. Unlike there, they change continuously from row to row and from column to column: linearly between the lines'
// middles. Each is monotone, linear in each cell, and no warp beyond its ends.
//
// The grid of a layer: of both axes, line by line, the function at each cell's two borders; then the focus coordinates of each texel's
// centre.
uniform samplerBuffer rtwWarpGrid;

int rtwGridPlace(int layer, int axis, int line, int cell)
{
  int cells = rtwWarpSize.x;
  return layer * (2 * cells * cells + rtwWarpSize.y * rtwWarpSize.y) + (axis * cells + line) * cells + cell;
}

int rtwCentrePlace(int layer, ivec2 texel)
{
  return rtwGridPlace(layer, 2, 0, 0) + texel.y * rtwWarpSize.y + texel.x;
}

// The line whose middle lies before `across`, and the share of the way from there to the next line's.
float rtwLineBefore(float across)
{
  float last = float(rtwWarpSize.x);
  return clamp(across * last - 0.5, 0.0, last - 1.0);
}

vec2 rtwGridEntry(int layer, int axis, float line, int cell)
{
  float first = min(floor(line), float(rtwWarpSize.x - 2));
  int place = rtwGridPlace(layer, axis, int(first), cell);
  return mix(texelFetch(rtwWarpGrid, place).xy, texelFetch(rtwWarpGrid, place + rtwWarpSize.x).xy, line - first);
}

float rtwWarpAlong(int layer, int axis, float along, float across)
{
  if (along <= 0.0 || along >= 1.0)
  {
    return along;
  }
  float f = along * float(rtwWarpSize.x);
  float cell = min(floor(f), float(rtwWarpSize.x - 1));
  vec2 ends = rtwGridEntry(layer, axis, rtwLineBefore(across), int(cell));
  return ends.x + (f - cell) * (ends.y - ends.x);
}

vec2 rtwWarp(int layer, vec2 q)
{
  if (layer >= rtwWarpedLayers)
  {
    return q;
  }
  float s = rtwWarpAlong(layer, 0, q.x, q.y);
  return vec2(s, rtwWarpAlong(layer, 1, q.y, s));
}

vec3 rtwWarpHomogeneous(int layer, vec2 q)
{
  return vec3(rtwWarp(layer, q), 1.0);
}

vec2 rtwTexelCentre(int layer, ivec2 texel)
{
  return layer < rtwWarpedLayers ? texelFetch(rtwWarpGrid, rtwCentrePlace(layer, texel)).xy
                                 : (vec2(texel) + 0.5) / float(rtwWarpSize.y);
}

TexelCentres rtwTexelCentres(int layer, ivec2 texel)
{
  ivec2 last = ivec2(rtwWarpSize.y - 1);
  ivec2 next = min(texel + 1, last);
  return TexelCentres(rtwTexelCentre(layer, texel), rtwTexelCentre(layer, ivec2(next.x, texel.y)),
    rtwTexelCentre(layer, ivec2(texel.x, next.y)), rtwTexelCentre(layer, next));
}
