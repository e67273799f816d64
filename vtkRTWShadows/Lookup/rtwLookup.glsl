// The shadow of one light on one receiver: where it lies on the map, and how much of the light the texels there let through.
#if !defined(RTW_LAYERS_IN_UNIFORMS)
uniform int rtwFirstLayer; // the first layer of the first of these lights
#endif
uniform int rtwOtherLayers; // how far behind each layer that of the light's other casters lies
uniform mat4 rtwToLight[RTW_LIGHTS];   // from view coordinates to (l · w, depth · w, w)
uniform vec4 rtwCone[RTW_LIGHTS];      // a spot's: centre, tangent; tangent 0 for a directional light
// x: of depth, for its format; y / w²: of depth, for rounded lengths; z / w²: the constant bias; w / w: of l
uniform vec4 rtwTolerance[RTW_LIGHTS];

const float RTW_NOT_LIT = -1.0; // facing away from the light or out of its reach: VTK's lighting knows that already

// Light-plane coordinates, depth, and w.
vec4 rtwOnLightPlane(int light, vec3 p)
{
  vec4 h = rtwToLight[light] * vec4(p, 1.0);
  return vec4(h.xyz * (1.0 / h.w), h.w);
}

float rtwFiltered(int light, int layer, vec4 focus, rtwReceiver r, float w)
{
#if RTW_FILTER == 0
  return rtwNearest(layer, r);
#elif RTW_FILTER == 1
  return rtwBilinear(layer, r);
#else
  if (rtwTaps[light].w == 0.0)
  {
    return rtwBilinear(layer, r);
  }
  return rtwFilteredByTaps(layer, r, rtwMakeKernel(light, layer, focus, r, w));
#endif
}

// How much of a light reaches a receiver by the map of a layer.
float rtwVisibilityOn(int light, int layer, vec4 focus, vec4 l, vec3 dx, vec3 dy, float area)
{
  float visibility = 1.0;
  vec3 q = vec3(rtwFocused(focus, l.xy), l.z);
  if (all(equal(clamp(q.xy, 0.0, 1.0), q.xy)))
  {
    vec3 cone = rtwCone[light].xyz;
    // The two differences lie in one plane, whose gradient they give whatever their length.
    vec2 gradient = vec2(dx.z * dy.y - dy.z * dx.y, dx.x * dy.z - dy.x * dx.z) / (area * focus.yw);
    vec4 t = rtwTolerance[light];
    // A length in units of depth shrinks with the square of the distance to a spot; w is 1 elsewhere.
#if RTW_DEPTH_TEST == 2
    float tolerance = t.z / (l.w * l.w);
#else
    // A rounded position is off sideways too: by as much more as it is nearer to the plane of a spot and farther from its axis.
    vec2 aside = 1e-6 + t.w / l.w * (1.0 + distance(l.xy, cone.xy)) * focus.yw;
    float tolerance = t.x + t.y / (l.w * l.w) + dot(abs(gradient), aside);
#endif
    rtwReceiver r = rtwReceiver(q, gradient, tolerance);
    visibility = rtwFiltered(light, layer, focus, r, l.w);
#if RTW_OTHER_LAYERS
    visibility = min(visibility, rtwFiltered(light, layer + rtwOtherLayers, focus, r, l.w));
#endif
  }
  return visibility;
}

#if RTW_PARTS > 1
uniform vec4 rtwBeams[RTW_LIGHTS]; // the `beam` of rtwFaceAt()

#if RTW_BLENDS
// The share, 0 to 1, to which the layer at a depth has given way to the next.
float rtwShareOfNext(int first, float depth)
{
  vec2 band = vec2(1.0, 0.0); // an empty band
  for (int k = rtwFaces; k < RTW_PARTS; k += rtwFaces)
  {
    vec2 here = vec2(rtwBlendStart(first + k), rtwIntervalOf(first + k).x);
    band = depth > here.x && depth < here.y ? here : band;
  }
  return depth > band.x && depth < band.y ? (depth - band.x) / (band.y - band.x) : 0.0;
}
#endif

// The layer that holds a point, its focus too. Beside a seam there are receivers that no view sample stands for,
// between samples or between those of a pixel, which their own layer may not hold: the next layer that holds them will
// do, the farther of two. The focus is returned because to look for it again by the layer's number costs more.
int rtwLayerThatHolds(int wanted, int first, vec2 onLight, out vec4 focus)
{
  int layer = wanted;
  int least = 2 * RTW_PARTS;
  focus = vec4(0.0);
  for (int k = first; k < first + RTW_PARTS; ++k)
  {
    vec4 here = rtwFocusOf(k);
    vec2 q = rtwFocused(here, onLight);
    bool holds = all(equal(clamp(q, 0.0, 1.0), q));
    int away = holds ? k < wanted ? 2 * (wanted - k) + 1 : 2 * (k - wanted) : 2 * RTW_PARTS;
    bool better = away < least || (k == wanted && least == 2 * RTW_PARTS);
    layer = better ? k : layer;
    focus = better ? here : focus;
    least = min(away, least);
  }
  return layer;
}
#endif

// How much of a light reaches a receiver, between 0 and 1, or RTW_NOT_LIT. dx and dy lead to the points of its tangent plane one
// pixel to the right and one above, on the light plane and in depth; p is the receiver in view coordinates.
float rtwVisibility(int light, vec4 l, vec3 dx, vec3 dy, vec3 p)
{
  float area = dx.x * dy.y - dx.y * dy.x;
  // A surface that faces both viewer and light is seen the other way round from the light plane's back.
  vec3 cone = rtwCone[light].xyz;
  bool faces = area < 0.0 && l.w > 0.0 && (cone.z == 0.0 || distance(l.xy, cone.xy) <= cone.z);
  float visibility = RTW_NOT_LIT;
  if (faces)
  {
    int first = light * RTW_PARTS + rtwFirstLayer;
#if RTW_PARTS > 1
    int wanted = rtwLayerAt(first, RTW_PARTS, p, rtwBeams[light]);
    vec4 focus;
    int layer = rtwLayerThatHolds(wanted, first, l.xy, focus);
#if RTW_BLENDS
    int next = min(wanted + rtwFaces, first + RTW_PARTS - 1);
    float share = rtwShareOfNext(first, -p.z);
    // A loop, since some drivers go through both branches of a condition: nearly no receiver lies in a band.
    visibility = 0.0;
    float weight = 1.0 - share;
    int lookups = share > 0.0 ? 2 : 1;
    do
    {
      visibility += weight * rtwVisibilityOn(light, layer, focus, l, dx, dy, area);
      layer = next;
      focus = rtwFocusOf(next);
      weight = share;
      --lookups;
    } while (lookups > 0);
#else
    visibility = rtwVisibilityOn(light, layer, focus, l, dx, dy, area);
#endif
#else
    visibility = rtwVisibilityOn(light, first, rtwFocusOf(first), l, dx, dy, area);
#endif
  }
  return visibility;
}
