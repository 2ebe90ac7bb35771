// Each invocation adds up one column of a block of consecutive rows, in their order; of the first column it
// takes the largest. The rounding errors of the additions are added up, too (Ogita, Rump, Oishi 2005,
// algorithm 4.4).
//SM::Define
layout(local_size_x = 64) in;
//SM::Include smInvocation
//SM::Include smPortable
//SM::Include smErrorFree
//SM::Include smRowStorage
//SM::Include smBlockStorage

// First row and number of rows.
layout(std430, binding = 6) readonly buffer smBlockBuffer
{
  uvec2 smBlocks[];
};

uniform uint smFirstBlock; // the blocks of this dispatch
uniform uint smBlockCount;

void main()
{
  uint index = smInvocationIndex();
  if (index >= smBlockCount * smBlockColumns)
  {
    return;
  }
  uint block = index / smBlockColumns;
  uint column = index - block * smBlockColumns;
  block += smFirstBlock;
  uvec2 rows = smBlocks[block];
  uint at = rows.x * smStride + column;
  precise double sum = smRows[at];
  precise double error = 0.0LF;
  for (uint row = 1u; row < rows.y; ++row)
  {
    at += smStride;
    double value = smRows[at];
    if (column == 0u)
    {
      // A NaN remains the largest, because every comparison with it is false.
      sum = value > sum || smIsNaN(value) ? value : sum;
    }
    else
    {
      dvec2 next = smTwoSum(sum, value);
      sum = next.x;
      error += next.y;
    }
  }
  uint to = 2u * (block * smBlockColumns + column);
  smBlockSums[to] = sum;
  smBlockSums[to + 1u] = error;
}
