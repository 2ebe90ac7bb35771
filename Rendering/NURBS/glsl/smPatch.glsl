// Evaluation of a rational Bezier patch with first derivatives.
// Needs: chunk smBernstein, SM_ROW_SIZE (entries of a row array), dvec4 smControlPoint(uint index).
//
// Control points are homogeneous (w x, w y, w z, w) relative to the patch's centre, s fastest. Derivatives
// are sums of differences of neighbouring control points, taken before anything else: so that their rounding
// is relative to these differences, not to the patch's radius. A long narrow patch needs that.

// The curve in s that the patch is at r = constant: its Bezier points (row), the steps from each to the next
// (rowS), and the points of its derivative in r (rowR). Points are not computed as sums of steps: next to a
// control point of large weight one of small weight would lose its digits.
void smCollapse(uint first, int p, int q, double r, SM_OUT_VECTORS(row, SM_ROW_SIZE),
  SM_OUT_VECTORS(rowS, SM_ROW_SIZE), SM_OUT_VECTORS(rowR, SM_ROW_SIZE))
{
  SM_DOUBLES(basis, SM_BASIS_SIZE);
  smBernsteinBasis(q - 1, r, basis);
  for (int i = 0; i <= p; ++i)
  {
    uint at = first + uint(i);
    uint next = first + uint(min(i + 1, p));
    dvec4 point = dvec4(0.0LF);
    dvec4 step = dvec4(0.0LF);
    dvec4 difference = dvec4(0.0LF);
    dvec4 low = smControlPoint(at);
    dvec4 lowStep = smControlPoint(next) - low;
    for (int j = 1; j <= q; ++j)
    {
      uint line = uint(j * (p + 1));
      dvec4 high = smControlPoint(at + line);
      dvec4 highStep = smControlPoint(next + line) - high;
      double factor = SM_DOUBLE(basis, j - 1);
      point += factor * ((1.0LF - r) * low + r * high);
      step += factor * ((1.0LF - r) * lowStep + r * highStep);
      difference += factor * (high - low);
      low = high;
      lowStep = highStep;
    }
    SM_SET_VECTOR(row, i, point);
    SM_SET_VECTOR(rowS, i, step);
    SM_SET_VECTOR(rowR, i, double(q) * difference);
  }
}

// Position relative to the patch's centre and derivatives in s and r, from the rows of smCollapse.
void smEvaluateRow(int p, double s, SM_IN_VECTORS(row, SM_ROW_SIZE), SM_IN_VECTORS(rowS, SM_ROW_SIZE),
  SM_IN_VECTORS(rowR, SM_ROW_SIZE), SM_OUT(dvec3) position, SM_OUT(dvec3) ds, SM_OUT(dvec3) dr)
{
  SM_DOUBLES(basis, SM_BASIS_SIZE);
  smBernsteinBasis(p - 1, s, basis);
  dvec4 h = dvec4(0.0LF);
  dvec4 hs = dvec4(0.0LF);
  dvec4 hr = dvec4(0.0LF);
  for (int i = 0; i < p; ++i)
  {
    double factor = SM_DOUBLE(basis, i);
    h += factor * ((1.0LF - s) * SM_VECTOR(row, i) + s * SM_VECTOR(row, i + 1));
    hs += factor * SM_VECTOR(rowS, i);
    hr += factor * ((1.0LF - s) * SM_VECTOR(rowR, i) + s * SM_VECTOR(rowR, i + 1));
  }
  hs *= double(p);
  double inverse = 1.0LF / h.w;
  position = dvec3(h.x, h.y, h.z) * inverse;
  ds = (dvec3(hs.x, hs.y, hs.z) - hs.w * position) * inverse;
  dr = (dvec3(hr.x, hr.y, hr.z) - hr.w * position) * inverse;
}
