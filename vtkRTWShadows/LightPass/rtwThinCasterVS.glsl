// A line or a point on its way into the shadow map.
layout(location = 0) in vec3 point;
layout(location = 1) in mat4 toFocused; // q · w, depth · w, w
uniform int rtwLayer;

void main()
{
  vec4 p = toFocused * vec4(point, 1.0);
  vec3 onLight = p.xyz / p.w;
  gl_Position = vec4(2.0 * rtwWarp(rtwLayer, onLight.xy) - 1.0, 2.0 * onLight.z - 1.0, 1.0);
}
