// Evaluation of a rational Bezier patch with first derivatives.
// Needs: chunk smBernstein, SM_ROW_SIZE (entries of a row array), dvec4 smControlPoint(uint index).
//
// Control points are homogeneous (w x, w y, w z, w) relative to the patch's centre, s fastest. Values and
// derivatives come from the basis of one degree less, so that a derivative is a sum of differences of
// neighbouring points and loses nothing by cancellation elsewhere.

// The curve in s that the patch is at r = constant (row), and its derivative in r (rowR): Bezier points.
void smCollapse(uint first, int p, int q, double r, SM_OUT_ARRAY(dvec4, row, SM_ROW_SIZE),
  SM_OUT_ARRAY(dvec4, rowR, SM_ROW_SIZE))
{
  double basis[SM_BASIS_SIZE];
  smBernsteinBasis(q - 1, r, basis);
  for (int i = 0; i <= p; ++i)
  {
    dvec4 value = dvec4(0.0LF);
    dvec4 difference = dvec4(0.0LF);
    dvec4 before = smControlPoint(first + uint(i));
    for (int j = 0; j < q; ++j)
    {
      dvec4 after = smControlPoint(first + uint(i + (j + 1) * (p + 1)));
      value += basis[j] * ((1.0LF - r) * before + r * after);
      difference += basis[j] * (after - before);
      before = after;
    }
    row[i] = value;
    rowR[i] = double(q) * difference;
  }
}

// Position relative to the patch's centre and derivatives in s and r, from the rows of smCollapse.
void smEvaluateRow(int p, double s, SM_ARRAY(dvec4, row, SM_ROW_SIZE), SM_ARRAY(dvec4, rowR, SM_ROW_SIZE),
  SM_OUT(dvec3) position, SM_OUT(dvec3) ds, SM_OUT(dvec3) dr)
{
  double basis[SM_BASIS_SIZE];
  smBernsteinBasis(p - 1, s, basis);
  dvec4 h = dvec4(0.0LF);
  dvec4 hs = dvec4(0.0LF);
  dvec4 hr = dvec4(0.0LF);
  for (int i = 0; i < p; ++i)
  {
    h += basis[i] * ((1.0LF - s) * row[i] + s * row[i + 1]);
    hs += basis[i] * (row[i + 1] - row[i]);
    hr += basis[i] * ((1.0LF - s) * rowR[i] + s * rowR[i + 1]);
  }
  hs *= double(p);
  double inverse = 1.0LF / h.w;
  position = dvec3(h.x, h.y, h.z) * inverse;
  ds = (dvec3(hs.x, hs.y, hs.z) - hs.w * position) * inverse;
  dr = (dvec3(hr.x, hr.y, hr.z) - hr.w * position) * inverse;
}
