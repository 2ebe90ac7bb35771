#include "smPlacementError.h"

#include "smBodyIntegrals.h"
#include "smPatchMajorants.h"
#include "smVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
constexpr std::array<double, 16> Identity{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
}

bool PlacementError::IsRounded(const BodyIntegrals& body)
{
  const std::vector<FacePointer>& faces = body.Model->GetFaces();
  return body.Placement != Identity &&
    std::any_of(faces.begin(), faces.end(),
      [](const FacePointer& face) { return Norm(face->Surface.Rounding.data()) > 0.0; });
}

double PlacementError::GetTurned(const BodyIntegrals& body)
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
  // With M = R S and S symmetric, |S - 1| is at most |M^T M - 1|, of nine entries. A rotation in doubles has some u.
  return (IsRounded(body) ? 3.0 * Rounding : 0.0) + (deviation > Rounding ? 3.0 * deviation : 0.0);
}

PlacementError PlacementError::Make(const BodyIntegrals& body)
{
  PlacementError error;
  error.Turned = GetTurned(body);
  if (!(error.Turned > 0.0))
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
  const double translation[3] = { body.Placement[3], body.Placement[7], body.Placement[11] };
  // Twice the radius: trim curves and edges may leave the control points.
  error.Moved = error.Turned * (Norm(body.Model->GetOrigin()) + 2.0 * radius) + Rounding * Norm(translation);
  return error;
}

/**
 * With x moved by d and n = Ss x Sr by at most 2 Turned |n|, the map being affine, x^k |n| changes by (k Moved / reach + 2 Turned) of
 * reach^k |n|, and x.n x^k / (3 + k) by ((k + 1) Moved / reach + 2 Turned) of reach^(k+1) |n| / (3 + k). Squares of roundings are far below
 * the margin in `Rounding`.
 */
double PlacementError::GetBound(const BoundClass& integrand, double area, double gaps, double reach) const
{
  if (!(this->Moved > 0.0))
  {
    return 0.0;
  }
  const int k = integrand.Degree;
  const double power = std::pow(reach, k);
  const double flux = (area + gaps) * power * ((k + 1.0) * this->Moved + 2.0 * this->Turned * reach);
  switch (integrand.Kind)
  {
    case BoundClass::VolumeMoment:
      return flux / (3.0 + k);
    case BoundClass::HeightMoment:
      return flux;
    case BoundClass::AreaMoment:
      return area * (2.0 * this->Turned * power + (k > 0 ? k * this->Moved * std::pow(reach, k - 1) : 0.0));
    default:
      return 2.0 * this->Turned * (area + gaps);
  }
}
}
