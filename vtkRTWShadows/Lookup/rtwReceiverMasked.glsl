// A receiver whose shadow stands in the mask.
uniform sampler2DArray rtwMask;
// The mask's corner in the target, in pixels; outside of the mask its outermost pixels count.
uniform ivec2 rtwMaskOrigin;
uniform float rtwAttenuation[RTW_LIGHTS];

// What a light's colour is to be multiplied by.
float rtwFactor(int light, vec3 p)
{
  ivec2 place = clamp(ivec2(gl_FragCoord.xy) - rtwMaskOrigin, ivec2(0), textureSize(rtwMask, 0).xy - 1);
  ivec3 pixel = ivec3(place, light);
  float visibility = rtwReceives == 0 ? 1.0 : rtwMaskedVisibility(texelFetch(rtwMask, pixel, 0).r);
  return mix(1.0, visibility, rtwAttenuation[light]);
}
