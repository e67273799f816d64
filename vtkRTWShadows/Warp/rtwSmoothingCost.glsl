// What a strength of smoothing costs, a work group each: the error that is predicted for functions which a coarse grid has then, times more
// where neighbouring functions differ. That shears texels, which makes them longer, and what is drawn straight strays from where it belongs.
layout(local_size_x = COARSE_CELLS) in;

layout(std430, binding = 1) readonly buffer Coarse
{
  float rtwCoarse[]; // a line, a cell: what is asked for
};
layout(std430, binding = 2) writeonly buffer Costs
{
  float rtwCosts[];
};
uniform int rtwIsUnderRoot;
uniform float rtwFloor; // a share of the mean
uniform float rtwBendCost;
shared float rtwWeights[COARSE_CELLS];
shared float rtwFunctions[COARSE_CELLS * (COARSE_CELLS + 1)];
shared vec2 rtwTotals[COARSE_CELLS];

int line = int(gl_LocalInvocationIndex);

float rtwFunction(int l, int border)
{
  return rtwFunctions[clamp(l, 0, COARSE_CELLS - 1) * (COARSE_CELLS + 1) + border];
}

float rtwSmoothedCell(int cell)
{
  float sum = 0.0;
  for (int l = 0; l < COARSE_CELLS; ++l)
  {
    sum += rtwWeights[abs(l - line)] * rtwCoarse[l * COARSE_CELLS + cell];
  }
  return rtwIsUnderRoot != 0 ? sqrt(sum) : sum;
}

void rtwMakeFunction()
{
  float all = 0.0;
  for (int cell = 0; cell < COARSE_CELLS; ++cell)
  {
    float value = rtwSmoothedCell(cell);
    rtwFunctions[line * (COARSE_CELLS + 1) + cell] = value;
    all += value;
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

// And what is asked for there.
vec2 rtwCostOfCell(int cell)
{
  float asked = rtwCoarse[line * COARSE_CELLS + cell];
  vec3 at = vec3(0.0); // the line before, this one and the next, at the cell's middle
  for (int k = -1; k <= 1; ++k)
  {
    at[k + 1] = 0.5 * (rtwFunction(line + k, cell) + rtwFunction(line + k, cell + 1));
  }
  float steps = line > 0 && line < COARSE_CELLS - 1 ? 2.0 : 1.0;
  float shear = SHEAR * (abs(at.y - at.x) + abs(at.z - at.y)) * float(COARSE_CELLS) / steps;
  float bend = steps > 1.5 ? abs(at.x - 2.0 * at.y + at.z) * float(COARSE_CELLS * COARSE_CELLS) : 0.0;
  float density = (rtwFunction(line, cell + 1) - rtwFunction(line, cell)) * float(COARSE_CELLS);
  return vec2(asked / density * (sqrt(1.0 + shear * shear) + rtwBendCost * bend), asked);
}

void main()
{
  float sigma = rtwSmoothingOf(int(gl_WorkGroupID.x)) * float(COARSE_CELLS);
  float away = float(line) / sigma;
  rtwWeights[line] = exp(-0.5 * away * away);
  barrier();
  rtwMakeFunction();
  barrier();
  rtwTotals[line] = vec2(0.0);
  for (int cell = 0; cell < COARSE_CELLS; ++cell)
  {
    rtwTotals[line] += rtwCostOfCell(cell);
  }
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
