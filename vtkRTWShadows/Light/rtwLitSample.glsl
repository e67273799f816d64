// A sample of what the camera sees, as an analysis for one light looks at it.
uniform mat4 rtwViewToLight;
uniform vec4 rtwCone; // a spot's: centre, tangent; tangent 0 for a directional light

struct LitSample
{
  bool used; // there is a surface, and it faces the light and lies in its reach
  vec3 position;
  vec3 normal; // in view coordinates, towards the viewer
  vec2 onLight;
  float w;
  vec2 footprint; // of a pixel
  vec2 across;    // the bounds of that
  float area;     // and its area
  float pixels;   // that it stands for
};

vec3 rtwOnLight(vec3 position)
{
  vec4 p = rtwViewToLight * vec4(position, 1.0);
  return vec3(p.xy / p.w, p.w);
}

bool rtwReached(vec2 onLight)
{
  return rtwCone.z == 0.0 || distance(onLight, rtwCone.xy) <= rtwCone.z;
}
