// Whether a texel's centre lies in the triangle: on the light plane, where edges are straight.
flat in vec3 edges[3]; // signed distance from each edge, as its product with (q - anchor, 1)
// a share of the focus; a point on a shared edge belongs to both triangles, so that nothing leaks
const float ROUNDING = 3e-7;

void main()
{
  vec2 q = rtwCentreOfTexel();
  vec3 away = vec3(q - anchor.xy, 1.0);
  if (min(min(dot(edges[0], away), dot(edges[1], away)), dot(edges[2], away)) < -ROUNDING)
  {
    discard;
  }
  rtwWrite(q);
}
