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
  vec2 footprint; // extent of a pixel along s and t on the light plane
  vec2 across;    // extent of the bounds of a pixel along s and t
  float area;     // area of a pixel on the light plane
  float pixels;   // number of pixels that the sample stands for
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
