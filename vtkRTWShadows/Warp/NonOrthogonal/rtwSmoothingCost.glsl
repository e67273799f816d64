// The cost of each strength of smoothing, by a work group each: the error that is predicted for functions which a
// coarse grid has then, times more where neighbouring functions differ. That shears texels, which makes them longer,
// and what is drawn straight strays from where it belongs.
layout(local_size_x = COARSE_CELLS) in;

uniform samplerBuffer rtwCoarse; // a line, four cells: what is asked for
layout(std430, binding = 2) writeonly buffer Costs
{
  float rtwCosts[];
};
uniform int rtwIsUnderRoot;
uniform float rtwFloor; // a share of the mean
uniform float rtwBendCost;
shared float rtwFunctions[COARSE_CELLS * (COARSE_CELLS + 1)];
shared vec2 rtwTotals[COARSE_CELLS];

int line = int(gl_LocalInvocationIndex);

float rtwFunction(int l, int border)
{
  return rtwFunctions[clamp(l, 0, COARSE_CELLS - 1) * (COARSE_CELLS + 1) + border];
}

const int COARSE_QUADS = COARSE_CELLS / 4;

// What a line asks for in four cells after smoothing.
vec4 rtwSmoothed(int quad)
{
  float sigma = rtwSmoothingOf(int(gl_WorkGroupID.x)) * float(COARSE_CELLS);
  vec4 sum = vec4(0.0);
  for (int l = 0; l < COARSE_CELLS; ++l)
  {
    float away = float(l - line) / sigma;
    sum += exp(-0.5 * away * away) * texelFetch(rtwCoarse, l * COARSE_QUADS + quad);
  }
  return rtwIsUnderRoot != 0 ? sqrt(sum) : sum;
}

void rtwMakeFunction()
{
  float all = 0.0;
  for (int quad = 0; quad < COARSE_QUADS; ++quad)
  {
    vec4 values = rtwSmoothed(quad);
    for (int k = 0; k < 4; ++k)
    {
      rtwFunctions[line * (COARSE_CELLS + 1) + 4 * quad + k] = values[k];
    }
    all += dot(values, vec4(1.0));
  }
  float least = rtwFloor * all / float(COARSE_CELLS);
  float sum = 0.0;
  float end = 0.0;
  for (int k = 0; k < 2; ++k) // first the sum, then its parts
  {
    end = max(sum, 1e-30);
    sum = 0.0;
    for (int cell = 0; cell < COARSE_CELLS; ++cell)
    {
      int i = line * (COARSE_CELLS + 1) + cell;
      float value = all > 0.0 ? max(rtwFunctions[i], least) : 1.0;
      rtwFunctions[i] = k == 0 ? value : sum / end;
      sum += value;
    }
  }
  rtwFunctions[line * (COARSE_CELLS + 1) + COARSE_CELLS] = 1.0;
}

// The functions of the line before, of this one and of the next, at a border between cells.
vec3 rtwLinesAt(int border)
{
  return vec3(rtwFunction(line - 1, border), rtwFunction(line, border), rtwFunction(line + 1, border));
}

// The cost of a cell, by what it asks for and the three functions at its two borders.
vec2 rtwCostOfCell(float asked, vec3 low, vec3 high)
{
  vec3 at = 0.5 * (low + high); // the cell's middle
  float steps = line > 0 && line < COARSE_CELLS - 1 ? 2.0 : 1.0;
  float shear = SHEAR * (abs(at.y - at.x) + abs(at.z - at.y)) * float(COARSE_CELLS) / steps;
  float bend = steps > 1.5 ? abs(at.x - 2.0 * at.y + at.z) * float(COARSE_CELLS * COARSE_CELLS) : 0.0;
  float density = (high.y - low.y) * float(COARSE_CELLS);
  return vec2(asked / density * (sqrt(1.0 + shear * shear) + rtwBendCost * bend), asked);
}

void main()
{
  rtwMakeFunction();
  barrier();
  vec2 cost = vec2(0.0);
  vec3 low = vec3(0.0);
  for (int quad = 0; quad < COARSE_QUADS; ++quad)
  {
    vec4 asked = texelFetch(rtwCoarse, line * COARSE_QUADS + quad);
    for (int k = 0; k < 4; ++k)
    {
      vec3 high = rtwLinesAt(4 * quad + k + 1);
      cost += rtwCostOfCell(asked[k], low, high);
      low = high;
    }
  }
  rtwTotals[line] = cost;
  barrier();
  if (line == 0)
  {
    vec2 all = vec2(0.0);
    for (int l = 0; l < COARSE_CELLS; ++l)
    {
      all += rtwTotals[l];
    }
    rtwCosts[gl_WorkGroupID.x] = all.y > 0.0 ? all.x / all.y : 1.0;
  }
}
