// What the fragments of a bent triangle's cover need to know of it.
layout(std430, binding = 5) readonly buffer BentCasters
{
  BentCaster rtwBent[];
};
layout(std430, binding = 6) readonly buffer Covers
{
  CasterCover rtwCovers[];
};
flat out vec3 edges[3];
flat out vec3 anchor;
flat out vec2 slope;
flat out vec2 depthRange;

void rtwPassOn(uint caster)
{
  for (int e = 0; e < 3; ++e)
  {
    edges[e] = rtwBent[caster].edges[e].xyz;
  }
  anchor = rtwBent[caster].anchor.xyz;
  slope = vec2(rtwBent[caster].edges[0].w, rtwBent[caster].edges[1].w);
  depthRange = vec2(rtwBent[caster].edges[2].w, rtwBent[caster].anchor.w);
}
