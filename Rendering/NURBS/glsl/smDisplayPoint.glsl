// Position and unit normal of a display point, as EvaluateDisplayPoint() of Filters/NURBS/smPointLayout.h.
// Needs: chunk smPatch and what it needs, chunk smPatchRecord.
void smEvaluateDisplayPoint(
  smPatchRecord patchRecord, double s, double r, SM_OUT(dvec3) position, SM_OUT(dvec3) normal)
{
  int p = int(patchRecord.shape.y);
  int q = int(patchRecord.shape.z);
  double minimum = 1e-6LF * patchRecord.stretch.x * patchRecord.stretch.y;
  double square = 0.0LF;
  for (int attempt = 0; attempt < 2; ++attempt)
  {
    SM_VECTORS(row, SM_ROW_SIZE);
    SM_VECTORS(rowS, SM_ROW_SIZE);
    SM_VECTORS(rowR, SM_ROW_SIZE);
    smCollapse(patchRecord.shape.x, p, q, r, row, rowS, rowR);
    dvec3 at;
    dvec3 ds;
    dvec3 dr;
    smEvaluateRow(p, s, row, rowS, rowR, at, ds, dr);
    if (attempt == 0)
    {
      position = at;
    }
    normal = cross(ds, dr);
    square = dot(normal, normal);
    if (square > minimum * minimum)
    {
      break;
    }
    s += (0.5LF - s) / 4096.0LF;
    r += (0.5LF - r) / 4096.0LF;
  }
  position += dvec3(patchRecord.centerRadius.x, patchRecord.centerRadius.y, patchRecord.centerRadius.z);
  normal = square > 0.0LF ? normal / sqrt(square) : dvec3(0.0LF);
}
