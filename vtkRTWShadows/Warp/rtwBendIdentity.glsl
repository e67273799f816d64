float rtwBend(int layer, int axis, float low, float high)
{
  return 0.0;
}

float rtwShift(int layer, int axis, float low, float high)
{
  return 0.0;
}

float rtwBendOfPieces(int layer, int axis, float low, float high, float piece)
{
  return 0.0;
}
