// Data of a sample of a face that a user expression can name in addition to position and normal, see
// smUserExpression.h. Needs: SM_SAMPLE_DETAIL: 0 none, 1 parameters, 2 also first derivatives, 3 also second
// derivatives and curvatures; for 1 and more chunk smPatchRecord, for 2 smWork, for 3 smPatchSecond.

// The face's own u and v; derivatives with respect to u, v, uu, uv, vv; mean and Gaussian curvature.
dvec2 smSampleParameters;
dvec3 smSampleDu;
dvec3 smSampleDv;
dvec3 smSampleDuu;
dvec3 smSampleDuv;
dvec3 smSampleDvv;
dvec2 smSampleCurvatures;

#if SM_SAMPLE_DETAIL > 0
// Sets the parameters. Patches have exchanged parameters if the face has the higher degree in u.
void smDescribeParameters(smPatchRecord patchRecord, double s, double r)
{
  dvec2 own = patchRecord.domain.xy + dvec2(s, r) * patchRecord.domain.zw;
  smSampleParameters = patchRecord.shape.w != 0u ? own.yx : own;
}
#endif

#if SM_SAMPLE_DETAIL > 1
dvec3 smPlacedVector(uint face, dvec3 vector)
{
  dvec3 position = dvec3(0.0LF);
  smPlace(face, position, vector);
  return vector;
}

void smDescribeFirst(smPatchRecord patchRecord, uint face, dvec3 ds, dvec3 dr)
{
  dvec3 first = smPlacedVector(face, ds) / patchRecord.domain.z;
  dvec3 second = smPlacedVector(face, dr) / patchRecord.domain.w;
  bool isExchanged = patchRecord.shape.w != 0u;
  smSampleDu = isExchanged ? second : first;
  smSampleDv = isExchanged ? first : second;
}
#endif

#if SM_SAMPLE_DETAIL > 2
// Sets second derivatives and curvatures, after smDescribeFirst(). `normal` is placed, and may have any
// length.
void smDescribeSecond(smPatchRecord patchRecord, uint face, dvec3 normal, dvec3 dss, dvec3 dsr, dvec3 drr)
{
  dvec2 width = patchRecord.domain.zw;
  dvec3 first = smPlacedVector(face, dss) / (width.x * width.x);
  dvec3 second = smPlacedVector(face, drr) / (width.y * width.y);
  bool isExchanged = patchRecord.shape.w != 0u;
  smSampleDuu = isExchanged ? second : first;
  smSampleDuv = smPlacedVector(face, dsr) / (width.x * width.y);
  smSampleDvv = isExchanged ? first : second;
  smSampleCurvatures = smCurvatures(
    normal / max(length(normal), 1e-300LF), smSampleDu, smSampleDv, smSampleDuu, smSampleDuv, smSampleDvv);
}
#endif
