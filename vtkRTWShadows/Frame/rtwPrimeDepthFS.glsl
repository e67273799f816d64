// The view samples as a depth buffer, a little farther than they are, so that what they hide is not shaded and what they show is.
uniform ivec2 rtwOrigin;      // of the viewport
uniform vec2 rtwSampleToDepth; // scale, offset
uniform vec2 rtwFarther;      // a share of the distance, and a distance; in a parallel view both are depths

void main()
{
  vec4 s = texelFetch(rtwSamples, ivec2(gl_FragCoord.xy) - rtwOrigin, 0);
  float a = rtwParallelView.x != 0.0 ? s.x + rtwFarther.x : 1.0 / ((1.0 + rtwFarther.x) / s.x + rtwFarther.y);
  // Where there is no sample nothing is hidden.
  gl_FragDepth = s.x > 0.0 ? clamp(a * rtwSampleToDepth.x + rtwSampleToDepth.y, 0.0, 1.0) : 1.0;
}
