// The aliasing error of each pixel along s and t; 0 where no receiver faces the light.
out vec2 aliasing;

void main()
{
  MapSample m = rtwLoadMapSample(ivec2(gl_FragCoord.xy));
  aliasing = m.lit ? rtwAliasing(m) : vec2(0.0);
}
