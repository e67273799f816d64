// Backward: from a view sample to the light (Rosen 2012, section 4.1).
LitSample rtwLoadPixel(ivec2 pixel)
{
  SampledPlane plane = rtwLoadPlane(pixel);
  vec3 here = rtwOnLight(plane.here);
  vec2 dx = rtwOnLight(plane.right).xy - here.xy;
  vec2 dy = rtwOnLight(plane.above).xy - here.xy;
  float turn = dx.x * dy.y - dx.y * dy.x;
  LitSample s;
  s.position = plane.here;
  s.normal = normalize(cross(plane.right - plane.here, plane.above - plane.here));
  s.onLight = here.xy;
  s.w = here.z;
  s.footprint = vec2(length(vec2(dx.x, dy.x)), length(vec2(dx.y, dy.y)));
  s.across = abs(dx) + abs(dy);
  s.area = abs(turn);
  s.pixels = 1.0;
  // A surface that faces both viewer and light is seen the other way round from the light plane's back.
  s.used = plane.seen && turn < 0.0 && here.z > 0.0 && rtwReached(s.onLight) &&
    rtwIsOfLayer(plane.here);
  return s;
}

LitSample rtwLoadSample(ivec2 index)
{
  return rtwLoadPixel(rtwSquareOf(index, textureSize(rtwSamples, 0)).pixel);
}

const int TILE = 64; // samples a side that a work group of 16 times 16 looks at
const int SAMPLES = TILE * TILE / 256; // of an invocation

// What a stage does with a sample that the light reaches.
void rtwVisit(LitSample s);

// Of the work group's tile those that the invocation looks at; whether there is one.
bool rtwIsOfTile(int number, out ivec2 index)
{
  const int STEPS = TILE / 16;
  index = ivec2(gl_WorkGroupID.xy) * TILE + ivec2(gl_LocalInvocationID.xy) + 16 * ivec2(number % STEPS, number / STEPS);
  return all(lessThan(index, rtwSquares(textureSize(rtwSamples, 0))));
}

void rtwVisitTile()
{
  for (int i = 0; i < SAMPLES; ++i)
  {
    ivec2 index;
    if (rtwIsOfTile(i, index))
    {
      LitSample s = rtwLoadSample(index);
      if (s.used)
      {
        rtwVisit(s);
      }
    }
  }
}
