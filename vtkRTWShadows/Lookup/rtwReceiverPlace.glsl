// Where a fragment of the picture lies in the view coordinates of the shadows, if its vertices didn't tell. VTK's begin at the camera, and
// are coarse where that is far from what is seen, so that the shadows' view is framed: then depth tells more, unless the camera's range is
// wider than its distance.
uniform int rtwPlacedBy;     // VTK's view coordinates: 0 as they are, 1 moved; 2 depth
uniform float rtwViewBegin;  // from the camera to where view coordinates begin
uniform vec4 rtwRay;         // as the view samples have them
uniform vec4 rtwOfSample;
uniform vec2 rtwDepthToSample; // scale, offset
uniform vec4 rtwToClip;      // of a fragment's place in the window: scale, offset

vec3 rtwPlaceOf(vec3 p, float depth)
{
  float a = depth * rtwDepthToSample.x + rtwDepthToSample.y;
  vec2 clip = gl_FragCoord.xy * rtwToClip.xy + rtwToClip.zw;
  vec3 byDepth = vec3(clip * rtwRay.xy + rtwRay.zw, rtwOfSample.x + rtwOfSample.y * a) / (rtwOfSample.z + rtwOfSample.w * a);
  vec3 moved = vec3(p.xy, p.z + (rtwPlacedBy == 0 ? 0.0 : rtwViewBegin));
  return rtwPlacedBy == 2 ? byDepth : moved;
}
