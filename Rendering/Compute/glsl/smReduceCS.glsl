// One level of sm::Reduction: each invocation reduces one column of one block of consecutive rows, in order.
layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer smInput
{
  double inputs[];
};
// First row and number of rows.
layout(std430, binding = 1) readonly buffer smBlocks
{
  uvec2 blocks[];
};
// Pairs (value, rounding error), one row per block.
layout(std430, binding = 2) writeonly buffer smOutput
{
  double outputs[];
};

uniform uint smOperation;   // 0 sum, 1 minimum, 2 maximum
uniform uint smColumns;
uniform uint smFirstBlock;  // of this dispatch
uniform uint smBlockCount;
uniform uint smStride;      // doubles from row to row of the input
uniform uint smPaired;      // 1: the input consists of pairs, 0: of single values
uniform uint smFirstRow;    // row at inputs[smInputStart]
uniform uint smInputStart;
uniform uint smOutputStart; // where the first block of this dispatch writes

//SM::Include smInvocation
//SM::Include smPortable
//SM::Include smErrorFree

dvec2 smSum(uint at, uint count)
{
  precise double sum = inputs[at];
  precise double error = smPaired != 0u ? inputs[at + 1u] : 0.0LF;
  for (uint i = 1u; i < count; ++i)
  {
    at += smStride;
    dvec2 next = smTwoSum(sum, inputs[at]);
    sum = next.x;
    error += next.y;
    if (smPaired != 0u)
    {
      error += inputs[at + 1u];
    }
  }
  return dvec2(sum, error);
}

// A NaN remains the result, because every comparison with it is false.
double smMinimum(uint at, uint count)
{
  double best = inputs[at];
  for (uint i = 1u; i < count; ++i)
  {
    at += smStride;
    double value = inputs[at];
    best = value < best || smIsNaN(value) ? value : best;
  }
  return best;
}

double smMaximum(uint at, uint count)
{
  double best = inputs[at];
  for (uint i = 1u; i < count; ++i)
  {
    at += smStride;
    double value = inputs[at];
    best = value > best || smIsNaN(value) ? value : best;
  }
  return best;
}

void main()
{
  uint index = smInvocationIndex();
  if (index >= smBlockCount * smColumns)
  {
    return;
  }
  // Neighbouring invocations read neighbouring columns.
  uint block = index / smColumns;
  uint column = index - block * smColumns;
  uvec2 rows = blocks[smFirstBlock + block];
  uint at = smInputStart + (rows.x - smFirstRow) * smStride + column * (1u + smPaired);
  dvec2 result = smOperation == 0u
    ? smSum(at, rows.y)
    : dvec2(smOperation == 1u ? smMinimum(at, rows.y) : smMaximum(at, rows.y), 0.0LF);
  uint to = smOutputStart + 2u * index;
  outputs[to] = result.x;
  outputs[to + 1u] = result.y;
}
