// A receiver whose pixel has several samples, each with a shadow of its own: it takes those that show it. The mask stands in where the
// samples are unknown.
uniform sampler2DArray rtwMask;
// Bits of a pixel's samples: 0 to 7 for those in shadow, 8 to 15 for those that face the light.
uniform usampler2DArray rtwSampleBits;
uniform sampler2DMS rtwManySamples;
// The mask's corner in the target, in pixels; outside of the mask its outermost pixels count.
uniform ivec2 rtwMaskOrigin;
uniform int rtwSamplesAPixel;
uniform vec2 rtwOffsets[8];     // from the centre, in pixels
uniform float rtwHiddenBeyond;  // the distance behind a sample beyond which the fragment is another surface
uniform float rtwAttenuation[RTW_LIGHTS];

// The same as a share of the distance or, in a framed view, of the depth of what is seen.
const float HIDDEN_SHARE = 1e-3;

uint rtwShown = 0u; // the samples that show the fragment's surface

ivec2 rtwPixel()
{
  return clamp(ivec2(gl_FragCoord.xy) - rtwMaskOrigin, ivec2(0), textureSize(rtwMask, 0).xy - 1);
}

// The samples that the fragment covers, but for those where another surface is in front. To be called by all fragments.
uint rtwFindShown(vec3 p)
{
  float a = (rtwOfSample.z * p.z - rtwOfSample.x) / (rtwOfSample.y - rtwOfSample.w * p.z);
  vec2 slope = vec2(dFdx(a), dFdy(a));
  ivec2 pixel = rtwPixel();
  uint shown = 0u;
  for (int i = 0; i < rtwSamplesAPixel; ++i)
  {
    vec4 s = texelFetch(rtwManySamples, pixel, i);
    float there = s.x + dot(s.yz, rtwOffsets[i]);
    float here = a + dot(slope, rtwOffsets[i]);
    bool hidden = rtwFramed != 0 ? there > here + HIDDEN_SHARE : there > here * (1.0 + HIDDEN_SHARE) + rtwHiddenBeyond * here * there;
    shown |= hidden ? 0u : 1u << uint(i);
  }
  return shown & uint(gl_SampleMaskIn[0]);
}

// What a light's colour is to be multiplied by.
float rtwFactor(int light, vec3 p)
{
  ivec3 pixel = ivec3(rtwPixel(), light);
  uint bits = texelFetch(rtwSampleBits, pixel, 0).r;
  uint facing = bits >> 8u;
  float visibility = rtwMaskedVisibility(texelFetch(rtwMask, pixel, 0).r);
  if (facing != 0u)
  {
    facing &= rtwShown;
    visibility = 1.0 - float(bitCount(bits & facing)) / float(max(bitCount(facing), 1));
  }
  return rtwReceives == 0 ? 1.0 : mix(1.0, visibility, rtwAttenuation[light]);
}
