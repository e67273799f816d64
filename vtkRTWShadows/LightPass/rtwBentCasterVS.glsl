// A cover of a triangle that the warp bends: two triangles, set up before.
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

void main()
{
  int i = gl_VertexID / 6;
  int k = gl_VertexID - 6 * i;
  uint caster = rtwCovers[i].caster >> 1;
  bool second = k > 2 && (rtwCovers[i].caster & 1u) != 0u; // triangle; otherwise it has no area
  for (int e = 0; e < 3; ++e)
  {
    edges[e] = rtwBent[caster].edges[e].xyz;
  }
  anchor = rtwBent[caster].anchor.xyz;
  slope = vec2(rtwBent[caster].edges[0].w, rtwBent[caster].edges[1].w);
  depthRange = vec2(rtwBent[caster].edges[2].w, rtwBent[caster].anchor.w);
  vec2 a = rtwCovers[i].corners[0];
  vec2 b = rtwCovers[i].corners[1];
  vec2 c = rtwCovers[i].corners[2];
  vec2 onMap = k == 0 ? a : k == 1 ? b : k == 2 ? c : !second ? a : k == 3 ? c : k == 4 ? b : b + c - a;
  gl_Position = vec4(2.0 * onMap - 1.0, 2.0 * rtwCovers[i].depth - 1.0, 1.0);
}
