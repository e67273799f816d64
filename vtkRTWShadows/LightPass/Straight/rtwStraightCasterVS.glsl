// A triangle that the warp doesn't bend measurably: three vertices, set up before.
layout(std430, binding = 4) readonly buffer StraightCasters
{
  StraightCaster rtwStraight[];
};
flat out vec2 slope;

void main()
{
  int i = gl_VertexID / 3;
  int k = gl_VertexID - 3 * i;
  slope = rtwStraight[i].slope;
  gl_Position = vec4(2.0 * rtwStraight[i].onMap[k] - 1.0, 2.0 * rtwStraight[i].depth[k] - 1.0, 1.0);
}
