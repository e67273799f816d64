// What the tiles of a bent triangle are found from: rtwFirstTiles.glsl goes on.
void rtwCover(Caster t, uint place, uint caster, vec2 u[3], vec2 bend)
{
  ivec4 texels = rtwTexels(rtwBoundsOnMap(rtwLayer, t.low, t.high));
  if (any(greaterThan(texels.xy, texels.zw)))
  {
    return;
  }
  vec2 corners[3];
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = t.points[k].xy / t.points[k].w;
  }
  rtwBent[caster].bounds = vec4(t.low, t.high);
  rtwBent[caster].corners[0] = vec4(corners[0], corners[1]);
  rtwBent[caster].corners[1] = vec4(corners[2], t.crosses ? 1.0 : 0.0, 0.0);
  rtwBent[caster].texels = texels;
  rtwWork[gl_WorkGroupID.x].casters[place] += IS_COVERED;
}
