// Each invocation evaluates one sub-patch.
//SM::Define
layout(local_size_x = 32) in;
//SM::Include smPortable
//SM::Include smInvocation
//SM::Include smSchemeStorage
//SM::Include smTexelStorage

uniform int smPoints;
uniform double smPerturbation;

dvec4 smControlPoint(uint index)
{
  return smControlPoints[index];
}

double smCoefficient(uint index)
{
  return smSchemeValues[index];
}

smSchemePatch smGetSource(uint index)
{
  return smSources[index];
}

void smSetResult(uint at, double value)
{
  smResults[at] = value;
}

//SM::Include smBernstein
//SM::Include smPatch
//SM::Include smTrimTexture
//SM::Include smSubPatch

void main()
{
  uint index = smInvocationIndex();
  if (index >= smWorkCount)
  {
    return;
  }
  index += smFirstWork;
  smSchemeTile tile = smTiles[smFindTile(index, 0)];
  uint evaluations = smIntegrateSubPatch(tile, index - tile.begin.x, 16u * index);
  if (evaluations > 0u)
  {
    atomicAdd(smCounts[0], evaluations);
  }
}
