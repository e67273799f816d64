// Adds to a layer's bounds the parts of boxes that lie in its depths, by the parts of their edges that do.
layout(local_size_x = 64) in;
layout(std430, binding = 1) readonly buffer Corners
{
  vec4 rtwCorners[]; // in view coordinates, eight a box, x fastest
};
uniform int rtwNumberOfEdges;

// One of a box's twelve edges: the corner that it begins at, and the bit that the corner at its other end differs in.
ivec2 rtwEdge(int k)
{
  int axis = k / 4;
  int low = (1 << axis) - 1;
  int rest = k % 4;
  return ivec2(rest & low | (rest & ~low) << 1, 1 << axis);
}

void rtwAdd(vec3 position)
{
  vec3 here = rtwOnLight(position);
  // Behind a spot: no light falls there, but the box may reach anywhere.
  rtwAddBounds(rtwLayer, here.z > 0.0 ? rtwKept(rtwAround(here.xy, vec2(rtwFilterWidth / here.z))) : rtwWholeBounds, 0);
}

void main()
{
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rtwNumberOfEdges)
  {
    return;
  }
  ivec2 edge = rtwEdge(i % 12);
  vec3 a = rtwCorners[8 * (i / 12) + edge.x].xyz;
  vec3 b = rtwCorners[8 * (i / 12) + edge.x + edge.y].xyz;
  vec2 interval = vec2(rtwBlendStart(rtwLayer), rtwIntervalOf(rtwLayer).y);
  // Where on the edge the interval begins and ends.
  vec2 ends = vec2(0.0, 1.0);
  float rise = a.z - b.z;
  if (rise != 0.0)
  {
    vec2 at = (interval + a.z) / rise;
    ends = vec2(max(ends.x, min(at.x, at.y)), min(ends.y, max(at.x, at.y)));
  }
  else if (-a.z < interval.x || -a.z > interval.y)
  {
    return;
  }
  if (ends.x <= ends.y)
  {
    rtwAdd(mix(a, b, ends.x));
    rtwAdd(mix(a, b, ends.y));
  }
}
