// Second derivatives of a rational Bezier patch, and its curvatures. Needs: chunk smPatch and what it needs.

// The points of the second derivative in r of the curve that smCollapse gives.
void smCollapseSecond(uint first, int p, int q, double r, SM_OUT_VECTORS(rowRR, SM_ROW_SIZE))
{
  SM_DOUBLES(basis, SM_BASIS_SIZE);
  smBernsteinBasis(max(q - 2, 0), r, basis);
  uint line = uint(p + 1);
  for (int i = 0; i <= p; ++i)
  {
    dvec4 sum = dvec4(0.0LF);
    uint at = first + uint(i);
    for (int j = 0; j + 2 <= q; ++j)
    {
      dvec4 middle = smControlPoint(at + line);
      sum +=
        SM_DOUBLE(basis, j) * ((smControlPoint(at + 2u * line) - middle) - (middle - smControlPoint(at)));
      at += line;
    }
    SM_SET_VECTOR(rowRR, i, double(q * (q - 1)) * sum);
  }
}

// Second derivatives in s, in s and r, and in r, from the rows of smCollapse and smCollapseSecond.
void smEvaluateSecond(int p, double s, SM_IN_VECTORS(row, SM_ROW_SIZE), SM_IN_VECTORS(rowS, SM_ROW_SIZE),
  SM_IN_VECTORS(rowR, SM_ROW_SIZE), SM_IN_VECTORS(rowRR, SM_ROW_SIZE), SM_OUT(dvec3) dss, SM_OUT(dvec3) dsr,
  SM_OUT(dvec3) drr)
{
  dvec4 h = dvec4(0.0LF);
  dvec4 hs = dvec4(0.0LF);
  dvec4 hr = dvec4(0.0LF);
  dvec4 hss = dvec4(0.0LF);
  dvec4 hsr = dvec4(0.0LF);
  dvec4 hrr = dvec4(0.0LF);
  SM_DOUBLES(basis, SM_BASIS_SIZE);
  smBernsteinBasis(p - 1, s, basis);
  for (int i = 0; i < p; ++i)
  {
    double factor = SM_DOUBLE(basis, i);
    h += factor * ((1.0LF - s) * SM_VECTOR(row, i) + s * SM_VECTOR(row, i + 1));
    hs += factor * SM_VECTOR(rowS, i);
    hr += factor * ((1.0LF - s) * SM_VECTOR(rowR, i) + s * SM_VECTOR(rowR, i + 1));
    hsr += factor * (SM_VECTOR(rowR, i + 1) - SM_VECTOR(rowR, i));
    hrr += factor * ((1.0LF - s) * SM_VECTOR(rowRR, i) + s * SM_VECTOR(rowRR, i + 1));
  }
  hs *= double(p);
  hsr *= double(p);
  smBernsteinBasis(max(p - 2, 0), s, basis);
  for (int i = 0; i + 2 <= p; ++i)
  {
    hss += SM_DOUBLE(basis, i) * (SM_VECTOR(rowS, i + 1) - SM_VECTOR(rowS, i));
  }
  hss *= double(p * (p - 1));

  double inverse = 1.0LF / h.w;
  dvec3 position = dvec3(h.x, h.y, h.z) * inverse;
  dvec3 ds = (dvec3(hs.x, hs.y, hs.z) - hs.w * position) * inverse;
  dvec3 dr = (dvec3(hr.x, hr.y, hr.z) - hr.w * position) * inverse;
  dss = (dvec3(hss.x, hss.y, hss.z) - 2.0LF * hs.w * ds - hss.w * position) * inverse;
  dsr = (dvec3(hsr.x, hsr.y, hsr.z) - hs.w * dr - hr.w * ds - hsr.w * position) * inverse;
  drr = (dvec3(hrr.x, hrr.y, hrr.z) - 2.0LF * hr.w * dr - hrr.w * position) * inverse;
}

// Mean and Gaussian curvature from the derivatives in any parameters. The mean is half the divergence of the
// outward unit normal: positive where the body is convex, 1/R on a sphere.
dvec2 smCurvatures(dvec3 outward, dvec3 du, dvec3 dv, dvec3 duu, dvec3 duv, dvec3 dvv)
{
  dvec3 area = cross(du, dv);
  double determinant = dot(area, area);
  double uu = dot(duu, outward);
  double uv = dot(duv, outward);
  double vv = dot(dvv, outward);
  double mean = dot(du, du) * vv - 2.0LF * dot(du, dv) * uv + dot(dv, dv) * uu;
  return dvec2(-0.5LF * mean, uu * vv - uv * uv) / determinant;
}
