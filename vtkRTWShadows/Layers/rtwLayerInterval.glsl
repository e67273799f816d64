// Which of a light's layers a point of the view belongs to: the one whose interval holds its distance along the view direction, from where
// view coordinates begin, and of the faces of the view frustum that those depths may be divided among the one that a beam of light goes
// through there. Behind its focus in the warp table stands a layer's interval: from and up to; and where the layer before begins to give
// way to this one.
#if defined(RTW_FACES)
const int rtwFaces = RTW_FACES;
#else
uniform int rtwFaces; // 4, or 1: depths are not divided
#endif
uniform vec4 rtwSides[4]; // planes of the sides of the view frustum, in view coordinates, positive outside

#if defined(RTW_LAYERS_IN_UNIFORMS)
uniform int rtwFirstLayer; // the light's first layer
layout(std140) uniform Layers
{
  vec4 rtwGathered[2 * RTW_PARTS]; // the light's layers, as rtwGatherLayers.glsl writes them
};

vec4 rtwFocusOf(int layer)
{
  return rtwGathered[2 * (layer - rtwFirstLayer)];
}

vec2 rtwIntervalOf(int layer)
{
  return rtwGathered[2 * (layer - rtwFirstLayer) + 1].xy;
}

float rtwBlendStart(int layer)
{
  return rtwGathered[2 * (layer - rtwFirstLayer) + 1].z;
}
#else
vec4 rtwFocusOf(int layer)
{
  return rtwFocus(layer);
}

vec2 rtwIntervalOf(int layer)
{
  return rtwWarpEntry(4 * layer, rtwWarpSize.x + 1);
}

float rtwBlendStart(int layer)
{
  return rtwWarpEntry(4 * layer + 1, rtwWarpSize.x + 1).x;
}
#endif

// The side of the view frustum by which a beam of light through p leaves it when followed towards the viewer, where the
// beams of the image are narrow (Lloyd et al. 2006, section 5.1): against the light if that comes from behind the
// viewer, and with it if not. The near face is left out, as if the frustum began at the eye. `beam` is the direction to
// go, with w = 0, or a spot's place in homogeneous coordinates, with w = 1 if the beam is followed towards the spot and
// w = -1 if away from it.
int rtwFaceAt(vec3 p, vec4 beam)
{
  vec3 along = beam.xyz - beam.w * p;
  int face = 0;
  float nearest = 1e30;
  int k = 0;
  do // no more than once where there is one, for drivers that go through both branches of a condition
  {
    float rate = dot(rtwSides[k].xyz, along);
    float away = -dot(rtwSides[k], vec4(p, 1.0)) / rate;
    bool isNearer = rate > 0.0 && away < nearest;
    nearest = isNearer ? away : nearest;
    face = isNearer ? k : face;
    ++k;
  } while (k < rtwFaces);
  return face;
}

// The layer, among `parts` layers from the first on, that p belongs to.
int rtwLayerAt(int first, int parts, vec3 p, vec4 beam)
{
  int layer = first;
  for (int k = rtwFaces; k < parts; k += rtwFaces)
  {
    layer = -p.z >= rtwIntervalOf(first + k).x ? first + k : layer;
  }
  return rtwFaces == 1 ? layer : layer + rtwFaceAt(p, beam);
}
