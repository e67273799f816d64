// The depth image that a light sees, unwarped over the focus: the depth of each texel, and the depth's gradient over
// the image.
uniform sampler2DArray rtwImageDepths;
uniform sampler2DArray rtwImageGradients;
uniform int rtwImageLayer;

ivec2 rtwImageSize()
{
  return textureSize(rtwImageDepths, 0).xy;
}

float rtwImageDepth(ivec2 texel)
{
  return texelFetch(rtwImageDepths, ivec3(texel, rtwImageLayer), 0).r;
}

vec2 rtwImageGradient(ivec2 texel)
{
  return texelFetch(rtwImageGradients, ivec3(texel, rtwImageLayer), 0).rg;
}
