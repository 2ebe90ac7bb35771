// Sums of blocks of rows and their rounding errors. Binding 7. Needs: chunk smRowStorage.
layout(std430, binding = 7) buffer smBlockSumBuffer
{
  double smBlockSums[];
};

// The columns of a row that are added up: all but the differences.
const uint smBlockColumns = smDifferenceColumn;
