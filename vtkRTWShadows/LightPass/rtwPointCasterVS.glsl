// A cover of a triangle that the warp bends: a square of texels, drawn as a point.
uniform ivec2 rtwWarpSize;

void main()
{
  uint i = MOST_COVERS * MOST_CLUSTERS - 1u - uint(gl_VertexID);
  rtwPassOn(rtwCovers[i].caster >> 1);
  vec2 size = rtwCovers[i].corners[1];
  float side = max(size.x, size.y);
  // All of it on the map: a point whose middle is beside that isn't drawn.
  float extent = 0.5 * side / float(rtwWarpSize.y);
  vec2 middle = min(rtwCovers[i].corners[0] + extent, 1.0 - extent);
  gl_PointSize = side;
  gl_Position = vec4(2.0 * middle - 1.0, 2.0 * rtwCovers[i].depth - 1.0, 1.0);
}
