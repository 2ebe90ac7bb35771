// Access to the texels of chunk smSchemeStorage.
void smAddTexel(uint at, int change)
{
  atomicAdd(smTexels[at], change);
}

int smGetTexel(uint at)
{
  return smTexels[at];
}

void smSetTexel(uint at, int value)
{
  smTexels[at] = value;
}
