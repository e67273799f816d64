// Backward analysis (Rosen 2012, section 4.1): what a view sample is for the light.
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
  s.used = plane.seen && turn < 0.0 && here.z > 0.0 && rtwReached(s.onLight);
  return s;
}

LitSample rtwLoadSample(ivec2 index)
{
  return rtwLoadPixel(rtwSquareOf(index, textureSize(rtwSamples, 0)).pixel);
}
