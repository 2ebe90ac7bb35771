// Forms of one degree in (1, c): for one variant each, four forms at a time. The coefficients of the
// monomials x_a x_b ... x_e, a <= b <= ... <= e, follow each other in the order of nested loops over e, ...,
// b, a. SM_LOWER is the sum of the degree below.
layout(local_size_x = 32) in;
//SM::Define
//SM::Include smInvocation
//SM::Include smPortable

// [block of 4 forms][monomial][form]
layout(std430, binding = 1) readonly buffer smEntryBuffer
{
  dvec4 smEntries[];
};
// [direction][variant]
layout(std430, binding = 2) readonly buffer smVariableBuffer
{
  double smVariables[];
};
// [form][variant]
layout(std430, binding = 3) buffer smColumnBuffer
{
  double smColumns[];
};

uniform uint smVariantCount;
uniform uint smVariableCount; // at most 25
uniform uint smBlockCount;
uniform uint smFirstEntry; // of the matrix
uniform uint smMonomialCount;
uniform uint smFirstColumn;
// The range of the last variable e, and the first monomial that has it.
uniform uint smFirst;
uniform uint smEnd;
uniform uint smFirstMonomial;

// Each invocation has its own numbers, [variable][invocation].
shared double smNumbers[25 * 32];

uint smAt;

double smNumber(uint a)
{
  return smNumbers[32u * a + gl_LocalInvocationID.x];
}

dvec4 smSum1(uint last)
{
  dvec4 sum = dvec4(0.0LF);
  for (uint a = 0u; a <= last; ++a)
  {
    sum += smNumber(a) * smEntries[smAt];
    ++smAt;
  }
  return sum;
}

dvec4 smSum2(uint last)
{
  dvec4 sum = dvec4(0.0LF);
  for (uint a = 0u; a <= last; ++a)
  {
    sum += smNumber(a) * smSum1(a);
  }
  return sum;
}

dvec4 smSum3(uint last)
{
  dvec4 sum = dvec4(0.0LF);
  for (uint a = 0u; a <= last; ++a)
  {
    sum += smNumber(a) * smSum2(a);
  }
  return sum;
}

dvec4 smSum4(uint last)
{
  dvec4 sum = dvec4(0.0LF);
  for (uint a = 0u; a <= last; ++a)
  {
    sum += smNumber(a) * smSum3(a);
  }
  return sum;
}

void main()
{
  uint index = smInvocationIndex();
  uint block = index / smVariantCount;
  uint variant = index - block * smVariantCount;
  if (block >= smBlockCount)
  {
    return;
  }
  smNumbers[gl_LocalInvocationID.x] = 1.0LF;
  for (uint a = 1u; a < smVariableCount; ++a)
  {
    smNumbers[32u * a + gl_LocalInvocationID.x] = smVariables[(a - 1u) * smVariantCount + variant];
  }
  smAt = smFirstEntry + block * smMonomialCount + smFirstMonomial;
  dvec4 sum = dvec4(0.0LF);
  for (uint a = smFirst; a < smEnd; ++a)
  {
    sum += smNumber(a) * SM_LOWER(a);
  }
  uint to = (smFirstColumn + 4u * block) * smVariantCount + variant;
  smColumns[to] += sum.x;
  smColumns[to + smVariantCount] += sum.y;
  smColumns[to + 2u * smVariantCount] += sum.z;
  smColumns[to + 3u * smVariantCount] += sum.w;
}
