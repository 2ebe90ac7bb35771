#include "smPlacementError.h"

#include "smBodyIntegrals.h"
#include "smBodyScales.h"
#include "smPatchMajorants.h"
#include "smVector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sm
{
namespace
{
constexpr std::array<double, 16> Identity{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };

/**
 * A sample is placed as R p + t. Rounding moves p by u |p_i| in every coordinate, a sum of three products by
 * 3 u |p|, its sum with t by u (|p| + |t|); and t, the sum of the placed origin o of the model and a
 * translation, by 4 u |o| + u |translation| before. With the root of 3 for three coordinates these are 9 u
 * |p|, 9 u |o| and 4 u |translation|. The bound of a sample's rounding has that for positions as large as the
 * body; here p is the middle of the body, whose distance may cancel.
 */
double GetEvaluationError(const BodyIntegrals& body, double translation)
{
  const std::array<double, 6> box = GetBox(*body.Model);
  const double middle = 0.5 * std::hypot(box[0] + box[1], box[2] + box[3], box[4] + box[5]);
  return UnitRoundoff *
    (9.0 * middle +
      (body.Placement == Identity ? 0.0 : 9.0 * Norm(body.Model->GetOrigin()) + 4.0 * translation));
}
}

bool PlacementError::IsRounded(const BodyIntegrals& body)
{
  const std::vector<FacePointer>& faces = body.Model->GetFaces();
  return body.Placement != Identity &&
    std::any_of(faces.begin(), faces.end(),
      [](const FacePointer& face) { return Norm(face->Surface.Rounding.data()) > 0.0; });
}

double PlacementError::GetRotated(const BodyIntegrals& body)
{
  const std::array<double, 16>& m = body.Placement;
  double deviation = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const double product = m[i] * m[j] + m[4 + i] * m[4 + j] + m[8 + i] * m[8 + j];
      deviation = std::max(deviation, std::abs(product - (i == j ? 1.0 : 0.0)));
    }
  }
  // With M = R S and S symmetric, |S - 1| is at most |M^T M - 1|, of nine entries.
  return (IsRounded(body) ? 3.0 * Rounding : 0.0) + 3.0 * deviation;
}

PlacementError PlacementError::Make(const BodyIntegrals& body, bool withSamples)
{
  PlacementError error;
  error.Rotated = GetRotated(body);
  const double* origin = body.Model->GetOrigin();
  const double translation = std::hypot(body.Placement[3], body.Placement[7], body.Placement[11]);
  if (withSamples && (body.Placement != Identity || Norm(origin) > 0.0))
  {
    error.Moved = GetEvaluationError(body, translation);
  }
  if (!(error.Rotated > 0.0))
  {
    return error;
  }
  double radius = 0.0;
  for (const FacePointer& face : body.Model->GetFaces())
  {
    for (const std::array<double, 4>& p : face->Surface.ControlPoints)
    {
      radius = std::max(radius, Norm(p.data()) / p[3]);
    }
  }
  // Twice the radius: trim curves and edges may leave the control points.
  error.Moved +=
    error.Rotated * (Norm(origin) + 2.0 * radius) + (IsRounded(body) ? Rounding * translation : 0.0);
  return error;
}

/**
 * With x moved by d and n = Ss x Sr by at most 2 Rotated |n|, the map being affine, x^k |n| changes by (k
 * Moved / reach + 2 Rotated) of reach^k |n|, and x.n x^k / (3 + k) by ((k + 1) Moved / reach + 2 Rotated) of
 * reach^(k+1) |n| / (3 + k). Squares of roundings are far below the margin in `Rounding`.
 */
double PlacementError::GetBound(const BoundClass& integrand, double area, double gaps, double reach) const
{
  if (!(this->Moved > 0.0))
  {
    return 0.0;
  }
  const int k = integrand.Degree;
  const double power = std::pow(reach, k);
  const double flux = (area + gaps) * power * ((k + 1.0) * this->Moved + 2.0 * this->Rotated * reach);
  switch (integrand.Kind)
  {
    case BoundClass::VolumeMoment:
      return flux / (3.0 + k);
    case BoundClass::HeightMoment:
      return flux;
    case BoundClass::AreaMoment:
      return area * (2.0 * this->Rotated * power + (k > 0 ? k * this->Moved * std::pow(reach, k - 1) : 0.0));
    default:
      return 2.0 * this->Rotated * (area + gaps);
  }
}
}
