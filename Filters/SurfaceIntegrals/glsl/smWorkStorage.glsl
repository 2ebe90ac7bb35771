// Work lists, rules, tolerances and results of integration on the GPU, see smGPUItemRunner, and the accessors that the shader
// chunks use. Bindings 3 to 6.
// Needs: SM_INTEGRANDS, SM_ROUNDINGS (counts), SM_ROUNDING_OF (list of integrands' columns).
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
// Result rows of smStride doubles: largest gap, squared gap, gap area, values, errors, roundings, differences.
layout(std430, binding = 5) buffer smRowBuffer
{
  double smRows[];
};
// Element 0 counts the evaluations; element 1 + index is 1 if that item has not converged.
layout(std430, binding = 6) buffer smStatusBuffer
{
  uint smStatus[];
};

uniform uint smFirstWork;
uniform uint smWorkCount;
uniform uint smToleranceOffset;
uniform uint smPlacementOffset;
uniform uint smIntegrandCount; // SM_INTEGRANDS
uniform uint smRoundingCount;  // SM_ROUNDINGS

const uint smValueColumn = 3u;
const uint smErrorColumn = smValueColumn + uint(SM_INTEGRANDS);
const uint smRoundingColumn = smErrorColumn + uint(SM_INTEGRANDS);
const uint smDifferenceColumn = smRoundingColumn + uint(SM_ROUNDINGS);
const uint smStride = smDifferenceColumn + uint(SM_INTEGRANDS);

// Index of the rounding of each integrand.
const int smRoundingOf[SM_INTEGRANDS] = int[SM_INTEGRANDS](SM_ROUNDING_OF);

// Sums of an invocation, and their copies, which smFinish() indexes: if it indexed the sums themselves, drivers would keep them
// in memory during the summation.
double smValues[SM_INTEGRANDS];
double smRoundings[SM_ROUNDINGS];
double smResults[SM_INTEGRANDS];
double smNoises[SM_ROUNDINGS];

double smParameter(uint at)
{
  return smParameters[at];
}

double smGetRow(uint at)
{
  return smRows[at];
}

void smSetRow(uint at, double value)
{
  smRows[at] = value;
}

void smSetStatus(uint index, bool converged)
{
  smStatus[1u + index] = converged ? 0u : 1u;
}

void smCountEvaluations(uint count)
{
  atomicAdd(smStatus[0], count);
}
