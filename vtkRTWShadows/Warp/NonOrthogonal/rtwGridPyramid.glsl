// A level of the pyramid of planes near a grid's functions; a square further up holds four.
layout(local_size_x = 8, local_size_y = 8) in;

layout(std430, binding = 2) buffer Bends
{
  vec4 rtwPyramid[]; // as NearPlane
};
uniform int rtwLayer;
uniform int rtwLevel;

NearPlane rtwPlaneOfCell(int axis, ivec2 at)
{
  float cells = float(rtwWarpSize.x);
  int last = rtwWarpSize.x - 1;
  int cell = min(at.x, last);
  vec2 before = texelFetch(rtwWarpGrid, rtwGridPlace(rtwLayer, axis, max(at.y - 1, 0), cell)).xy;
  vec2 after = texelFetch(rtwWarpGrid, rtwGridPlace(rtwLayer, axis, min(at.y, last), cell)).xy;
  vec2 along = vec2(before.y - before.x, after.y - after.x);
  vec2 across = after - before;
  vec2 slope = 0.5 * vec2(along.x + along.y, across.x + across.y);
  float middle = 0.25 * (before.x + before.y + after.x + after.y);
  // The plane of the last cell goes on behind it.
  return NearPlane(middle + slope.x * float(at.x - cell), cells * slope, 0.25 * abs(along.y - along.x));
}

NearPlane rtwPlaneOfSquare(int place, int side, ivec2 at)
{
  vec4 entry = rtwPyramid[place + at.y * side + at.x];
  return NearPlane(entry.x, entry.yz, entry.w);
}

NearPlane rtwPlaneOfFour(int axis, ivec2 at)
{
  int side = rtwLevelSide(rtwLevel - 1);
  int place = rtwLevelPlace(rtwLayer, axis, rtwLevel - 1);
  float extent = float(1 << (rtwLevel - 1)) / float(rtwWarpSize.x); // of a square of the four
  ivec2 first = 2 * at;
  bvec2 alone = equal(first, ivec2(side - 1)); // at the end there are two, or one
  NearPlane planes[4];
  vec2 from[4];
  NearPlane near = NearPlane(0.0, vec2(0.0), 0.0);
  for (int k = 0; k < 4; ++k)
  {
    ivec2 next = ivec2(alone.x ? 0 : k % 2, alone.y ? 0 : k / 2);
    planes[k] = rtwPlaneOfSquare(place, side, first + next);
    from[k] = (vec2(next) - 0.5) * extent;
    near.slope += 0.25 * planes[k].slope;
  }
  // Where two planes lie side by side, the slope goes from the middle of one to that of the other.
  near.slope.x = alone.x ? near.slope.x : 0.5 * (planes[1].middle - planes[0].middle + planes[3].middle - planes[2].middle) / extent;
  near.slope.y = alone.y ? near.slope.y : 0.5 * (planes[2].middle - planes[0].middle + planes[3].middle - planes[1].middle) / extent;
  for (int k = 0; k < 4; ++k)
  {
    near.middle += 0.25 * (planes[k].middle - dot(near.slope, from[k]));
  }
  for (int k = 0; k < 4; ++k)
  {
    near.stray = max(near.stray, planes[k].stray + rtwDifference(near, from[k], planes[k], vec2(extent)));
  }
  return near;
}

void main()
{
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  int axis = int(gl_GlobalInvocationID.z);
  int side = rtwLevelSide(rtwLevel);
  if (all(lessThan(at, ivec2(side))))
  {
    NearPlane near = rtwLevel == 0 ? rtwPlaneOfCell(axis, at) : rtwPlaneOfFour(axis, at);
    rtwPyramid[rtwLevelPlace(rtwLayer, axis, rtwLevel) + at.y * side + at.x] = vec4(near.middle, near.slope, near.stray);
  }
}
