// Each invocation draws a part of one trim curve of one tile.
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
  smSchemeTile tile = smTiles[smFindTile(index, 1)];
  smDrawTrim(tile, index - tile.begin.y);
}
