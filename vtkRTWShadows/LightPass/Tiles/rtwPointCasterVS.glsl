// A cover of a triangle that the warp bends: a square of texels, drawn as a point.
layout(binding = 10) uniform samplerBuffer rtwCovers; // the buffer of CasterCover, as vec4
uniform ivec2 rtwWarpSize;
flat out vec3 edges[3];
flat out vec3 anchor;
flat out vec2 slope;
flat out vec2 depthRange;

void main()
{
  int i = 2 * (int(MOST_COVERS * MOST_CLUSTERS) - 1 - gl_VertexID);
  vec4 square = texelFetch(rtwCovers, i); // corner, size
  vec4 rest = texelFetch(rtwCovers, i + 1);
  uint caster = uint(rest.z);
  vec4 e0 = rtwBentEntry(caster, 0);
  vec4 e1 = rtwBentEntry(caster, 1);
  vec4 e2 = rtwBentEntry(caster, 2);
  vec4 corner = rtwBentEntry(caster, 3);
  edges = vec3[3](e0.xyz, e1.xyz, e2.xyz);
  anchor = corner.xyz;
  slope = vec2(e0.w, e1.w);
  depthRange = vec2(e2.w, corner.w);
  float side = max(square.z, square.w);
  // The point is moved until all of it is on the map, because a point whose middle is beside that isn't drawn.
  float extent = 0.5 * side / float(rtwWarpSize.y);
  vec2 middle = min(square.xy + extent, 1.0 - extent);
  gl_PointSize = side;
  gl_Position = vec4(2.0 * middle - 1.0, 2.0 * rest.w - 1.0, 1.0);
}
