flat in vec2 slope;

void main()
{
  gradient = rtwGradient(gl_FragCoord.z, slope);
}
