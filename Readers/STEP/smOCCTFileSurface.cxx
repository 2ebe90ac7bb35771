#include "smOCCTFileSurface.h"

#include "smOCCTBuildGeometry.h"
#include "smVector.h"

#include <TColStd_Array1OfReal.hxx>

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// A box may extend beyond the domain by this fraction of the period: the rounding of trim curves along the
/// border.
constexpr double DomainSlack = 1e-9;
/// Largest distance, relative to the size, of a control point that OpenCASCADE keeps from the file's.
constexpr double KeptTolerance = 1e-9;

NativeBox GetDomain(const Geom_BSplineSurface& surface)
{
  NativeBox box;
  surface.Bounds(box.Low[0], box.High[0], box.Low[1], box.High[1]);
  return box;
}

Vector3 GetPosition(const std::array<double, 4>& h)
{
  return { h[0] / h[3], h[1] / h[3], h[2] / h[3] };
}

double GetDiameter(const NURBSSurface& surface)
{
  Vector3 low = GetPosition(surface.ControlPoints[0]);
  Vector3 high = low;
  for (const std::array<double, 4>& h : surface.ControlPoints)
  {
    const Vector3 point = GetPosition(h);
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], point[c]);
      high[c] = std::max(high[c], point[c]);
    }
  }
  return Norm(Subtract(high, low));
}

/// Returns the factor of OpenCASCADE's conversion of the length unit: the ratio of the largest coordinates
/// that no row at the end has.
double FindScale(const NURBSSurface& read, const NURBSSurface& file)
{
  double scale = 1.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < read.ControlPoints.size(); ++k)
  {
    const int i = static_cast<int>(k) % read.NumberOfControlPoints[0];
    const int j = static_cast<int>(k) / read.NumberOfControlPoints[0];
    const bool isInside = i + 1 < read.NumberOfControlPoints[0] && j + 1 < read.NumberOfControlPoints[1];
    const Vector3 a = GetPosition(read.ControlPoints[k]);
    const Vector3 b = GetPosition(file.ControlPoints[k]);
    for (int c = 0; c < 3; ++c)
    {
      if (isInside && std::abs(b[c]) > largest)
      {
        largest = std::abs(b[c]);
        scale = a[c] / b[c];
      }
    }
  }
  return std::abs(scale - 1.0) < 1e-13 ? 1.0 : scale;
}

/**
 * Returns a bound of the distance of two surfaces with the same knots: with control points P_i and P_i + d_i
 * and weights w_i and w_i + e_i it is at most the largest |d_i| + |e_i| / min(w_i, w_i + e_i) diameter,
 * because the basis functions B_i w_i / sum B_i w_i are at most 1 in total.
 */
double GetDistance(const NURBSSurface& a, const NURBSSurface& b, double scale, double diameter)
{
  double distance = 0.0;
  for (std::size_t k = 0; k < a.ControlPoints.size(); ++k)
  {
    const std::array<double, 4>& p = a.ControlPoints[k];
    const std::array<double, 4>& q = b.ControlPoints[k];
    const Vector3 at = GetPosition(q);
    const Vector3 step = Subtract(GetPosition(p), Vector3{ scale * at[0], scale * at[1], scale * at[2] });
    distance = std::max(distance, Norm(step) + std::abs(p[3] - q[3]) / std::min(p[3], q[3]) * diameter);
  }
  return distance;
}

}

FileSurface CompareSurfaces(const Handle(Geom_BSplineSurface) & own, const Handle(Geom_BSplineSurface) & read)
{
  const bool isAsRead =
    !own.IsNull() && own->IsUPeriodic() == read->IsUPeriodic() && own->IsVPeriodic() == read->IsVPeriodic();
  if (own.IsNull() || isAsRead)
  {
    return {};
  }
  const NativeBox domain = GetDomain(*own);
  const NURBSSurface a = ClampKnots(ConvertSurface(read, domain, AffineMap()).Surface);
  const NURBSSurface b = ClampKnots(ConvertSurface(own, domain, AffineMap()).Surface);
  if (a.NumberOfControlPoints[0] != b.NumberOfControlPoints[0] ||
    a.NumberOfControlPoints[1] != b.NumberOfControlPoints[1])
  {
    return {};
  }
  const double scale = FindScale(a, b);
  const double diameter = GetDiameter(a);
  const Vector3 first = GetPosition(b.ControlPoints[0]);
  const Vector3 expected{ scale * first[0], scale * first[1], scale * first[2] };
  if (!(Norm(Subtract(GetPosition(a.ControlPoints[0]), expected)) <= KeptTolerance * diameter))
  {
    return {};
  }
  FileSurface result;
  result.Distance = GetDistance(a, b, scale, diameter);
  if (result.Distance > 0.0)
  {
    own->Scale(gp_Pnt(), scale);
    result.Surface = own;
  }
  return result;
}

Handle(Geom_Surface)
  CoverBox(const FileSurface& file, const Handle(Geom_Surface) & periodic, const NativeBox& box)
{
  const auto surface = Handle(Geom_BSplineSurface)::DownCast(file.Surface->Copy());
  for (int d = 0; d < 2; ++d)
  {
    const bool isPeriodic = d == 0 ? periodic->IsUPeriodic() : periodic->IsVPeriodic();
    const double period = isPeriodic ? (d == 0 ? periodic->UPeriod() : periodic->VPeriod()) : 0.0;
    const NativeBox domain = GetDomain(*surface);
    const double middle = 0.5 * (box.Low[d] + box.High[d]) - 0.5 * (domain.Low[d] + domain.High[d]);
    const double shift = isPeriodic ? std::round(middle / period) * period : 0.0;
    if (isPeriodic &&
      (box.Low[d] < domain.Low[d] + shift - DomainSlack * period ||
        box.High[d] > domain.High[d] + shift + DomainSlack * period))
    {
      return {};
    }
    if (shift != 0.0)
    {
      TColStd_Array1OfReal knots(d == 0 ? surface->UKnots() : surface->VKnots());
      for (double& knot : knots)
      {
        knot += shift;
      }
      if (d == 0)
      {
        surface->SetUKnots(knots);
      }
      else
      {
        surface->SetVKnots(knots);
      }
    }
  }
  return Handle(Geom_Surface)(surface);
}
}
