// Gathers what a receiver needs of each layer to choose among layers into a buffer that is read as uniforms.
layout(local_size_x = 32) in;
layout(std430, binding = 0) writeonly buffer Layers
{
  vec4 rtwGathered[]; // a layer: its focus; its interval, and where the layer before begins to give way
};
uniform int rtwNumberOfLayers;

void main()
{
  int layer = int(gl_GlobalInvocationID.x);
  if (layer < rtwNumberOfLayers)
  {
    rtwGathered[2 * layer] = rtwFocus(layer);
    rtwGathered[2 * layer + 1] = vec4(rtwIntervalOf(layer), rtwBlendStart(layer), 0.0);
  }
}
