// Integrates one ribbon X(l,t) = (1-l) A(t) + l C(t) per invocation, A = S(c(t)) on the face, C the edge's curve:
// SM_STRIP_POINTS Gauss points in l, exact for the polynomial integrands asked for. Measures the gap at foot points on the edge's curve.
//SM::Define
layout(local_size_x = 32) in;
//SM::Include smPortable
//SM::Include smInvocation
//SM::Include smResident
//SM::Include smBernstein
//SM::Include smPatch
//SM::Include smWork

// Steps to the foot point of a gap; a uniform, so that the loop stays one.
uniform int smGapSteps;

// Distance of a point from the edge piece near parameter x: Gauss-Newton steps for (C - A).C' = 0.
double smGap(uint edge, int degree, double x, dvec3 point)
{
  double best = 0.0LF;
  for (int i = 0; i <= smGapSteps; ++i)
  {
    dvec3 foot;
    dvec3 tangent;
    smEdgeEvaluate(edge, degree, x, foot, tangent);
    dvec3 gap = foot - point;
    best = i == 0 ? length(gap) : min(best, length(gap));
    double squared = dot(tangent, tangent);
    x -= squared > 0.0LF ? dot(gap, tangent) / squared : 0.0LF;
    // A little beyond the piece its polynomial still is the curve.
    x = clamp(x, -0.25LF, 1.25LF);
  }
  return best;
}

void main()
{
  uint index = smInvocationIndex();
  if (index >= smWorkCount)
  {
    return;
  }
  index += smFirstWork;
  smWorkRecord work = smWork[index];
  smPatchRecord patchRecord = smPatches[work.item.x];
  int p = SM_DEGREE_S;
  int q = SM_DEGREE_R;
  dvec3 center = patchRecord.centerRadius.xyz;
  dvec2 start = patchRecord.domain.xy;
  dvec2 width = patchRecord.domain.zw;

  int trimDegree = int(work.detail.x & 255u);
  int countT = int((work.detail.x >> 8) & 255u);
  uint flags = work.detail.x >> 24;
  uint edge = work.detail.y;
  int edgeDegree = int(work.detail.z);
  double side = (flags & smFlagFlip) != 0u ? -1.0LF : 1.0LF;
  bool alongEdge = (flags & smFlagAlongEdge) != 0u;

  double values[SM_INTEGRANDS];
  double roundings[SM_ROUNDINGS];
  smClear(values, roundings);
  double largestGap = 0.0LF;
  double squaredGap = 0.0LF;
  double gapArea = 0.0LF;

  double tWidth = work.range.y - work.range.x;
  double edgeWidth = work.range.w - work.range.z;
  for (int it = 0; it < countT; ++it)
  {
    dvec2 ruleT = smRule(countT, it);
    double t = work.range.x + tWidth * ruleT.x;
    double e = work.range.z + edgeWidth * ruleT.x;
    dvec2 uv;
    dvec2 duv;
    smTrimEvaluate(work.item.y, trimDegree, t, uv, duv);
    uv = (uv - start) / width;
    duv = duv * tWidth / width;

    dvec4 row[SM_ROW_SIZE];
    dvec4 rowR[SM_ROW_SIZE];
    smCollapse(patchRecord.shape.x, p, q, uv.y, row, rowR);
    dvec3 offset;
    dvec3 tangentS;
    dvec3 tangentR;
    smEvaluateRow(p, uv.x, row, rowR, offset, tangentS, tangentR);
    dvec3 a = center + offset;
    dvec3 da = duv.x * tangentS + duv.y * tangentR;
    dvec3 c;
    dvec3 dc;
    smEdgeEvaluate(edge, edgeDegree, e, c, dc);
    dc *= edgeWidth;

    for (int il = 0; il < SM_STRIP_POINTS; ++il)
    {
      dvec2 ruleL = smRule(SM_STRIP_POINTS, il);
      double l = ruleL.x;
      dvec3 position = (1.0LF - l) * a + l * c;
      dvec3 along = (1.0LF - l) * da + l * dc;
      dvec3 normal = side * cross(c - a, along);
      // The width c - a is a difference of two positions, each rounded relative to its size.
      double noise = 16.0LF * ruleT.y * ruleL.y * (length(a) + length(c)) * length(along);
      double weight = SM_PERTURBATION * ruleT.y * ruleL.y;
      smPlace(work.item.w, position, normal);
      double size = length(position);
      //SM::AccumulateChain
      //SM::AccumulateRoundings
    }
    if (alongEdge)
    {
      double gap = smGap(edge, edgeDegree, e, a);
      double arc = ruleT.y * length(da);
      largestGap = max(largestGap, gap);
      squaredGap += arc * gap * gap;
      gapArea += arc * gap;
    }
  }
  atomicAdd(smStatus[0], uint(countT));
  bool kept = smFinish(index, work, values, roundings);
  uint rowStart = work.item.z * SM_STRIDE;
  smRows[rowStart] = kept ? largestGap : 0.0LF;
  smRows[rowStart + 1u] = kept ? squaredGap : 0.0LF;
  smRows[rowStart + 2u] = kept ? gapArea : 0.0LF;
}
