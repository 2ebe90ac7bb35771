#include "smIntegralBytes.h"

namespace sm
{
void PutIntegrals(ByteWriter& to, const FaceIntegrals& integrals)
{
  for (const std::vector<double>* values : { &integrals.Face, &integrals.Closing, &integrals.QuadratureError,
         &integrals.Rounding, &integrals.Conversion, &integrals.Residual })
  {
    to.PutAll(*values);
  }
  to.Put(integrals.Estimated);
  to.Put(integrals.Skipped);
  to.Put(integrals.LeftOut);
  to.Put(integrals.GapSquared);
  to.Put(integrals.GapArea);
  to.Put(integrals.MaxGap);
  to.PutAll(integrals.Gaps);
  to.Put(integrals.CoverageDefects);
  to.Put(integrals.Overlap);
  to.Put(integrals.Outside);
  to.Put(integrals.IsContinued);
  to.PutText(integrals.Error);
}

FaceIntegrals GetIntegrals(ByteReader& from)
{
  FaceIntegrals integrals;
  for (std::vector<double>* values : { &integrals.Face, &integrals.Closing, &integrals.QuadratureError,
         &integrals.Rounding, &integrals.Conversion, &integrals.Residual })
  {
    *values = from.GetAll<double>();
  }
  integrals.Estimated = from.Get<bool>();
  integrals.Skipped = from.Get<bool>();
  integrals.LeftOut = from.Get<bool>();
  integrals.GapSquared = from.Get<double>();
  integrals.GapArea = from.Get<double>();
  integrals.MaxGap = from.Get<double>();
  integrals.Gaps = from.GetAll<CoedgeGap>();
  integrals.CoverageDefects = from.Get<int>();
  integrals.Overlap = from.Get<double>();
  integrals.Outside = from.Get<Overhang>();
  integrals.IsContinued = from.Get<bool>();
  integrals.Error = from.GetText();
  return integrals;
}
}
