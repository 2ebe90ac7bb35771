// Moments and gradients of a variant one after another, as they are read back. A moment has one form, its
// value; or, with gradients, a form for each variable (1, c): its derivative, of which Euler's identity gives
// the value times the degree, the divisor being the host's.
layout(local_size_x = 32) in;
//SM::Define
//SM::Include smInvocation
//SM::Include smPortable

// [direction][variant]
layout(std430, binding = 2) readonly buffer smVariableBuffer
{
  double smVariables[];
};
// [form][variant]
layout(std430, binding = 3) readonly buffer smColumnBuffer
{
  double smColumns[];
};
// [variant][moment]
layout(std430, binding = 4) writeonly buffer smValueBuffer
{
  double smValues[];
};
// [variant][moment][direction]
layout(std430, binding = 5) writeonly buffer smGradientBuffer
{
  double smGradients[];
};

uniform uint smVariantCount;
uniform uint smFormCount; // of a moment: 1, or the number of variables
// First forms of the first and of the second moments.
uniform uint smFirstColumn;
uniform uint smSecondColumn;

void main()
{
  uint variant = smInvocationIndex();
  if (variant >= smVariantCount)
  {
    return;
  }
  for (uint moment = 0u; moment < 10u; ++moment)
  {
    uint column = moment == 0u ? 0u
      : moment < 4u            ? smFirstColumn + (moment - 1u) * smFormCount
                               : smSecondColumn + (moment - 4u) * smFormCount;
    double value = smColumns[column * smVariantCount + variant];
    for (uint a = 1u; a < smFormCount; ++a)
    {
      double derivative = smColumns[(column + a) * smVariantCount + variant];
      value += smVariables[(a - 1u) * smVariantCount + variant] * derivative;
      smGradients[(10u * variant + moment) * (smFormCount - 1u) + a - 1u] = derivative;
    }
    smValues[10u * variant + moment] = value;
  }
}
