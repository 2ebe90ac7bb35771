// Adds up samples of one ribbon X(l,t) = (1-l) A(t) + l C(t), or of some lines of it, where A = S(c(t)) is on
// the face and C is the edge's curve, with SM_STRIP_POINTS Gauss points in l, which are exact for the
// polynomial integrands. It also measures the gap at foot points on the edge's curve.
//
// Needs: as smPanel, with smAccumulateChain in place of smAccumulateFace; SM_STRIP_POINTS; smGapSteps, the
// number of steps to the foot point of a gap (not a constant, so that the compiler does not unroll the loop).

// Returns a bound of the second derivative of an edge piece on [0,1]: n (n-1) times the largest second
// difference of coefficients.
double smEdgeBend(uint edge, int degree)
{
  double largest = 0.0LF;
  for (int i = 0; i + 2 <= degree; ++i)
  {
    uint at = edge + 3u * uint(i);
    dvec3 first = dvec3(smCoefficient(at), smCoefficient(at + 1u), smCoefficient(at + 2u));
    dvec3 middle = dvec3(smCoefficient(at + 3u), smCoefficient(at + 4u), smCoefficient(at + 5u));
    dvec3 last = dvec3(smCoefficient(at + 6u), smCoefficient(at + 7u), smCoefficient(at + 8u));
    dvec3 difference = (last - middle) - (middle - first);
    largest = max(largest, dot(difference, difference));
  }
  return double(degree * (degree - 1)) * sqrt(largest);
}

// Returns the distance of a point, relative to `origin`, from the edge piece near parameter x, where the
// piece and its derivative are `foot` and `tangent`: Gauss-Newton steps for (C - A).C' = 0, while one moves
// the foot by more than a thousandth of the distance, which then is off by less than a millionth. Where the
// edge, whose second derivative is at most `bend`, leaves its tangent on the way to the foot by no more than
// that, or than rounding, the distance is that of the tangent.
double smGap(
  uint edge, int degree, double bend, double x, dvec3 origin, dvec3 point, dvec3 foot, dvec3 tangent)
{
  dvec3 gap = foot - point;
  double best = length(gap);
  for (int i = 0; i < smGapSteps; ++i)
  {
    double squared = dot(tangent, tangent);
    double along = dot(gap, tangent);
    double excess = along * along - 1e-6LF * squared * dot(gap, gap);
    if (!SM_ANY(excess > 0.0LF))
    {
      break;
    }
    double step = SM_SELECT(excess > 0.0LF, along / squared, 0.0LF);
    double straight = length(gap - step * tangent);
    double off = 0.5LF * bend * step * step - 1e-6LF * straight - smUnitRoundoff * length(foot);
    // Slightly beyond the piece, its polynomial still approximates the curve.
    double next = clamp(x - step, -0.25LF, 1.25LF);
    double far = max(off, abs(next - (x - step)));
    best = min(best, SM_SELECT(far > 0.0LF, best, straight));
    if (!SM_ANY(far > 0.0LF))
    {
      break;
    }
    x = SM_SELECT(far > 0.0LF, next, x);
    smEdgeEvaluate(edge, degree, x, origin, foot, tangent);
    gap = foot - point;
    best = min(best, length(gap));
  }
  return best;
}

