/**
 * @file smSurfaceTesting.h
 * @brief What tests of surfaces and curves against OpenCASCADE's share
 */
#ifndef smSurfaceTesting_h
#define smSurfaceTesting_h

#include "smTesting.h"
#include "smVector.h"

#include <Geom_BSplineCurve.hxx>
#include <gp_Pnt.hxx>

#include <cmath>
#include <random>

namespace smtest
{
/// 13 digits: OpenCASCADE's own rounding in coordinates of about 10.
constexpr double SurfaceLimit = 1e-13;

/// The same numbers in each run.
inline double Uniform(double low, double high)
{
  static std::mt19937 random(7);
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline double GetKernelDistance(const sm::Vector3& a, const gp_XYZ& b)
{
  return std::hypot(a[0] - b.X(), a[1] - b.Y(), a[2] - b.Z());
}

inline gp_Pnt RandomPoint()
{
  return gp_Pnt(Uniform(-5.0, 5.0), Uniform(-5.0, 5.0), Uniform(-5.0, 5.0));
}

/// A cubic spline of four spans with random points.
inline Handle(Geom_BSplineCurve) MakeSpline(bool periodic, bool rational)
{
  TColStd_Array1OfReal knots(1, 5);
  TColStd_Array1OfInteger multiplicities(1, 5);
  const double values[] = { 0.0, 1.0, 2.5, 3.0, 4.5 };
  int poles = 0;
  for (int i = 1; i <= 5; ++i)
  {
    knots(i) = values[i - 1];
    multiplicities(i) = i == 1 || i == 5 ? (periodic ? 2 : 4) : (i == 3 ? 2 : 1);
    poles += i < 5 || !periodic ? multiplicities(i) : 0;
  }
  poles -= periodic ? 0 : 4;
  TColgp_Array1OfPnt points(1, poles);
  TColStd_Array1OfReal weights(1, poles);
  for (int i = 1; i <= poles; ++i)
  {
    points(i) = RandomPoint();
    weights(i) = rational ? Uniform(0.5, 2.0) : 1.0;
  }
  return new Geom_BSplineCurve(points, weights, knots, multiplicities, 3, periodic);
}
}

#endif
