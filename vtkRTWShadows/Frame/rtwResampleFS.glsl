// View samples from a frame's depth: a sample stands for a square of pixels, and its plane is that of one of them and the nearer in
// depth of the two beside it, along each axis, because the other may be of another surface.
uniform sampler2D rtwDepth;
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
  SampledSquare square = rtwSquareOf(ivec2(gl_FragCoord.xy), textureSize(rtwDepth, 0));
  ivec2 pixel = square.pixel;
  float depth = texelFetch(rtwDepth, pixel, 0).r;
  vec2 slope = vec2(rtwDifference(pixel, depth, ivec2(1, 0)), rtwDifference(pixel, depth, ivec2(0, 1)));
  // The sample is moved along its plane to the square's middle, as which it is read.
  vec2 extent = vec2(square.extent);
  float middle = depth + dot(slope, 0.5 * (extent - 1.0) - vec2(pixel - square.low));
  viewSample = depth < 1.0
    ? vec4(middle * rtwDepthToSample.x + rtwDepthToSample.y, slope * rtwDepthToSample.x * extent, 1.0)
    : vec4(0.0);
}
