#include "smOCCTBuildGeometry.h"

#include "smOCCTMakeGeometry.h"
#include "smVector.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace sm
{
namespace
{
/// Largest deviation of the speed of a line from 1: its end is off by as much of its length.
constexpr double LineSpeed = 1e-13;

/// Distinct knots with their multiplicities, the form that OpenCASCADE uses.
struct KnotList
{
  TColStd_Array1OfReal Knots;
  TColStd_Array1OfInteger Multiplicities;
};

KnotList MakeKnotList(const std::vector<double>& flat, int degree)
{
  std::vector<double> knots;
  std::vector<int> multiplicities;
  for (const double knot : flat)
  {
    // OpenCASCADE refuses knots that differ only by rounding.
    if (!knots.empty() && knot - knots.back() <= Epsilon(std::abs(knots.back())))
    {
      ++multiplicities.back();
      continue;
    }
    knots.push_back(knot);
    multiplicities.push_back(1);
  }
  for (std::size_t i = 1; i + 1 < knots.size(); ++i)
  {
    if (multiplicities[i] > degree)
    {
      throw std::runtime_error("its surface is torn at a knot of multiplicity " +
        std::to_string(multiplicities[i]) + " with degree " + std::to_string(degree));
    }
  }
  const int count = static_cast<int>(knots.size());
  KnotList list{ TColStd_Array1OfReal(1, count), TColStd_Array1OfInteger(1, count) };
  for (int i = 0; i < count; ++i)
  {
    list.Knots(i + 1) = knots[i];
    list.Multiplicities(i + 1) = multiplicities[i];
  }
  return list;
}

bool IsClamped(const std::vector<double>& knots, int degree)
{
  const std::size_t last = knots.size() - 1;
  return knots[0] == knots[degree] && knots[last] == knots[last - degree];
}

/// Clamps the knots of one direction. Control point i for the knots `to` is the polar form, at to[i+1] ..
/// to[i+p], of the polynomial on any span of its support.
NURBSSurface ClampDirection(const NURBSSurface& surface, int direction)
{
  using Homogeneous = std::array<double, 4>;
  const int p = surface.Degree[direction];
  const std::vector<double>& from = surface.Knots[direction];
  const double start = surface.GetDomainStart(direction);
  const double end = surface.GetDomainEnd(direction);
  std::vector<double> to(p + 1, start);
  std::copy_if(from.begin(), from.end(), std::back_inserter(to),
    [start, end](double knot) { return knot > start && knot < end; });
  to.insert(to.end(), p + 1, end);

  NURBSSurface result = surface;
  const int count = static_cast<int>(to.size()) - p - 1;
  const int rows = surface.NumberOfControlPoints[1 - direction];
  result.Knots[direction] = to;
  result.NumberOfControlPoints[direction] = count;
  result.ControlPoints.resize(static_cast<std::size_t>(count) * rows);
  const auto index = [direction](const NURBSSurface& s, int i, int row)
  {
    const int u = direction == 0 ? i : row;
    const int v = direction == 0 ? row : i;
    return static_cast<std::size_t>(u) + static_cast<std::size_t>(v) * s.NumberOfControlPoints[0];
  };
  for (int i = 0; i < count; ++i)
  {
    int span = i;
    while (!(to[span] < to[span + 1]))
    {
      ++span;
    }
    const double middle = 0.5 * (to[span] + to[span + 1]);
    const int old = static_cast<int>(std::upper_bound(from.begin(), from.end(), middle) - from.begin()) - 1;
    const int shift = old - span;
    const bool same =
      i + shift >= 0 && std::equal(to.begin() + i + 1, to.begin() + i + p + 1, from.begin() + i + shift + 1);
    for (int row = 0; row < rows; ++row)
    {
      Homogeneous& point = result.ControlPoints[index(result, i, row)];
      if (same)
      {
        point = surface.ControlPoints[index(surface, i + shift, row)];
        continue;
      }
      Homogeneous d[MaximumDegree + 1];
      for (int j = 0; j <= p; ++j)
      {
        d[j] = surface.ControlPoints[index(surface, old - p + j, row)];
      }
      for (int level = 1; level <= p; ++level)
      {
        for (int j = p; j >= level; --j)
        {
          const double low = from[old - p + j];
          const double alpha = (to[i + level] - low) / (from[old + 1 + j - level] - low);
          for (int c = 0; c < 4; ++c)
          {
            d[j][c] = (1.0 - alpha) * d[j - 1][c] + alpha * d[j][c];
          }
        }
      }
      point = d[p];
    }
  }
  return result;
}

/// Returns the Bernstein coefficients of all pieces, raised to one degree; neighbours share their common
/// coefficient.
template <int Dimension>
std::vector<std::array<double, Dimension>> RaiseDegrees(const PolynomialCurve<Dimension>& curve, int& degree)
{
  degree = 1;
  for (int piece = 0; piece < curve.GetNumberOfPieces(); ++piece)
  {
    degree = std::max(degree, curve.GetDegree(piece));
  }
  std::vector<std::array<double, Dimension>> poles;
  for (int piece = 0; piece < curve.GetNumberOfPieces(); ++piece)
  {
    const auto source = curve.GetPiece(piece);
    std::vector<std::array<double, Dimension>> b(
      source.Coefficients, source.Coefficients + source.Degree + 1);
    while (static_cast<int>(b.size()) <= degree)
    {
      const std::size_t n = b.size();
      b.push_back(b.back());
      for (std::size_t i = n - 1; i > 0; --i)
      {
        // In this form constant coefficients remain constant bit for bit.
        const double weight = static_cast<double>(i) / static_cast<double>(n);
        for (int c = 0; c < Dimension; ++c)
        {
          b[i][c] += weight * (b[i - 1][c] - b[i][c]);
        }
      }
    }
    poles.insert(poles.end(), b.begin() + (piece > 0 ? 1 : 0), b.end());
  }
  return poles;
}

template <int Dimension>
KnotList MakeKnotList(const PolynomialCurve<Dimension>& curve, int degree)
{
  const int count = static_cast<int>(curve.Breaks.size());
  if (count < 2)
  {
    throw std::runtime_error("a curve of it has no pieces");
  }
  KnotList list{ TColStd_Array1OfReal(1, count), TColStd_Array1OfInteger(1, count) };
  for (int i = 0; i < count; ++i)
  {
    list.Knots(i + 1) = curve.Breaks[i];
    list.Multiplicities(i + 1) = i == 0 || i == count - 1 ? degree + 1 : degree;
  }
  return list;
}
}

NURBSSurface ClampKnots(const NURBSSurface& surface)
{
  NURBSSurface result = surface;
  for (int d = 0; d < 2; ++d)
  {
    if (!IsClamped(result.Knots[d], result.Degree[d]))
    {
      result = ClampDirection(result, d);
    }
  }
  return result;
}

Handle(Geom_BSplineSurface) BuildSurface(const NURBSSurface& source, const AffineMap& map)
{
  const std::string problem = source.Check();
  if (!problem.empty())
  {
    throw std::runtime_error(problem);
  }
  const NURBSSurface surface = ClampKnots(source);
  const int nu = surface.NumberOfControlPoints[0];
  const int nv = surface.NumberOfControlPoints[1];
  TColgp_Array2OfPnt poles(1, nu, 1, nv);
  TColStd_Array2OfReal weights(1, nu, 1, nv);
  bool rational = false;
  for (int j = 0; j < nv; ++j)
  {
    for (int i = 0; i < nu; ++i)
    {
      const std::array<double, 4>& h = surface.ControlPoints[i + static_cast<std::size_t>(j) * nu];
      const Vector3 p = map.MapPoint(gp_XYZ(h[0] / h[3], h[1] / h[3], h[2] / h[3]));
      poles(i + 1, j + 1) = gp_Pnt(p[0], p[1], p[2]);
      weights(i + 1, j + 1) = h[3];
      rational = rational || h[3] != surface.ControlPoints[0][3];
    }
  }
  const KnotList u = MakeKnotList(surface.Knots[0], surface.Degree[0]);
  const KnotList v = MakeKnotList(surface.Knots[1], surface.Degree[1]);
  if (rational)
  {
    return new Geom_BSplineSurface(poles, weights, u.Knots, v.Knots, u.Multiplicities, v.Multiplicities,
      surface.Degree[0], surface.Degree[1]);
  }
  return new Geom_BSplineSurface(
    poles, u.Knots, v.Knots, u.Multiplicities, v.Multiplicities, surface.Degree[0], surface.Degree[1]);
}

namespace
{
/// The first column of control points, rotated: a torus that crosses its axis. OpenCASCADE writes such a
/// torus to STEP files as the revolution of a polynomial spline, with an error of up to 1e-7 of the unit, and
/// takes points of a whole circle on the axis for poles when it reads one.
Handle(Geom_Surface)
  RevolveProfile(const NURBSSurface& surface, const AffineMap& map, const GeometricFrame& frame)
{
  const int count = surface.NumberOfControlPoints[1];
  TColgp_Array1OfPnt poles(1, count);
  TColStd_Array1OfReal weights(1, count);
  for (int j = 0; j < count; ++j)
  {
    const std::array<double, 4>& h =
      surface.ControlPoints[static_cast<std::size_t>(j) * surface.NumberOfControlPoints[0]];
    const Vector3 p = map.MapPoint(gp_XYZ(h[0] / h[3], h[1] / h[3], h[2] / h[3]));
    poles(j + 1) = gp_Pnt(p[0], p[1], p[2]);
    weights(j + 1) = h[3];
  }
  const KnotList knots = MakeKnotList(surface.Knots[1], surface.Degree[1]);
  const Vector3& z = frame.Axes[2];
  return new Geom_SurfaceOfRevolution(
    new Geom_BSplineCurve(poles, weights, knots.Knots, knots.Multiplicities, surface.Degree[1]),
    gp_Ax1(gp_Pnt(frame.Origin[0], frame.Origin[1], frame.Origin[2]), gp_Dir(z[0], z[1], z[2])));
}
}

std::optional<BuiltSurface> BuildElementarySurface(const NURBSSurface& surface, const AffineMap& map)
{
  NURBSSurface from = surface;
  AffineMap proper = map;
  if (map.IsMirrored())
  {
    // The image under a reflection, which is exact, is moved without one.
    for (std::array<double, 4>& h : from.ControlPoints)
    {
      h[0] = -h[0];
    }
    for (auto& row : proper.Linear)
    {
      row[0] = -row[0];
    }
  }
  BuiltSurface result;
  result.Native = FindNativeSurface(from);
  if (!result.Native)
  {
    return std::nullopt;
  }
  using Type = ElementarySurface::Type;
  ElementarySurface& elementary = result.Native->Surface;
  const double scale = proper.GetScale();
  elementary.Frame.Origin = proper.MapPoint(elementary.Frame.Origin);
  for (Vector3& axis : elementary.Frame.Axes)
  {
    axis = Normalized(proper.MapVector(axis));
  }
  for (int d = 0; d < 2; ++d)
  {
    elementary.Radii[d] *= scale;
    const bool isLength = elementary.Kind == Type::Plane ||
      (d == 1 && (elementary.Kind == Type::Cylinder || elementary.Kind == Type::Cone));
    if (isLength)
    {
      result.Native->Start[d] *= scale;
      result.Native->Linear[d][0] *= scale;
      result.Native->Linear[d][1] *= scale;
    }
  }
  if (elementary.Kind == Type::Torus && elementary.Radii[0] < elementary.Radii[1])
  {
    result.Surface = RevolveProfile(from, proper, elementary.Frame);
    result.Native->Parameters[1] = NativeParameter();
    result.Native->Start[1] = 0.0;
    result.Native->Linear[1][1] = 1.0;
    return result;
  }
  std::string problem;
  const SurfacePointer made = GeometricSurface::Make(elementary, problem);
  if (!made)
  {
    return std::nullopt;
  }
  result.Surface = MakeKernelSurface(*made);
  return result;
}

BuiltCurve BuildCurve(const EdgeCurve& source, const AffineMap& map)
{
  EdgeCurve curve = source;
  for (EdgeCurve::Point& p : curve.Coefficients)
  {
    p = map.MapPoint(p);
  }
  BuiltCurve result;
  if (const std::optional<NativeCurve> native = FindNativeCurve(curve))
  {
    std::string problem;
    const CurvePointer<3> value = GeometricCurve<3>::Make(native->Curve, problem);
    if (value)
    {
      result.Curve = MakeKernelCurve(*value);
      result.Start = native->Start;
      result.Factor = native->Factor;
      return result;
    }
  }
  int degree = 1;
  const std::vector<EdgeCurve::Point> points = RaiseDegrees<3>(curve, degree);
  TColgp_Array1OfPnt poles(1, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    poles(static_cast<int>(i) + 1) = gp_Pnt(points[i][0], points[i][1], points[i][2]);
  }
  const KnotList list = MakeKnotList<3>(curve, degree);
  result.Curve = new Geom_BSplineCurve(poles, list.Knots, list.Multiplicities, degree);
  return result;
}

Handle(Geom2d_Curve) BuildTrim(const TrimCurve& source, const BuiltCurve& edge)
{
  TrimCurve curve = source;
  for (double& t : curve.Breaks)
  {
    t = edge.Map(t);
  }
  const TrimCurve::Point& start = curve.GetStartPoint();
  const TrimCurve::Point& end = curve.GetEndPoint();
  const double length = std::hypot(end[0] - start[0], end[1] - start[1]);
  const double width = curve.GetEnd() - curve.GetStart();
  if (curve.GetNumberOfPieces() == 1 && curve.GetDegree(0) == 1 && curve.GetStart() == 0.0 &&
    std::abs(length - width) <= LineSpeed * width)
  {
    return new Geom2d_Line(gp_Pnt2d(start[0], start[1]), gp_Dir2d(end[0] - start[0], end[1] - start[1]));
  }
  int degree = 1;
  const std::vector<TrimCurve::Point> points = RaiseDegrees<2>(curve, degree);
  TColgp_Array1OfPnt2d poles(1, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    poles(static_cast<int>(i) + 1) = gp_Pnt2d(points[i][0], points[i][1]);
  }
  const KnotList list = MakeKnotList<2>(curve, degree);
  return new Geom2d_BSplineCurve(poles, list.Knots, list.Multiplicities, degree);
}
}
