// Nobody asks where shadow edges are.
bool rtwAtShadowEdge(LitSample s, vec4 focus)
{
  return true;
}
