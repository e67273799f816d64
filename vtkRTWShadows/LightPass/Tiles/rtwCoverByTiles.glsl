// Writes down what the tiles of a bent triangle are found from, which rtwFirstTiles.glsl goes on with.
void rtwCover(Caster t, uint place, uint caster, vec2 u[3], vec2 bend)
{
  ivec4 texels = rtwTexelsOf(t);
  if (any(greaterThan(texels.xy, texels.zw)))
  {
    return;
  }
  vec2 corners[3] = vec2[3](t.low, vec2(t.high.x, t.low.y), vec2(t.low.x, t.high.y));
  for (int k = 0; k < 3 && !t.crosses; ++k)
  {
    corners[k] = t.points[k].xy / t.points[k].w;
  }
  rtwBent[caster].corners[0] = vec4(corners[0], corners[1]);
  rtwBent[caster].corners[1] = vec4(corners[2], t.crosses ? 1.0 : 0.0, 0.0);
  rtwBent[caster].texels = vec4(texels);
  rtwWork[gl_WorkGroupID.x].casters[place] += IS_COVERED;
}
