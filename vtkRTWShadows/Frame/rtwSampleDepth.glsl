// View samples as a depth buffer has them, a little farther, or nearer, than they are.
uniform vec2 rtwSampleToDepth; // scale, offset
uniform vec2 rtwFarther;       // a share of the distance, and a distance; in a framed view a share of what is seen
uniform int rtwFramed;

float rtwSampleDepth(float a)
{
  float moved = rtwFramed != 0 ? a - rtwFarther.x : 1.0 / ((1.0 + rtwFarther.x) / a + rtwFarther.y);
  return clamp(moved * rtwSampleToDepth.x + rtwSampleToDepth.y, 0.0, 1.0);
}
