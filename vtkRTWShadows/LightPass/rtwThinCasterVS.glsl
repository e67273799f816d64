// A line or a point on its way into the shadow map.
layout(location = 0) in vec3 point;
layout(location = 1) in mat4 toFocused; // q · w, depth · w, w
uniform int rtwLayer;
out float depth; // linear on the light plane, whatever the warp's division does to the map

void main()
{
  vec4 p = toFocused * vec4(point, 1.0);
  vec3 onLight = p.xyz / p.w;
  vec3 u = rtwWarpHomogeneous(rtwLayer, onLight.xy);
  depth = onLight.z;
  gl_Position = vec4(2.0 * u.xy - u.z, 0.0, u.z);
}
