// View samples from a frame's depth: a sample stands for a square of pixels, and its plane is that of the pixel in the middle and the
// nearer in depth of the two beside it, along each axis, because the other may be of another surface.
uniform sampler2D rtwDepth;
uniform int rtwStride;         // pixels a side of a square
uniform vec2 rtwDepthToSample; // scale, offset
layout(location = 0) out vec4 viewSample;

float rtwDifference(ivec2 pixel, float depth, ivec2 step)
{
  ivec2 before = pixel - step;
  ivec2 after = pixel + step;
  ivec2 size = textureSize(rtwDepth, 0);
  float back = any(lessThan(before, ivec2(0))) ? 1.0 : depth - texelFetch(rtwDepth, before, 0).r;
  float forth = any(greaterThanEqual(after, size)) ? 1.0 : texelFetch(rtwDepth, after, 0).r - depth;
  return abs(back) < abs(forth) ? back : forth;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) * rtwStride + rtwStride / 2;
  float depth = texelFetch(rtwDepth, pixel, 0).r;
  vec2 slope = vec2(rtwDifference(pixel, depth, ivec2(1, 0)), rtwDifference(pixel, depth, ivec2(0, 1)));
  viewSample = depth < 1.0
    ? vec4(depth * rtwDepthToSample.x + rtwDepthToSample.y, slope * rtwDepthToSample.x * float(rtwStride), 1.0)
    : vec4(0.0);
}
