// Each invocation adds up the lines of one item in their order and stores the item's row.
//SM::Define
layout(local_size_x = 32) in;
//SM::Include smPortable
//SM::Include smInvocation
//SM::Include smWorkStorage
//SM::Include smRowStorage
//SM::Include smLineStorage

uniform uint smFirstItem; // the items of this dispatch
uniform uint smItemCount;

// Is 1 for an item that has not converged.
layout(std430, binding = 0) writeonly buffer smStatusBuffer
{
  uint smStatus[];
};

// Index of the rounding of each integrand.
const int smRoundingOf[SM_INTEGRANDS] = int[SM_INTEGRANDS](SM_ROUNDING_OF);

// The first line of the item, which gets the sums of all of them.
uint smItemLine;

double smResult(uint k)
{
  return smLineSums[smItemLine + k * smLineStride];
}

double smNoise(uint k)
{
  return smUnitRoundoff * smLineSums[smItemLine + (smIntegrandCount + k) * smLineStride];
}

double smGetRow(uint at)
{
  return smRows[at];
}

void smSetRow(uint at, double value)
{
  smRows[at] = value;
}

void smSetStatus(uint index, bool converged)
{
  smStatus[index] = converged ? 0u : 1u;
}

//SM::Include smFinish

void main()
{
  uint index = smInvocationIndex();
  if (index >= smItemCount)
  {
    return;
  }
  uint item = smFirstItem + index;
  uvec4 shape = smFindShape(item, 1);
  uint lines = shape.w & ~smMeasuresGaps;
  smItemLine = shape.x + (item - shape.y);
  for (uint k = 0u; k < smIntegrandCount + smRoundingCount; ++k)
  {
    uint at = smItemLine + k * smLineStride;
    double sum = smLineSums[at];
    for (uint line = 1u; line < lines; ++line)
    {
      sum += smLineSums[at + line * shape.z];
    }
    smLineSums[at] = sum;
  }
  dvec3 gaps = dvec3(0.0LF);
  if ((shape.w & smMeasuresGaps) != 0u)
  {
    uint at = smItemLine + (smIntegrandCount + smRoundingCount) * smLineStride;
    for (uint line = 0u; line < lines; ++line)
    {
      double largest = smLineSums[at];
      gaps.x = largest > gaps.x || smIsNaN(largest) ? largest : gaps.x;
      gaps.y += smLineSums[at + smLineStride];
      gaps.z += smLineSums[at + 2u * smLineStride];
      at += shape.z;
    }
  }
  smWorkRecord work = smWork[item];
  bool kept = smFinish(item, work);
  smStoreGaps(work, kept, gaps);
}
