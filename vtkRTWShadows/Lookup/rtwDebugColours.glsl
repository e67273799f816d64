// The colours of debug views; vtkInspectableShadowMapPass explains them.
const vec3 NEITHER = vec3(0.5); // turned away from the light, or out of its reach

// Aliasing error: from blue, 16 times as fine as pixels, over white to red, 16 times too coarse.
const vec3 ALIASING[9] = vec3[9](vec3(0.02, 0.05, 0.35), vec3(0.10, 0.25, 0.70), vec3(0.25, 0.50, 0.90),
  vec3(0.65, 0.82, 1.00), vec3(1.00, 1.00, 1.00), vec3(1.00, 0.80, 0.40), vec3(0.98, 0.50, 0.15),
  vec3(0.80, 0.08, 0.05), vec3(0.35, 0.00, 0.02));
// Density of texels: from a sixteenth of the mean to 16 times the mean.
const vec3 DENSITY[9] = vec3[9](vec3(0.05, 0.02, 0.15), vec3(0.20, 0.05, 0.36), vec3(0.42, 0.09, 0.43),
  vec3(0.62, 0.17, 0.39), vec3(0.80, 0.26, 0.30), vec3(0.93, 0.42, 0.18), vec3(0.98, 0.62, 0.05),
  vec3(0.96, 0.82, 0.28), vec3(0.98, 0.99, 0.75));
const vec3 LAYER[6] = vec3[6](vec3(0.30, 0.62, 0.85), vec3(0.95, 0.60, 0.20), vec3(0.40, 0.75, 0.35),
  vec3(0.85, 0.35, 0.55), vec3(0.60, 0.50, 0.85), vec3(0.80, 0.75, 0.30));

// The colour of a ratio from 1/16 to 16, an octave a colour.
vec3 rtwOnScale(vec3 scale[9], float ratio)
{
  float octave = clamp(log2(max(ratio, 1e-30)), -4.0, 4.0) + 4.0;
  int below = min(int(octave), 7);
  return mix(scale[below], scale[below + 1], octave - float(below));
}
