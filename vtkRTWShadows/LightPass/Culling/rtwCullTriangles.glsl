// Which triangles of a cluster hide the centre of any texel. Few do where meshes are fine, and only those are set up.
layout(local_size_x = 64) in;

void main()
{
  uint cluster = gl_WorkGroupID.x;
  for (uint i = gl_LocalInvocationID.x; 3u * i < rtwWork[cluster].end; i += gl_WorkGroupSize.x)
  {
    Caster t;
    if (rtwLoadCaster(i, t))
    {
      ivec4 texels = rtwTexelsOf(t);
      if (all(greaterThanEqual(texels.zw, texels.xy)) && !rtwIsBehindAll(texels, t.depths.x))
      {
        rtwWork[cluster].casters[atomicAdd(rtwWork[cluster].numberOfCasters, 1u)] = i;
      }
    }
  }
}
