// The end of an item of integration: its sums are compared with those of a lower order and stored in its row.
//
// Needs: chunks smPortable, smWorkRecord; SM_INTEGRANDS, SM_MIN_ERROR_SHARE (smallest error as a share of the
// difference before the last one); the sums double smResult(uint k) of SM_INTEGRANDS integrands and double
// smNoise(uint k), the roundings; smRoundingOf, an array of SM_INTEGRANDS ints; columns of a row
// smValueColumn, smErrorColumn, smRoundingColumn, smDifferenceColumn, smStride; smIntegrandCount,
// smRoundingCount (the same numbers as variables); smToleranceOffset; double smParameter(uint at), double
// smGetRow(uint at), void smSetRow(uint at, double value), void smSetStatus(uint index, bool converged).

SM_CONSTANT double smLargest = 1.7976931348623157e308LF;

// Estimates the error of a value from the last two differences between orders, `difference` and, before it,
// `before` (negative: none). If differences decrease fast, the last one is far above the error. If they
// hardly decrease (area near a vanishing normal), the error is their geometric tail. A single small
// difference after a large one may be a coincidence, most likely at kinks, which a user expression may have.
double smEstimate(double difference, double before)
{
  if (before < 0.0LF)
  {
    return 10.0LF * difference;
  }
  double ratio = difference < before ? difference / before : 1.0LF;
  return max(difference * max(1.0LF, 10.0LF * ratio), SM_MIN_ERROR_SHARE * before);
}

// Stores the sums and roundings of an item that is not compared.
void smStoreFirst(uint row)
{
  for (uint k = 0u; k < smIntegrandCount; ++k)
  {
    double value = smResult(k);
    smSetRow(row + smValueColumn + k, value);
    smSetRow(row + smErrorColumn + k, abs(value) <= smLargest ? 0.0LF : abs(value));
    smSetRow(row + smDifferenceColumn + k, -1.0LF);
  }
  for (uint k = 0u; k < smRoundingCount; ++k)
  {
    smSetRow(row + smRoundingColumn + k, smNoise(k));
  }
}

// Compares the sums with the values of a lower order in the row, and stores values, errors, roundings and
// differences. Returns false if the item was discarded, to be bisected. The loops run to variables so that
// drivers do not unroll the memory accesses, which would take llvmpipe a second longer to compile.
bool smFinish(uint index, smWorkRecord work)
{
  uint row = work.item.z * smStride;
  uint tolerance = smToleranceOffset + work.item.w * uint(SM_INTEGRANDS);
  uint flags = work.detail.x >> 24;
  if ((flags & smFlagFirst) != 0u)
  {
    smStoreFirst(row);
    smSetStatus(index, true);
    return true;
  }
  bool converged = true;
  double scale = double(uintBitsToFloat(work.detail.w));
  // With two orders only, a single difference may be small by coincidence; the largest difference relative to
  // its tolerance was never below the error of any integrand (Filters/Quadrature/Bounds.md). The part of
  // differences that rounding causes is not an error of the order.
  double largest = 0.0LF;
  for (uint k = 0u; k < smIntegrandCount; ++k)
  {
    double share = scale * smParameter(tolerance + k);
    double known = smGetRow(row + smValueColumn + k);
    if (share > 0.0LF && abs(smResult(k)) <= smLargest && abs(known) <= smLargest)
    {
      double difference = abs(smResult(k) - known);
      largest = max(largest, (difference - 10.0LF * smNoise(uint(smRoundingOf[k]))) / share);
    }
  }
  for (uint k = 0u; k < smIntegrandCount; ++k)
  {
    // No order and no bisection improves a value that is NaN or infinite, so that it counts as converged,
    // with that error. It remains whatever follows: a point that a higher order or a part of the item has no
    // more is a point of the integrand.
    double known = smGetRow(row + smValueColumn + k);
    double value = abs(known) <= smLargest ? smResult(k) : known;
    bool isNumber = abs(value) <= smLargest;
    double error = isNumber ? 0.0LF : abs(value);
    double difference = -1.0LF;
    if (isNumber)
    {
      difference = abs(smResult(k) - known);
      double share = scale * smParameter(tolerance + k);
      double before = smGetRow(row + smDifferenceColumn + k);
      error = smEstimate(before < 0.0LF ? max(difference, largest * share) : difference, before);
      // Differences of the size of rounding contain no further information.
      converged = converged && !(error > share + 10.0LF * smNoise(uint(smRoundingOf[k])));
    }
    smSetRow(row + smValueColumn + k, value);
    smSetRow(row + smErrorColumn + k, error);
    smSetRow(row + smDifferenceColumn + k, difference);
  }
  for (uint k = 0u; k < smRoundingCount; ++k)
  {
    smSetRow(row + smRoundingColumn + k, smNoise(k));
  }
  bool kept = converged || (flags & smFlagDiscard) == 0u;
  if (!kept)
  {
    for (uint k = 0u; k < 3u * smIntegrandCount + smRoundingCount; ++k)
    {
      bool isNumber = abs(smGetRow(row + smValueColumn + k)) <= smLargest;
      if (isNumber || k >= 2u * smIntegrandCount)
      {
        smSetRow(row + smValueColumn + k, 0.0LF);
      }
    }
  }
  smSetStatus(index, converged);
  return kept;
}

// Stores the gaps of an item in its row, or zeros if the item was discarded.
void smStoreGaps(smWorkRecord work, bool kept, dvec3 gaps)
{
  uint row = work.item.z * smStride;
  smSetRow(row, kept ? gaps.x : 0.0LF);
  smSetRow(row + 1u, kept ? gaps.y : 0.0LF);
  smSetRow(row + 2u, kept ? gaps.z : 0.0LF);
}
