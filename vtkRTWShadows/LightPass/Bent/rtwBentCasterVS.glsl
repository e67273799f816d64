// A cover of a triangle that the warp bends: two triangles, set up before.
void main()
{
  int i = gl_VertexID / 6;
  int k = gl_VertexID - 6 * i;
  bool second = k > 2 && (rtwCovers[i].caster & 1u) != 0u; // triangle; otherwise it has no area
  rtwPassOn(rtwCovers[i].caster >> 1);
  vec2 a = rtwCovers[i].corners[0];
  vec2 b = rtwCovers[i].corners[1];
  vec2 c = rtwCovers[i].corners[2];
  vec2 onMap = k == 0 ? a : k == 1 ? b : k == 2 ? c : !second ? a : k == 3 ? c : k == 4 ? b : b + c - a;
  gl_Position = vec4(2.0 * onMap - 1.0, 2.0 * rtwCovers[i].depth - 1.0, 1.0);
}
