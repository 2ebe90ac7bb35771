// Lines of items: the points across an item at one node along it, or, for a driver with few lanes, at some
// nodes. A line has an invocation, so that a processor with thousands of lanes has work for all of them in
// few items. Items of one shape (kind, degrees, numbers of points) lie one after another in smWork, and so do
// their lines: the first of all items, then the second. Bindings 6 and 7. Needs: chunk smWorkStorage.

// First line and first item, number of items, number of lines of each; bit 31 of the last is set if the items
// measure gaps.
layout(std430, binding = 6) readonly buffer smShapeBuffer
{
  uvec4 smShapes[];
};
// Columns of the lines of a portion of the work: integrands, roundings, largest gap, squared gap, gap area.
// Neighbouring invocations access neighbouring numbers.
layout(std430, binding = 7) buffer smLineSumBuffer
{
  double smLineSums[];
};

uniform uint smFirstShape; // the shapes of this dispatch
uniform uint smShapeCount;
uniform uint smLineStride; // lines of the portion

const uint smMeasuresGaps = 0x80000000u;

// Returns the last shape of the dispatch whose first line (axis 0) or first item (axis 1) is at or before
// `index`.
uvec4 smFindShape(uint index, int axis)
{
  uint low = smFirstShape;
  uint high = smFirstShape + smShapeCount;
  while (high - low > 1u)
  {
    uint middle = (low + high) / 2u;
    if (smShapes[middle][axis] <= index)
    {
      low = middle;
    }
    else
    {
      high = middle;
    }
  }
  return smShapes[low];
}
