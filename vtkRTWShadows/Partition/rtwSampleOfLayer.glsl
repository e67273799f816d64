// Whether a sample of the view is looked up in the layer that is worked on.
uniform int rtwParts; // layers that the light has
uniform int rtwSampledLayer;
uniform vec4 rtwBeam;

bool rtwIsOfLayer(vec3 position)
{
  return rtwParts == 1 ||
    (-position.z >= rtwBlendStart(rtwSampledLayer) && -position.z < rtwIntervalOf(rtwSampledLayer).y &&
      (rtwFaces == 1 || rtwSampledLayer % rtwFaces == rtwFaceAt(position, rtwBeam)));
}
