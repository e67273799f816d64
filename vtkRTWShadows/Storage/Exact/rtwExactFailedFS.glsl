// A fragment, if the queue was too short.
out vec4 mask;

void main()
{
  if (rtwQueue[OVERFLOW] == 0u)
  {
    discard;
  }
  mask = vec4(1.0);
}
