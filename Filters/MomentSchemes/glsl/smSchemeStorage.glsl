// Storage of a batch of tiles, see smSchemeBatch.h, and the accessors that the shader chunks use.
// Bindings 0 to 6.
//SM::Include smSchemeTile

layout(std430, binding = 0) readonly buffer smControlPointBuffer
{
  dvec4 smControlPoints[];
};
layout(std430, binding = 1) readonly buffer smSourceBuffer
{
  smSchemePatch smSources[];
};
layout(std430, binding = 2) readonly buffer smValueBuffer
{
  double smSchemeValues[];
};
layout(std430, binding = 3) readonly buffer smTileBuffer
{
  smSchemeTile smTiles[];
};
layout(std430, binding = 4) buffer smTexelBuffer
{
  int smTexels[];
};
layout(std430, binding = 5) writeonly buffer smResultBuffer
{
  double smResults[];
};
// Element 0 counts the evaluations.
layout(std430, binding = 6) buffer smCountBuffer
{
  uint smCounts[];
};

uniform uint smFirstWork;
uniform uint smWorkCount;
uniform uint smTileCount;

double smValue(uint at)
{
  return smSchemeValues[at];
}

// Returns the tile to which `index` belongs in one of the lists that tiles share: the last tile whose part
// begins at or before it. Tiles with an empty part are skipped, because the next tile begins at the same
// index.
uint smFindTile(uint index, int list)
{
  uint low = 0u;
  uint high = smTileCount;
  while (high - low > 1u)
  {
    uint middle = (low + high) / 2u;
    if (smTiles[middle].begin[list] <= index)
    {
      low = middle;
    }
    else
    {
      high = middle;
    }
  }
  return low;
}
