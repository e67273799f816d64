// Bent triangles, as textures have them: in software a shader fetches texels for less than it reads storage.
layout(binding = 9) uniform samplerBuffer rtwBentTable;

// The i-th vec4 of the BentCaster of a triangle.
vec4 rtwBentEntry(uint caster, int i)
{
  return texelFetch(rtwBentTable, 8 * int(caster) + i);
}
