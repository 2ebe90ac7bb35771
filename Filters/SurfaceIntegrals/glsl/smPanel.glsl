// Adds up samples of one panel {(xi s(t), r(t))}, or of some lines of it, with Gauss points in t along the
// trim piece and in xi across. A line is the points across at one node in t, for which the patch is reduced
// once to a curve in s.
//
// Needs: chunks smPatchRecord, smPatch, smWork; SM_DEGREE_S, SM_DEGREE_R (degrees of patchRecord, constants
// for the common degrees), SM_PERTURBATION (a factor of every sample), SM_SAMPLE_DETAIL (data that smSample
// provides for every sample, which does not affect anything else; above 0 also chunk smSample, above 2 also
// smPatchSecond); smPatchRecord smGetPatch(uint index), void smAccumulateFace(double weight, double noise,
// dvec3 position, dvec3 normal).

// Returns the number of roundings per sample that is added to the bound, in the units of smIntegratePanel: an
// estimate. The panels of the real files needed at most 2, 3.3 and 3.6 for p + q = 2, 3 and more.
double smSampleRoundings(int p, int q)
{
  return min(8.0LF, 2.0LF * double(p + q));
}

// Integrates the lines [first, end) of a panel and returns the number of evaluations.
uint smIntegratePanel(smWorkRecord work, int first, int end)
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
  int countX = int((work.detail.x >> 16) & 255u);
  uint flags = work.detail.x >> 24;
  double coverage = (flags & smFlagNegative) != 0u ? -1.0LF : 1.0LF;
  double side = (flags & smFlagFlip) != 0u ? -1.0LF : 1.0LF;

  double tWidth = work.range.y - work.range.x;
  double xiWidth = work.range.w - work.range.z;
  for (int it = first; it < end; ++it)
  {
    dvec2 ruleT = smRule(countT, it);
    double t = work.range.x + tWidth * ruleT.x;
    dvec2 uv;
    dvec2 duv;
    dvec2 reach;
    smTrimEvaluate(work.item.y, trimDegree, t, start, uv, duv, reach);
    uv = uv / width;
    // Rounding of the trim curve in units of cells.
    double trimNoise = smTrimRoundings * max(1.0LF, max(reach.x / width.x, reach.y / width.y));
    double dr = duv.y / width.y;
    double edgeS = uv.x;
    double weightT = ruleT.y * tWidth * xiWidth * dr;

    SM_VECTORS(row, SM_ROW_SIZE);
    SM_VECTORS(rowS, SM_ROW_SIZE);
    SM_VECTORS(rowR, SM_ROW_SIZE);
    smCollapse(patchRecord.shape.x, p, q, uv.y, row, rowS, rowR);
#if SM_SAMPLE_DETAIL > 2
    SM_VECTORS(rowRR, SM_ROW_SIZE);
    smCollapseSecond(patchRecord.shape.x, p, q, uv.y, rowRR);
#endif
    for (int ix = 0; ix < countX; ++ix)
    {
      dvec2 ruleX = smRule(countX, ix);
      double s = (work.range.z + xiWidth * ruleX.x) * edgeS;
      dvec3 offset;
      dvec3 tangentS;
      dvec3 tangentR;
      smEvaluateRow(p, s, row, rowS, rowR, offset, tangentS, tangentR);
      dvec3 position = center + offset;
      dvec3 normal = side * cross(tangentS, tangentR);

      double lengthS = length(tangentS);
      double lengthR = length(tangentR);
      // Rounding of the sample relative to the largest steps of the control net, and rounding of the trim
      // curve: Bounds.md, 2.
      double stretchS = min(patchRecord.stretch.x, lengthS + 2.0LF * double(p) * radius);
      double stretchR = min(patchRecord.stretch.y, lengthR + 2.0LF * double(q) * radius);
      double noise = abs(weightT * ruleX.y) *
        (smSampleRoundings(p, q) * abs(edgeS) * (stretchS * lengthR + stretchR * lengthS) +
          trimNoise * stretchS * stretchR);
      double weight = coverage * SM_PERTURBATION * weightT * ruleX.y * edgeS;
      smPlace(work.item.w, position, normal);
#if SM_SAMPLE_DETAIL > 0
      smDescribeParameters(patchRecord, s, uv.y);
#endif
#if SM_SAMPLE_DETAIL > 1
      smDescribeFirst(patchRecord, work.item.w, tangentS, tangentR);
#endif
#if SM_SAMPLE_DETAIL > 2
      dvec3 dss;
      dvec3 dsr;
      dvec3 drr;
      smEvaluateSecond(p, s, row, rowS, rowR, rowRR, dss, dsr, drr);
      smDescribeSecond(patchRecord, work.item.w, normal, dss, dsr, drr);
#endif
      smAccumulateFace(weight, noise, position, normal);
    }
  }
  return uint((end - first) * countX);
}
