// The trim texture of a tile: 1 where a texel's centre is in the face, else 0. The polygons' chords are drawn into a
// texture of changes of the winding number: along a row of texel centres it changes by 1 where a chord crosses, by +1 where the
// chord goes down, for loops have the face to their left. A running sum from the left is the winding number; it is not 0 in the
// face. Integers only, so chords may be drawn in any order.
//
// Needs: chunk smSchemeTile; double smValue(uint at), void smAddTexel(uint at, int change), int smGetTexel(uint at),
// void smSetTexel(uint at, int value).

// Centre of texel `index` between the borders from `borders` on, `factor` texels from border to border.
double smTexelCentre(uint borders, uint factor, uint index)
{
  uint interval = index / factor;
  precise double low = smValue(borders + interval);
  precise double part = (double(index - interval * factor) + 0.5LF) / double(factor);
  precise double centre = low + part * (smValue(borders + interval + 1u) - low);
  return centre;
}

// The first texel of `count` intervals whose centre is at x or beyond; factor * count when none is.
uint smFindTexel(uint borders, uint count, uint factor, double x)
{
  uint low = 0u;
  uint high = factor * count;
  while (low < high)
  {
    uint middle = (low + high) / 2u;
    if (smTexelCentre(borders, factor, middle) >= x)
    {
      high = middle;
    }
    else
    {
      low = middle + 1u;
    }
  }
  return low;
}

// Draws chord `index` of the tile: a crossing left of the tile counts from its first column on, one right of it not at all.
void smDrawChord(smSchemeTile tile, uint index)
{
  uint at = tile.values.w + 4u * index;
  double u0 = smValue(at);
  double v0 = smValue(at + 1u);
  double u1 = smValue(at + 2u);
  double v1 = smValue(at + 3u);
  uint factor = tile.shape.z;
  uint columns = factor * tile.grid.z;
  uint rows = factor * tile.grid.w;
  // A chord has its lower end and not its upper one, so that chords that meet on a row count once.
  double top = max(v0, v1);
  for (uint row = smFindTexel(tile.values.y, tile.grid.w, factor, min(v0, v1)); row < rows; ++row)
  {
    double v = smTexelCentre(tile.values.y, factor, row);
    if (v >= top)
    {
      return;
    }
    precise double u = u0 + (v - v0) / (v1 - v0) * (u1 - u0);
    uint column = smFindTexel(tile.values.x, tile.grid.z, factor, u);
    if (column < columns)
    {
      smAddTexel(tile.texels.x + row * columns + column, v1 < v0 ? 1 : -1);
    }
  }
}

// Turns a row of changes into texels.
void smSweepTexels(smSchemeTile tile, uint row)
{
  uint columns = tile.shape.z * tile.grid.z;
  uint at = tile.texels.x + row * columns;
  int winding = 0;
  for (uint column = 0u; column < columns; ++column)
  {
    winding += smGetTexel(at + column);
    smSetTexel(at + column, winding != 0 ? 1 : 0);
  }
}

// Texels of a sub-patch (column and row within the tile) that are in the face.
uint smCountTexels(smSchemeTile tile, uint column, uint row)
{
  uint factor = tile.shape.z;
  uint columns = factor * tile.grid.z;
  uint count = 0u;
  for (uint j = 0u; j < factor; ++j)
  {
    uint at = tile.texels.x + (row * factor + j) * columns + column * factor;
    for (uint i = 0u; i < factor; ++i)
    {
      count += smGetTexel(at + i) != 0 ? 1u : 0u;
    }
  }
  return count;
}
