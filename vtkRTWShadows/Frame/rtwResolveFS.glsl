// The sample of a pixel that lies nearest to its centre and sees anything, for whoever looks at one sample a pixel.
uniform sampler2DMS rtwManySamples;
uniform int rtwSamplesAPixel;
uniform vec2 rtwOffsets[8]; // places of a pixel's samples from its centre, in pixels
out vec4 viewSample;

void main()
{
  viewSample = vec4(0.0);
  float least = 2.0;
  for (int i = 0; i < rtwSamplesAPixel; ++i)
  {
    vec4 s = texelFetch(rtwManySamples, ivec2(gl_FragCoord.xy), i);
    float off = dot(rtwOffsets[i], rtwOffsets[i]);
    if (s.x > 0.0 && off < least)
    {
      least = off;
      viewSample = s;
    }
  }
}
