// A view sample as an analysis for one light sees it.
uniform mat4 rtwViewToLight;
uniform vec4 rtwCone; // a spot's: centre, tangent; tangent 0 for a directional light
uniform int rtwStride; // every how many pixels there is a sample

struct LitSample
{
  bool used; // there is a surface, and it faces the light and lies in its reach
  vec3 position;
  vec3 normal; // in view coordinates, towards the viewer
  vec2 onLight;
  float w;
  vec2 footprint; // of a pixel
};

vec3 rtwOnLight(vec3 position)
{
  vec4 p = rtwViewToLight * vec4(position, 1.0);
  return vec3(p.xy / p.w, p.w);
}

LitSample rtwLoadSample(ivec2 index)
{
  SampledPlane plane = rtwLoadPlane(index * rtwStride + rtwStride / 2);
  vec3 here = rtwOnLight(plane.here);
  vec2 dx = rtwOnLight(plane.right).xy - here.xy;
  vec2 dy = rtwOnLight(plane.above).xy - here.xy;
  // A surface that faces both viewer and light is seen the other way round from the light plane's back.
  bool faces = dx.x * dy.y - dx.y * dy.x < 0.0 && here.z > 0.0;
  LitSample s;
  s.position = plane.here;
  s.normal = normalize(cross(plane.right - plane.here, plane.above - plane.here));
  s.onLight = here.xy;
  s.w = here.z;
  s.footprint = vec2(length(vec2(dx.x, dy.x)), length(vec2(dx.y, dy.y)));
  bool reached = rtwCone.z == 0.0 || distance(s.onLight, rtwCone.xy) <= rtwCone.z;
  s.used = plane.seen && faces && reached;
  return s;
}

ivec2 rtwNumberOfSamples()
{
  return max(textureSize(rtwSamples, 0) / rtwStride, ivec2(1));
}
