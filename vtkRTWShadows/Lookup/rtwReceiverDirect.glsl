// A receiver that looks its shadow up itself: translucent, or multisampled, so that the mask doesn't know it.
uniform float rtwAttenuation[RTW_LIGHTS];

// What a light's colour is to be multiplied by. To be called by all fragments.
float rtwFactor(int light, vec3 p)
{
  vec4 l = rtwOnLightPlane(light, p);
  float visibility = rtwVisibility(light, l, dFdx(l.xyz), dFdy(l.xyz), p);
  return visibility == RTW_NOT_LIT || rtwReceives == 0 ? 1.0 : mix(1.0, visibility, rtwAttenuation[light]);
}
