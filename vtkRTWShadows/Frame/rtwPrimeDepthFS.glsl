// The view samples as a depth buffer, a little farther than they are, so that what they hide is not shaded and what they show is.
uniform ivec2 rtwOrigin; // the viewport's corner in the target, in pixels

void main()
{
  vec4 s = texelFetch(rtwSamples, ivec2(gl_FragCoord.xy) - rtwOrigin, 0);
  // Where there is no sample nothing is hidden.
  gl_FragDepth = s.x > 0.0 ? rtwSampleDepth(s.x) : 1.0;
}
