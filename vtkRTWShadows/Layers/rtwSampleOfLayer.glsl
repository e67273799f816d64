// Whether a sample of the view is looked up in a layer.
uniform int rtwParts; // layers of the light
uniform int rtwSampledLayer;
uniform vec4 rtwBeam;

bool rtwBelongsTo(int layer, vec3 position)
{
  return rtwParts == 1 ||
    (-position.z >= rtwBlendStart(layer) && -position.z < rtwIntervalOf(layer).y &&
      (rtwFaces == 1 || layer % rtwFaces == rtwFaceAt(position, rtwBeam)));
}

// Whether it is looked up in the layer that is worked on.
bool rtwIsOfLayer(vec3 position)
{
  return rtwBelongsTo(rtwSampledLayer, position);
}