// Integrates the lines [first, end) of a ribbon: the points in l at one node in t. `gaps` receives the
// largest gap and the integrals of its square and of itself. Returns the number of evaluations.
uint smIntegrateRibbon(smWorkRecord work, int first, int end, SM_OUT(dvec3) gaps)
{
  smPatchRecord patchRecord = smGetPatch(work.item.x);
  int p = SM_DEGREE_S;
  int q = SM_DEGREE_R;
  dvec3 center = dvec3(patchRecord.centerRadius.x, patchRecord.centerRadius.y, patchRecord.centerRadius.z);
  double radius = patchRecord.centerRadius.w;
  dvec2 start = dvec2(patchRecord.domain.x, patchRecord.domain.y);
  dvec2 width = dvec2(patchRecord.domain.z, patchRecord.domain.w);

  int trimDegree = int(work.detail.x & 255u);
  int countT = smGetNodes(work);
  uint flags = work.detail.x >> 24;
  uint edge = work.detail.y;
  int edgeDegree = int(work.detail.z);
  double side = (flags & smFlagFlip) != 0u ? -1.0LF : 1.0LF;
  bool alongEdge = (flags & smFlagAlongEdge) != 0u;

  double largestGap = 0.0LF;
  double squaredGap = 0.0LF;
  double gapArea = 0.0LF;

  double bend = 0.0LF;
  if (alongEdge)
  {
    bend = smEdgeBend(edge, edgeDegree);
  }

  double tWidth = work.range.y - work.range.x;
  double edgeWidth = work.range.w - work.range.z;
  for (int it = first; it < end; ++it)
  {
    dvec2 ruleT = smRule(countT, it);
    double t = work.range.x + tWidth * ruleT.x;
    double e = work.range.z + edgeWidth * ruleT.x;
    dvec2 uv;
    dvec2 duv;
    dvec2 reach;
    smTrimEvaluate(work.item.y, trimDegree, t, start, uv, duv, reach);
    uv = uv / width;
    duv = duv * tWidth / width;

    SM_VECTORS(row, SM_ROW_SIZE);
    SM_VECTORS(rowS, SM_ROW_SIZE);
    SM_VECTORS(rowR, SM_ROW_SIZE);
    smCollapse(patchRecord.shape.x, p, q, uv.y, row, rowS, rowR);
    // Both curves are relative to the patch's centre, so that the rounding of their difference is relative to
    // the patch.
    dvec3 a;
    dvec3 tangentS;
    dvec3 tangentR;
    smEvaluateRow(p, uv.x, row, rowS, rowR, a, tangentS, tangentR);
    dvec3 da = duv.x * tangentS + duv.y * tangentR;
    dvec3 c;
    dvec3 dc;
    smEdgeEvaluate(edge, edgeDegree, e, center, c, dc);
    if (alongEdge)
    {
      double distance = smGap(edge, edgeDegree, bend, e, center, a, c, dc);
      double arc = ruleT.y * length(da);
      largestGap = max(largestGap, distance);
      squaredGap += arc * distance * distance;
      gapArea += arc * distance;
    }
    dc *= edgeWidth;

    // Estimates, by measured constants, of the rounding of both curves, including that of the trim curve, and
    // of their derivatives.
    double gapWidth = length(c - a);
    double positionNoise = 4.0LF * (radius + length(c)) +
      smTrimRoundings *
        (max(1.0LF, reach.x / width.x) * length(tangentS) + max(1.0LF, reach.y / width.y) * length(tangentR));
    double slopeNoise = 8.0LF *
      (min(patchRecord.stretch.x, length(tangentS) + 2.0LF * double(p) * radius) * abs(duv.x) +
        min(patchRecord.stretch.y, length(tangentR) + 2.0LF * double(q) * radius) * abs(duv.y));
    for (int il = 0; il < SM_STRIP_POINTS; ++il)
    {
      dvec2 ruleL = smRule(SM_STRIP_POINTS, il);
      double l = ruleL.x;
      dvec3 position = center + (1.0LF - l) * a + l * c;
      dvec3 along = (1.0LF - l) * da + l * dc;
      dvec3 normal = side * cross(c - a, along);
      double noise =
        ruleT.y * ruleL.y * ((positionNoise + 8.0LF * gapWidth) * length(along) + gapWidth * slopeNoise);
      double weight = SM_PERTURBATION * ruleT.y * ruleL.y;
      smPlace(work.item.w, position, normal);
      smAccumulateChain(weight, noise, position, normal);
    }
  }
  gaps = dvec3(largestGap, squaredGap, gapArea);
  return uint(end - first);
}
