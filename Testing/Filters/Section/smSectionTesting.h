/**
 * @file smSectionTesting.h
 * @brief Plane sections with closed forms, and a filter on a file, for the tests of sections
 */
#ifndef smSectionTesting_h
#define smSectionTesting_h

#include "smBuoyancyTesting.h"

#include <vtkSolidSection.h>

#include <algorithm>
#include <vector>

namespace smtest
{
using Tensor = std::array<Vector, 3>;

/// A plane region: area, centroid, and second moments about the centroid.
struct Region
{
  Real Area = 0;
  Vector Centroid{};
  Tensor Second{};
};

inline Vector CrossProduct(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/// factor times the outer product of a and b.
inline Tensor Outer(Real factor, const Vector& a, const Vector& b)
{
  Tensor t{};
  for (int i = 0; i < 3; ++i)
  {
    t[i] = Scaled(b, factor * a[i]);
  }
  return t;
}

inline Tensor SumOf(const Tensor& a, const Tensor& b)
{
  return { Sum(a[0], b[0]), Sum(a[1], b[1]), Sum(a[2], b[2]) };
}

/// Both regions; sign -1 takes the second away.
inline Region Combine(const Region& a, const Region& b, int sign)
{
  Region both;
  both.Area = a.Area + sign * b.Area;
  // Relative to the first centroid.
  const Vector way = Sum(b.Centroid, Scaled(a.Centroid, -1));
  const Vector c = Scaled(way, sign * b.Area / both.Area);
  both.Centroid = Sum(a.Centroid, c);
  both.Second = SumOf(SumOf(a.Second, Outer(sign * b.Area, way, way)), Outer(-both.Area, c, c));
  for (int i = 0; i < 3; ++i)
  {
    both.Second[i] = Sum(both.Second[i], Scaled(b.Second[i], sign));
  }
  return both;
}

/// An ellipse with semi-axes a and b along orthogonal unit vectors u and v.
inline Region Ellipse(const Vector& center, Real a, const Vector& u, Real b, const Vector& v)
{
  const Real area = Pi * a * b;
  return { area, center, SumOf(Outer(area * a * a / 4, u, u), Outer(area * b * b / 4, v, v)) };
}

/// A region that is symmetric about the axes u and v through its centre, with these second moments along
/// them.
inline Region Symmetric(
  const Vector& center, Real area, Real alongU, const Vector& u, Real alongV, const Vector& v)
{
  return { area, center, SumOf(Outer(alongU, u, u), Outer(alongV, v, v)) };
}

/// A triangle; its area has the sign of its turn about `normal`.
inline Region Triangle(const Vector& a, const Vector& b, const Vector& c, const Vector& normal)
{
  Region region;
  region.Area = Dot(CrossProduct(Sum(b, Scaled(a, -1)), Sum(c, Scaled(a, -1))), normal) / 2;
  region.Centroid = Scaled(Sum(a, Sum(b, c)), Real(1) / 3);
  for (const Vector& corner : { a, b, c })
  {
    const Vector way = Sum(corner, Scaled(region.Centroid, -1));
    region.Second = SumOf(region.Second, Outer(region.Area / 12, way, way));
  }
  return region;
}

/// The section of a convex polyhedron with edges (pairs of corners) by the plane through `point` with the
/// unit normal `normal`.
inline Region ConvexSection(
  const std::vector<std::pair<Vector, Vector>>& edges, const Vector& point, const Vector& normal)
{
  std::vector<Vector> corners;
  Vector middle{};
  for (const auto& [a, b] : edges)
  {
    const Real atA = Dot(Sum(a, Scaled(point, -1)), normal);
    const Real atB = Dot(Sum(b, Scaled(point, -1)), normal);
    if ((atA < 0) != (atB < 0))
    {
      corners.push_back(Sum(a, Scaled(Sum(b, Scaled(a, -1)), atA / (atA - atB))));
      middle = Sum(middle, corners.back());
    }
  }
  if (corners.size() < 3)
  {
    return {};
  }
  middle = Scaled(middle, Real(1) / static_cast<Real>(corners.size()));
  const Vector x = Unit(Sum(corners[0], Scaled(middle, -1)));
  const Vector y = CrossProduct(normal, x);
  const auto angle = [&](const Vector& corner)
  {
    const Vector way = Sum(corner, Scaled(middle, -1));
    return std::atan2(Dot(way, y), Dot(way, x));
  };
  std::sort(corners.begin(), corners.end(),
    [&angle](const Vector& a, const Vector& b) { return angle(a) < angle(b); });
  Region region = Triangle(middle, corners.back(), corners.front(), normal);
  for (std::size_t i = 1; i < corners.size(); ++i)
  {
    region = Combine(region, Triangle(middle, corners[i - 1], corners[i], normal), 1);
  }
  return region;
}

/// A plane and the section with it.
struct Cut
{
  std::string Name;
  Vector Point{};
  Vector Normal{};
  Region Section;
  /// Area that the section changes by per unit of length that the plane is off by.
  Real Slope = 0;
};

/// A filter on a file, moved perhaps.
struct SectionScene
{
  vtkNew<vtkSTEPReader> Reader;
  vtkNew<vtkNURBSTransform> Move;
  vtkNew<vtkSolidSection> Filter;

  explicit SectionScene(const std::string& path, bool isCoarse = true)
  {
    this->Reader->SetFileName(path.c_str());
    if (isCoarse)
    {
      UseCoarseMesh(this->Reader);
    }
    this->Move->SetInputConnection(this->Reader->GetOutputPort());
    this->Filter->SetInputConnection(this->Move->GetOutputPort());
    this->Filter->SetBackend(Backend);
  }

  void Set(const Vector& point, const Vector& normal)
  {
    const auto number = [](Real x) { return static_cast<double>(x); };
    this->Filter->SetPoint(number(point[0]), number(point[1]), number(point[2]));
    this->Filter->SetNormal(number(normal[0]), number(normal[1]), number(normal[2]));
  }
};
}

#endif
