// Adds up the parts of faces. An invocation has one integrand of one face, or the gaps of it
// (ItemRunner::AddUp).
//SM::Define
layout(local_size_x = 32) in;
//SM::Include smInvocation
//SM::Include smPortable
//SM::Include smErrorFree
//SM::Include smRowStorage
//SM::Include smBlockStorage

// Number of the first part of each face, and of the part behind the last face.
layout(std430, binding = 3) readonly buffer smFaceBuffer
{
  uint smFaces[];
};
// First block and number of blocks; 0 for panels, 1 for ribbons and caps, 2 for ribbons of one coedge; index
// of the gaps of a coedge.
layout(std430, binding = 4) readonly buffer smPartBuffer
{
  uvec4 smParts[];
};
// Index of the rounding of each integrand.
const int smRoundingOf[SM_INTEGRANDS] = int[SM_INTEGRANDS](SM_ROUNDING_OF);

// For each face and integrand the sum of panels, that of ribbons and caps, errors, roundings; for each face
// largest gap, squared gap, gap area; then for each part of a coedge its gaps.
layout(std430, binding = 6) writeonly buffer smTotalBuffer
{
  double smTotals[];
};

uniform uint smFaceCount;

// Returns the sum of a column over the blocks of a part; column 0: the largest value.
double smSumPart(uvec4 part, uint column)
{
  uint at = 2u * (part.x * smBlockColumns + column);
  precise double sum = smBlockSums[at];
  precise double error = smBlockSums[at + 1u];
  for (uint block = 1u; block < part.y; ++block)
  {
    at += 2u * smBlockColumns;
    double value = smBlockSums[at];
    if (column == 0u)
    {
      sum = value > sum || smIsNaN(value) ? value : sum;
    }
    else
    {
      dvec2 next = smTwoSum(sum, value);
      sum = next.x;
      error += next.y;
      error += smBlockSums[at + 1u];
    }
  }
  // After an overflow the error is NaN, and the value alone is the result.
  double largest = 1.7976931348623157e308LF;
  return abs(sum) <= largest ? sum + error : sum;
}

void main()
{
  uint index = smInvocationIndex();
  uint integrands = uint(SM_INTEGRANDS);
  uint face = index / (integrands + 1u);
  uint k = index - face * (integrands + 1u);
  if (face >= smFaceCount)
  {
    return;
  }
  uint to = face * (4u * integrands + 3u) + 4u * k;
  uint first = smFaces[face];
  uint end = smFaces[face + 1u];
  if (k < integrands)
  {
    double faceValue = 0.0LF;
    double chainValue = 0.0LF;
    double error = 0.0LF;
    double rounding = 0.0LF;
    for (uint i = first; i < end; ++i)
    {
      uvec4 part = smParts[i];
      bool isPanels = part.z == 0u;
      double before = isPanels ? faceValue : chainValue;
      double after = before + smSumPart(part, smValueColumn + k);
      rounding += before != 0.0LF ? SM_UNIT_ROUNDOFF * abs(after) : 0.0LF;
      faceValue = isPanels ? after : faceValue;
      chainValue = isPanels ? chainValue : after;
      error += smSumPart(part, smErrorColumn + k);
      rounding += smSumPart(part, smRoundingColumn + uint(smRoundingOf[k]));
    }
    smTotals[to] = faceValue;
    smTotals[to + 1u] = chainValue;
    smTotals[to + 2u] = error;
    smTotals[to + 3u] = rounding;
    return;
  }
  dvec3 all = dvec3(0.0LF);
  for (uint i = first; i < end; ++i)
  {
    uvec4 part = smParts[i];
    dvec3 gaps = dvec3(smSumPart(part, 0u), smSumPart(part, 1u), smSumPart(part, 2u));
    all.x = gaps.x > all.x || smIsNaN(gaps.x) ? gaps.x : all.x;
    all.y += gaps.y;
    all.z += gaps.z;
    if (part.z > 1u)
    {
      uint at = smFaceCount * (4u * integrands + 3u) + 3u * part.w;
      smTotals[at] = gaps.x;
      smTotals[at + 1u] = gaps.y;
      smTotals[at + 2u] = gaps.z;
    }
  }
  smTotals[to] = all.x;
  smTotals[to + 1u] = all.y;
  smTotals[to + 2u] = all.z;
}
