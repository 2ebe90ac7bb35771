// Ten results of a variant one after another, as they are read back: sums with their carries, or bounds.
layout(local_size_x = 32) in;
//SM::Define
//SM::Include smInvocation
//SM::Include smPortable

// [moment, then carries][variant]
layout(std430, binding = 3) readonly buffer smSumBuffer
{
  double smSums[];
};
// [variant][moment]
layout(std430, binding = 5) writeonly buffer smResultBuffer
{
  double smResults[];
};

uniform uint smVariantCount;
uniform uint smHasCarries;

void main()
{
  uint variant = smInvocationIndex();
  if (variant >= smVariantCount)
  {
    return;
  }
  for (uint moment = 0u; moment < 10u; ++moment)
  {
    double value = smSums[moment * smVariantCount + variant];
    if (smHasCarries != 0u)
    {
      value += smSums[(10u + moment) * smVariantCount + variant];
    }
    smResults[10u * variant + moment] = value;
  }
}
