// Work lists, rules, tolerances and results of integration, see smSurfaceIntegrator. Bindings 3 to 7.
// Needs: SM_INTEGRANDS, SM_ROUNDINGS (counts), chunk smInvocation.

struct smWorkRecord
{
  uvec4 item;   // patch, first trim coefficient, row of the result, face
  uvec4 detail; // trim degree | points in t << 8 | points across << 16 | flags << 24, first edge coefficient, edge degree, bits of the float that scales the tolerance
  dvec4 range;  // panel: t start, t end, xi start, xi end; ribbon: t start, t end, edge start, edge end
};

const uint smFlagNegative = 1u;  // coverage counts negatively
const uint smFlagFlip = 2u;      // outward normal is the other way
const uint smFlagFirst = 4u;     // nothing to compare with: the row holds no result of a lower order
const uint smFlagDiscard = 8u;   // not converged: leave zeros, the item is bisected
const uint smFlagAlongEdge = 16u; // the ribbon's width is the gap to the edge

layout(std430, binding = 3) readonly buffer smWorkBuffer
{
  smWorkRecord smWork[];
};
// Gauss-Legendre rules on [0,1] (node, weight), rule of n points at n (n-1) / 2; then per face SM_INTEGRANDS
// tolerances of one item; then per face three rows of the placement.
layout(std430, binding = 4) readonly buffer smParameterBuffer
{
  double smParameters[];
};
// Result rows of SM_STRIDE doubles: largest gap, squared gap, gap area, values, errors, roundings, differences.
layout(std430, binding = 5) buffer smRowBuffer
{
  double smRows[];
};
// [0] evaluations, counted; [1 + index] 1 when that item has not converged.
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
const uint SM_STRIDE = smDifferenceColumn + uint(SM_INTEGRANDS);

// u: half the spacing of doubles at 1.
const double smUnitRoundoff = 1.1102230246251565e-16LF;

const double smLargest = 1.7976931348623157e308LF;

dvec2 smRule(int count, int index)
{
  uint at = uint(count * (count - 1) + 2 * index);
  return dvec2(smParameters[at], smParameters[at + 1u]);
}

// The roundings class of each integrand.
const int smRoundingOf[SM_INTEGRANDS] = int[SM_INTEGRANDS](SM_ROUNDING_OF);

void smClear(out double values[SM_INTEGRANDS], out double roundings[SM_ROUNDINGS])
{
  for (int k = 0; k < SM_INTEGRANDS; ++k)
  {
    values[k] = 0.0LF;
  }
  for (int k = 0; k < SM_ROUNDINGS; ++k)
  {
    roundings[k] = 0.0LF;
  }
}

// The error of a value whose last order changed it by `difference` and the one before by `before` (negative: there was
// none). Where differences fall fast, the last one is far above the error; where they hardly fall (area near a
// vanishing normal) the error is a geometric tail of them; and one small difference after a large one may be luck.
double smEstimate(double difference, double before)
{
  if (before < 0.0LF)
  {
    return 10.0LF * difference;
  }
  double ratio = difference < before ? difference / before : 1.0LF;
  return max(difference * max(1.0LF, 10.0LF * ratio), 1e-3LF * before);
}

// Compares with the row's values of a lower order, stores values, errors, roundings and differences. False when the
// item was discarded, to be bisected. The loops run to uniforms, so that drivers do not unroll the memory accesses:
// llvmpipe would take a second longer to compile.
bool smFinish(uint index, smWorkRecord work, double values[SM_INTEGRANDS], double roundings[SM_ROUNDINGS])
{
  double results[SM_INTEGRANDS];
  double noises[SM_ROUNDINGS];
  for (int k = 0; k < SM_INTEGRANDS; ++k)
  {
    results[k] = values[k];
  }
  for (int k = 0; k < SM_ROUNDINGS; ++k)
  {
    noises[k] = smUnitRoundoff * roundings[k];
  }
  uint row = work.item.z * SM_STRIDE;
  uint tolerance = smToleranceOffset + work.item.w * uint(SM_INTEGRANDS);
  uint flags = work.detail.x >> 24;
  bool isFirst = (flags & smFlagFirst) != 0u;
  bool converged = true;
  double scale = double(uintBitsToFloat(work.detail.w));
  for (uint k = 0u; k < smIntegrandCount; ++k)
  {
    // Not a number, or infinite: no order and no bisection will mend it, so it counts as converged, with that error.
    bool isNumber = abs(results[k]) <= smLargest;
    double error = isNumber ? 0.0LF : abs(results[k]);
    double difference = -1.0LF;
    if (!isFirst && isNumber)
    {
      difference = abs(results[k] - smRows[row + smValueColumn + k]);
      error = smEstimate(difference, smRows[row + smDifferenceColumn + k]);
      // Differences of the size of rounding say nothing more.
      converged = converged &&
        !(error > scale * smParameters[tolerance + k] + 10.0LF * noises[smRoundingOf[k]]);
    }
    smRows[row + smValueColumn + k] = results[k];
    smRows[row + smErrorColumn + k] = error;
    smRows[row + smDifferenceColumn + k] = difference;
  }
  for (uint k = 0u; k < smRoundingCount; ++k)
  {
    smRows[row + smRoundingColumn + k] = noises[k];
  }
  bool kept = converged || (flags & smFlagDiscard) == 0u;
  if (!kept)
  {
    for (uint k = 0u; k < 3u * smIntegrandCount + smRoundingCount; ++k)
    {
      smRows[row + smValueColumn + k] = 0.0LF;
    }
  }
  smStatus[1u + index] = converged ? 0u : 1u;
  return kept;
}

#ifdef SM_PLACEMENT
void smPlace(uint face, inout dvec3 position, inout dvec3 normal)
{
  dvec3 placedPosition;
  dvec3 placedNormal;
  for (int i = 0; i < 3; ++i)
  {
    uint at = smPlacementOffset + face * 12u + uint(4 * i);
    dvec3 row = dvec3(smParameters[at], smParameters[at + 1u], smParameters[at + 2u]);
    placedPosition[i] = dot(row, position) + smParameters[at + 3u];
    placedNormal[i] = dot(row, normal);
  }
  position = placedPosition;
  normal = placedNormal;
}
#else
void smPlace(uint face, inout dvec3 position, inout dvec3 normal) {}
#endif
