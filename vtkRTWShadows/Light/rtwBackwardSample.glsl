// Backward: from a view sample to the light (Rosen 2012, section 4.1).
LitSample rtwLoadSample(ivec2 index)
{
  SampledSquare square = rtwSquareOf(index, textureSize(rtwSamples, 0));
  SampledPlane plane = rtwLoadPlane(square.pixel);
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
  ivec2 before = square.pixel - square.low;
  ivec2 away = max(before, square.extent - 1 - before);
  s.reach = float(max(away.x, away.y)) * (abs(dx) + abs(dy));
  s.area = abs(turn);
  s.pixels = 1.0;
  // A surface that faces both viewer and light is seen the other way round from the light plane's back.
  s.used = plane.seen && turn < 0.0 && here.z > 0.0 && rtwReached(s.onLight);
  return s;
}

const int TILE = 64; // samples a side that a work group of 16 times 16 looks at

// What a stage does with a sample.
void rtwVisit(LitSample s);

// All samples of the work group's tile that the light reaches.
void rtwVisitTile()
{
  ivec2 size = rtwSquares(textureSize(rtwSamples, 0));
  ivec2 corner = ivec2(gl_WorkGroupID.xy) * TILE + ivec2(gl_LocalInvocationID.xy);
  for (int y = 0; y < TILE; y += 16)
  {
    for (int x = 0; x < TILE; x += 16)
    {
      ivec2 pixel = corner + ivec2(x, y);
      if (all(lessThan(pixel, size)))
      {
        LitSample s = rtwLoadSample(pixel);
        if (s.used)
        {
          rtwVisit(s);
        }
      }
    }
  }
}
