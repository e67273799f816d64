// How many view samples each pixel's texel holds, painted over what is drawn of the view samples.
uniform int rtwLayer;
uniform mat4 rtwViewToLight;
uniform ivec2 rtwOrigin; // the viewport's corner in the target, in pixels
out vec4 colour;

const float MIDDLE = 16.0; // the number of samples in the middle of the colour scale

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - rtwOrigin;
  SampledPlane plane = rtwLoadPlane(pixel);
  if (!plane.seen)
  {
    discard;
  }
  vec4 h = rtwViewToLight * vec4(plane.here, 1.0);
  vec2 onMap = rtwWarp(rtwLayer, rtwFocused(rtwFocus(rtwLayer), h.xy / h.w));
  uint count = h.w > 0.0 ? rtwNodes[rtwTexelAt(onMap)].count : 0u;
  colour = vec4(count > 0u ? rtwOnScale(DENSITY, float(count) / MIDDLE) : NEITHER, 1.0);
  gl_FragDepth = rtwSampleDepth(texelFetch(rtwSamples, pixel, 0).x);
}
