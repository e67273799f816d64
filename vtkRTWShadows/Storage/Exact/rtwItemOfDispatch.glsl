// The number of the invocation in a dispatch in groups of 64 that has two dimensions only because one doesn't reach far
// enough.
uint rtwInvocation()
{
  return gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x;
}
