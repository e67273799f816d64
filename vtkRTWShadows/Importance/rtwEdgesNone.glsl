// No importance function in use depends on shadow edges.
bool rtwAtShadowEdge(LitSample s, vec4 focus)
{
  return true;
}
