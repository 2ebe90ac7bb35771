// Adds the lines of a patch, times one polynomial in r. One invocation has a control point of a patch and
// four of its integrals, or the noise of the area.
layout(local_size_x = 64) in;
//SM::Define
//SM::Include smInvocation
//SM::Include smGradientStorage

// [row][fours]
layout(std430, binding = 4) readonly buffer smLineSumBuffer
{
  dvec4 smLineSums[];
};
// [control point][fours, then the noise of the area at the first one of a patch]
layout(std430, binding = 5) writeonly buffer smSumBuffer
{
  dvec4 smSums[];
};

void main()
{
  uint index = smInvocationIndex();
  if (index >= smCount)
  {
    return;
  }
  uint entry = index / (smFours + 1u);
  uint four = index % (smFours + 1u);
  uint patchIndex = smWords[smFirstEntry + entry];
  uint p = smPatchWord(patchIndex, 0u);
  uint q = smPatchWord(patchIndex, 1u);
  uint point = entry - smPatchWord(patchIndex, 6u);
  uint i = point % (p + 1u);
  uint j = point / (p + 1u);
  uint line = smPatchWord(patchIndex, 4u);
  uint end = line + smPatchWord(patchIndex, 5u);
  if (four == smFours && point > 0u)
  {
    end = line;
  }
  dvec4 sum = dvec4(0.0LF);
  for (; line < end; ++line)
  {
    uint basis = smLineWord(line, 1u) + smLineNumbers;
    uint from = smRowFours * (smLineWord(line, 4u) + i);
    double value = smNumbers[basis + j];
    if (four == smFours)
    {
      sum += smLineSums[from + 13u];
    }
    else if (four == 11u)
    {
      sum += abs(value) * smLineSums[from + 11u];
    }
    else
    {
      sum += value * smLineSums[from + four];
    }
    if (four == 10u)
    {
      sum += smNumbers[basis + 2u * (q + 1u) + j] * smLineSums[from + 12u];
    }
  }
  smSums[index] = smStored(sum);
}
