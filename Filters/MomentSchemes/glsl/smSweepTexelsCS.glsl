// Each invocation sweeps one row of texels of one tile.
//SM::Define
layout(local_size_x = 32) in;
//SM::Include smPortable
//SM::Include smInvocation
//SM::Include smSchemeStorage
//SM::Include smTexelStorage
//SM::Include smTrimTexture

void main()
{
  uint index = smInvocationIndex();
  if (index >= smWorkCount)
  {
    return;
  }
  index += smFirstWork;
  smSchemeTile tile = smTiles[smFindTile(index, 2)];
  smSweepTexels(tile, index - tile.begin.z);
}
