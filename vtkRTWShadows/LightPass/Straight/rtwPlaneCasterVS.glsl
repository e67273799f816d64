// A triangle with straight edges on the map whose depths the warp bends there: its fragments take them from its plane. These lie behind
// the straight ones of their cluster, from the end on.
layout(std430, binding = 4) readonly buffer StraightCasters
{
  StraightCaster rtwStraight[];
};
flat out vec3 anchor;
flat out vec2 slope;
flat out vec2 depthRange;

void main()
{
  uint triangle = uint(gl_VertexID) / 3u;
  uint k = uint(gl_VertexID) - 3u * triangle;
  uint cluster = triangle / MOST_TRIANGLES;
  uint i = MOST_TRIANGLES * (2u * cluster + 1u) - 1u - triangle;
  anchor = vec3(rtwStraight[i].depth[0], rtwStraight[i].depth[1], rtwStraight[i].depth[2]);
  slope = rtwStraight[i].slope;
  depthRange = rtwStraight[i].depthRange;
  gl_Position = vec4(2.0 * rtwStraight[i].onMap[k] - 1.0, 2.0 * depthRange.x - 1.0, 1.0);
}
