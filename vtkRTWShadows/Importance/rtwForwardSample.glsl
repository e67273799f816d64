// Forward analysis (Rosen 2012, section 4.1): a sample from a texel of the light's depth image, looked back into the
// view.
uniform mat4 rtwLightToView; // light-plane coordinates and depth, homogeneous
uniform vec2 rtwViewSize;    // in pixels

vec3 rtwFromLight(vec4 focus, vec2 q, float depth)
{
  vec4 p = rtwLightToView * vec4(focus.xz + q / focus.yw, depth, 1.0);
  return p.xyz / p.w;
}

// How far a point moves on the screen, in pixels, while it moves by a little in view coordinates.
vec2 rtwScreenStep(vec4 clip, vec3 step)
{
  vec4 change = rtwViewToClip * vec4(step, 0.0);
  return 0.5 * rtwViewSize * (change.xy - clip.xy / clip.w * change.w) / clip.w;
}

LitSample rtwLoadTexel(ivec2 texel, vec4 focus)
{
  vec2 side = 1.0 / vec2(rtwImageSize());
  vec2 q = (vec2(texel) + 0.5) * side;
  float depth = rtwImageDepth(texel);
  vec2 rise = rtwImageGradient(texel) * side;
  vec3 here = rtwFromLight(focus, q, depth);
  vec3 right = rtwFromLight(focus, q + vec2(side.x, 0.0), depth + rise.x) - here;
  vec3 above = rtwFromLight(focus, q + vec2(0.0, side.y), depth + rise.y) - here;
  vec4 clip = rtwViewToClip * vec4(here, 1.0);
  vec2 dx = rtwScreenStep(clip, right);
  vec2 dy = rtwScreenStep(clip, above);
  float turn = dx.x * dy.y - dx.y * dy.x;
  float pixels = max(abs(turn), 1e-20);
  vec3 toViewer = rtwToViewer(here);
  LitSample s;
  s.position = here;
  s.normal = normalize(cross(right, above));
  s.normal *= dot(s.normal, toViewer) < 0.0 ? -1.0 : 1.0;
  s.onLight = focus.xz + q / focus.yw;
  s.w = rtwOnLight(here).z;
  // The footprint of a pixel follows from the inverse of how texels lie on the screen.
  s.footprint = vec2(length(dy), length(dx)) / pixels * side / focus.yw;
  s.across = s.footprint;
  s.area = side.x * side.y / (pixels * focus.y * focus.w);
  s.pixels = pixels;
  bool inView = clip.w > 0.0 && all(lessThanEqual(abs(clip.xyz), vec3(clip.w)));
  s.used = depth < 1.0 && inView && turn < 0.0 && rtwReached(s.onLight) && rtwIsOfLayer(here);
  return s;
}
