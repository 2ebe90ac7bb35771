// Reduces the nets of patches to curves in s, at the r of each line. One invocation has a point of such a
// curve.
layout(local_size_x = 64) in;
//SM::Define
//SM::Include smInvocation
//SM::Include smGradientStorage

// [row][point, its derivative in s, in r]
layout(std430, binding = 3) writeonly buffer smRowBuffer
{
  dvec4 smRows[];
};

void main()
{
  uint row = smInvocationIndex();
  if (row >= smCount)
  {
    return;
  }
  uint line = smWords[smFirstEntry + row];
  uint i = row - smLineWord(line, 4u);
  uint patchIndex = smLineWord(line, 0u);
  uint p = smPatchWord(patchIndex, 0u);
  uint q = smPatchWord(patchIndex, 1u);
  uint basis = smLineWord(line, 1u) + smLineNumbers;
  uint at = smPatchWord(patchIndex, 2u) + i;
  dvec4 value = dvec4(0.0LF);
  dvec4 inS = dvec4(0.0LF);
  dvec4 inR = dvec4(0.0LF);
  for (uint j = 0u; j <= q; ++j)
  {
    dvec4 point = smNets[at];
    double b = smNumbers[basis + j];
    value += b * point;
    // Differences come first: the rounding of a derivative is relative to them.
    if (i < p)
    {
      inS += double(p) * (b * (smNets[at + 1u] - point));
    }
    at += p + 1u;
    if (j < q)
    {
      inR += double(q) * (smNumbers[basis + q + 1u + j] * (smNets[at] - point));
    }
  }
  smRows[3u * row] = smStored(value);
  smRows[3u * row + 1u] = inS;
  smRows[3u * row + 2u] = inR;
}
