// Lets a fragment through if the queue was too short, for drawing that depends on it.
out vec4 mask;

void main()
{
  if (rtwQueue[OVERFLOW] == 0u)
  {
    discard;
  }
  mask = vec4(1.0);
}
