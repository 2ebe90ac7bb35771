// Adds up samples of one flat triangle X = apex + l (from + t (to - from) - apex), or of some lines of it,
// with SM_STRIP_POINTS squared Gauss points, which are exact for the polynomial integrands. A line has the
// points in l at one node in t.
//
// Needs: chunk smWork; SM_STRIP_POINTS, SM_PERTURBATION; double smCap(uint index), nine coordinates per cap:
// apex, from, to; void smAccumulateChain(double weight, double noise, dvec3 position, dvec3 normal).

dvec3 smCapPoint(uint first)
{
  return dvec3(smCap(first), smCap(first + 1u), smCap(first + 2u));
}

// Integrates the lines [first, end) of a cap.
void smIntegrateCap(smWorkRecord work, int first, int end)
{
  uint flags = work.detail.x >> 24;
  double side = (flags & smFlagFlip) != 0u ? -1.0LF : 1.0LF;
  dvec3 apex = smCapPoint(work.item.y);
  dvec3 from = smCapPoint(work.item.y + 3u);
  dvec3 to = smCapPoint(work.item.y + 6u);

  dvec3 area = side * cross(from - apex, to - apex);
  double magnitude = length(apex) + length(from) + length(to);
  double reach = length(from - apex) + length(to - apex);
  for (int it = first; it < end; ++it)
  {
    dvec2 ruleT = smRule(SM_STRIP_POINTS, it);
    for (int il = 0; il < SM_STRIP_POINTS; ++il)
    {
      dvec2 ruleL = smRule(SM_STRIP_POINTS, il);
      double l = ruleL.x;
      dvec3 position = (1.0LF - l) * apex + l * ((1.0LF - ruleT.x) * from + ruleT.x * to);
      dvec3 normal = l * area;
      double noise = 16.0LF * ruleT.y * ruleL.y * magnitude * reach;
      double weight = SM_PERTURBATION * ruleT.y * ruleL.y;
      smPlace(work.item.w, position, normal);
      smAccumulateChain(weight, noise, position, normal);
    }
  }
}
