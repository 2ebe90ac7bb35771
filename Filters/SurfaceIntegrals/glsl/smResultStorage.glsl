// Results of integration on the GPU, and their accessors. Bindings 5 and 6.
// Needs: chunk smWorkStorage; SM_INTEGRANDS, SM_ROUNDINGS, SM_ROUNDING_OF (list of integrands' columns).

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

const uint smValueColumn = 3u;
const uint smErrorColumn = smValueColumn + uint(SM_INTEGRANDS);
const uint smRoundingColumn = smErrorColumn + uint(SM_INTEGRANDS);
const uint smDifferenceColumn = smRoundingColumn + uint(SM_ROUNDINGS);
const uint smStride = smDifferenceColumn + uint(SM_INTEGRANDS);

// Index of the rounding of each integrand.
const int smRoundingOf[SM_INTEGRANDS] = int[SM_INTEGRANDS](SM_ROUNDING_OF);

// Copies of the sums of an invocation, which smFinish() indexes: if it indexed the sums themselves, drivers would keep them in memory
// during the summation.
double smResults[SM_INTEGRANDS];
double smNoises[SM_ROUNDINGS];

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
