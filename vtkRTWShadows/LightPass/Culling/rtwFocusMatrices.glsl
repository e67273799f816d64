// The light's matrix of each instance, from light-plane to focused coordinates.
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer LightMatrices
{
  mat4 rtwLightMatrices[];
};
layout(std430, binding = 1) writeonly buffer Matrices
{
  mat4 rtwMatrices[];
};
uniform int rtwNumberOfInstances;
uniform int rtwLayer;

void main()
{
  int i = int(gl_GlobalInvocationID.x);
  if (i >= rtwNumberOfInstances)
  {
    return;
  }
  vec4 focus = rtwFocus(rtwLayer);
  mat4 m = rtwLightMatrices[i];
  for (int column = 0; column < 4; ++column)
  {
    m[column].x = (m[column].x - focus.x * m[column].w) * focus.y;
    m[column].y = (m[column].y - focus.z * m[column].w) * focus.w;
  }
  rtwMatrices[i] = m;
}
