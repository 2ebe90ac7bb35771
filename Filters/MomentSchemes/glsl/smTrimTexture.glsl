// The trim texture of a tile: 1 if the centre of a texel is in the face, else 0. The trim curves, cut into
// rises along which v increases or decreases (smTrimRises.h), are drawn into a texture of changes of the
// winding number: along a row of texel centres the winding number changes where a rise crosses, by +1 if v
// decreases and by -1 if it increases, as loops have the face to their left. The running sum from the left is
// the winding number, which is not 0 in the face. All numbers are integers, so that the result does not
// depend on the order of the rises.
//
// Needs: chunk smSchemeTile; double smValue(uint at), void smAddTexel(uint at, int change), int
// smGetTexel(uint at), void smSetTexel(uint at, int value).

// Returns the centre of texel `index` between the borders that begin at `borders`, with `factor` texels from
// border to border.
double smTexelCentre(uint borders, uint factor, uint index)
{
  uint interval = index / factor;
  precise double low = smValue(borders + interval);
  precise double part = (double(index - interval * factor) + 0.5LF) / double(factor);
  precise double centre = low + part * (smValue(borders + interval + 1u) - low);
  return centre;
}

// Returns the first texel of `count` intervals whose centre is at x or beyond; factor * count if there is
// none.
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

// Returns the value at x of one coordinate of a rise, less `origin`, and its derivative. The Bernstein
// coefficients are every other value from `first` on. Horner's scheme in 1 - x: B_i^n = C(n,i) x^i
// (1-x)^(n-i), and n B_i^(n-1) for the differences.
dvec2 smRiseEvaluate(uint first, int degree, double x, double origin)
{
  double y = 1.0LF - x;
  double before = smValue(first) - origin;
  precise dvec2 sum = dvec2(before, 0.0LF);
  double factor = 1.0LF;
  for (int i = 1; i <= degree; ++i)
  {
    double next = smValue(first + 2u * uint(i)) - origin;
    // n C(n-1,i-1) x^(i-1) = i C(n,i) x^(i-1).
    precise double slope = factor * double(degree - i + 1);
    factor = slope * x / double(i);
    sum.y = sum.y * y + slope * (next - before);
    sum.x = sum.x * y + factor * next;
    before = next;
  }
  return sum;
}

// Returns the parameter at which a rise from v0 to v1 has the value v, which is between them. A Newton step
// is taken if it is at most half as long as the one before and stays inside the bracket, else a bisection
// step. It ends at the level of rounding: coefficients are within |v1 - v0| of v, and a sum of up to 26 terms
// has a rounding error of a few units of that.
double smFindCrossing(uint first, int degree, double v0, double v1, double v)
{
  double low = 0.0LF;
  double high = 1.0LF;
  double x = (v - v0) / (v1 - v0);
  double last = 1.0LF;
  for (int i = 0; i < 64; ++i)
  {
    dvec2 at = smRiseEvaluate(first + 1u, degree, x, v);
    if (abs(at.x) <= 4e-15LF * abs(v1 - v0))
    {
      return x;
    }
    if ((at.x < 0.0LF) == (v0 < v1))
    {
      low = x;
    }
    else
    {
      high = x;
    }
    double step = at.y != 0.0LF ? -at.x / at.y : 1.0LF;
    if (abs(step) > 0.5LF * last || x + step <= low || x + step >= high)
    {
      step = 0.5LF * (low + high) - x;
    }
    last = abs(step);
    x += step;
  }
  return x;
}

// Draws part `index` of the tile's trim curves: one block of the rows that a rise crosses. A crossing left of
// the tile counts in its first column, a crossing right of it is omitted. The end points alone decide whether
// a row is crossed, so that rounding cannot open a loop. The polynomial itself gives the position of the
// crossing, as chords would have an error of one sign along the curve.
void smDrawTrim(smSchemeTile tile, uint index)
{
  uint at = tile.values.w + 3u * index;
  int degree = int(smValue(at));
  uint first = tile.values.w + uint(smValue(at + 1u));
  double u0 = smValue(first);
  double v0 = smValue(first + 1u);
  double u1 = smValue(first + 2u * uint(degree));
  double v1 = smValue(first + 2u * uint(degree) + 1u);
  uint factor = tile.shape.z;
  uint columns = factor * tile.grid.z;
  // A rise includes its lower end and excludes its upper one, so that rises that meet on a row count once.
  double top = max(v0, v1);
  uint row = smFindTexel(tile.values.y, tile.grid.w, factor, min(v0, v1)) + 64u * uint(smValue(at + 2u));
  uint end = min(row + 64u, factor * tile.grid.w);
  for (; row < end; ++row)
  {
    double v = smTexelCentre(tile.values.y, factor, row);
    if (v >= top)
    {
      return;
    }
    precise double u = u0 + (v - v0) / (v1 - v0) * (u1 - u0);
    if (degree > 1)
    {
      u = smRiseEvaluate(first, degree, smFindCrossing(first, degree, v0, v1, v), 0.0LF).x;
    }
    uint column = smFindTexel(tile.values.x, tile.grid.z, factor, u);
    if (column < columns)
    {
      smAddTexel(tile.texels.x + row * columns + column, v1 < v0 ? 1 : -1);
    }
  }
}

// Replaces a row of changes of the winding number by texels.
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

// Returns the number of texels of a sub-patch (column and row within the tile) that are in the face.
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
