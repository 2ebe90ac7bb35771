// Work lists, rules and tolerances of integration on the GPU, see smGPUItemRunner, and the accessors that the
// shader chunks use. Bindings 3 and 4.
//SM::Include smWorkRecord

layout(std430, binding = 3) readonly buffer smWorkBuffer
{
  smWorkRecord smWork[];
};
// Gauss-Legendre rules on [0,1] (node, weight), rule of n points at n (n-1); then per face SM_INTEGRANDS
// tolerances of one item; then per face three rows of the placement.
layout(std430, binding = 4) readonly buffer smParameterBuffer
{
  double smParameters[];
};
uniform uint smToleranceOffset;
uniform uint smPlacementOffset;
uniform uint smIntegrandCount; // SM_INTEGRANDS
uniform uint smRoundingCount;  // SM_ROUNDINGS

double smParameter(uint at)
{
  return smParameters[at];
}
