// The result rows of items on the GPU, see RowLayout. Binding 5. Needs: SM_INTEGRANDS, SM_ROUNDINGS (counts).

// Rows of smStride doubles: largest gap, squared gap, gap area, values, errors, roundings, differences.
layout(std430, binding = 5) buffer smRowBuffer
{
  double smRows[];
};

const uint smValueColumn = 3u;
const uint smErrorColumn = smValueColumn + uint(SM_INTEGRANDS);
const uint smRoundingColumn = smErrorColumn + uint(SM_INTEGRANDS);
const uint smDifferenceColumn = smRoundingColumn + uint(SM_ROUNDINGS);
const uint smStride = smDifferenceColumn + uint(SM_INTEGRANDS);
