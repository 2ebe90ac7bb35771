#include "Detail/smPlaneMoments.h"

#include "smCompensatedSum.h"
#include "smVector.h"

namespace sm
{
namespace
{
constexpr int NumberOfIntegrals = 11;

/// The plane S(u,v) = Center + (u - Middle[0]) U + (v - Middle[1]) V.
struct Plane
{
  Point3 Center, U, V;
  Point2 Start, End, Middle;

  explicit Plane(const NURBSSurface& surface)
  {
    for (int d = 0; d < 2; ++d)
    {
      this->Start[d] = surface.GetDomainStart(d);
      this->End[d] = surface.GetDomainEnd(d);
      this->Middle[d] = 0.5 * (this->Start[d] + this->End[d]);
    }
    // The corners are the control points only if the knots are clamped. The averages remove the first-order
    // effect of the twist that rounding leaves in a parallelogram.
    std::array<double, 4> p[4];
    surface.ExtractBezier(this->Start[0], this->End[0], this->Start[1], this->End[1], p);
    const double w = p[0][3];
    for (int c = 0; c < 3; ++c)
    {
      this->Center[c] = 0.25 * (p[0][c] + p[1][c] + p[2][c] + p[3][c]) / w;
      this->U[c] = 0.5 * ((p[1][c] - p[0][c]) + (p[3][c] - p[2][c])) / w / (this->End[0] - this->Start[0]);
      this->V[c] = 0.5 * ((p[2][c] - p[0][c]) + (p[3][c] - p[1][c])) / w / (this->End[1] - this->Start[1]);
    }
  }

  Point3 Evaluate(const Point2& p) const
  {
    Point3 x;
    for (int c = 0; c < 3; ++c)
    {
      x[c] = this->Center[c] + (p[0] - this->Middle[0]) * this->U[c] + (p[1] - this->Middle[1]) * this->V[c];
    }
    return x;
  }
};

/// Returns means over a triangle of products of linear functions, given by their values at its corners. They
/// are exact, by integral of l_i^a l_j^b l_k^c = 2 A a! b! c! / (a+b+c+2)! in barycentric coordinates.
double Mean(const Point3& f)
{
  return (f[0] + f[1] + f[2]) / 3.0;
}

double Mean(const Point3& f, const Point3& g)
{
  return ((f[0] + f[1] + f[2]) * (g[0] + g[1] + g[2]) + Dot(f, g)) / 12.0;
}

double Mean(const Point3& f, const Point3& g, const Point3& h)
{
  const double sumF = f[0] + f[1] + f[2];
  const double sumG = g[0] + g[1] + g[2];
  const double sumH = h[0] + h[1] + h[2];
  const double all = f[0] * g[0] * h[0] + f[1] * g[1] * h[1] + f[2] * g[2] * h[2];
  return (sumF * sumG * sumH + sumF * Dot(g, h) + sumG * Dot(f, h) + sumH * Dot(f, g) + 2.0 * all) / 60.0;
}

/// Adds the triangle's contribution to the integrals of z, x z, y z, z^2/2, x^2 z, y^2 z, z^3/3, x y z, y
/// z^2/2, x z^2/2 and 1 du dv.
void AddTriangle(const Plane& plane, const Point2 (&corners)[3], CompensatedSum (&sums)[NumberOfIntegrals])
{
  const double area = 0.5 *
    ((corners[1][0] - corners[0][0]) * (corners[2][1] - corners[0][1]) -
      (corners[2][0] - corners[0][0]) * (corners[1][1] - corners[0][1]));
  Point3 x, y, z;
  for (int i = 0; i < 3; ++i)
  {
    const Point3 point = plane.Evaluate(corners[i]);
    x[i] = point[0];
    y[i] = point[1];
    z[i] = point[2];
  }
  const double means[NumberOfIntegrals] = { Mean(z), Mean(x, z), Mean(y, z), 0.5 * Mean(z, z), Mean(x, x, z),
    Mean(y, y, z), Mean(z, z, z) / 3.0, Mean(x, y, z), 0.5 * Mean(y, z, z), 0.5 * Mean(x, z, z), 1.0 };
  for (int i = 0; i < NumberOfIntegrals; ++i)
  {
    sums[i].Add(area * means[i]);
  }
}

void AddPolygon(
  const Plane& plane, const std::vector<Point2>& polygon, CompensatedSum (&sums)[NumberOfIntegrals])
{
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    AddTriangle(plane, { plane.Middle, polygon[i], polygon[(i + 1) % polygon.size()] }, sums);
  }
}
}

std::array<double, 14> ComputePlaneMoments(const SubPatchFace& face)
{
  std::array<double, 14> moments{};
  if (!face.Planar || !face.Error.empty())
  {
    return moments;
  }
  const Plane plane(face.Source->Surface);
  const Point2& start = plane.Start;
  const Point2& end = plane.End;
  std::vector<std::vector<Point2>> whole;
  if (face.Polygons.Loops.empty())
  {
    whole = { { start, { end[0], start[1] }, end, { start[0], end[1] } } };
  }
  // Triangles of both signs cancel.
  CompensatedSum sums[NumberOfIntegrals];
  for (const std::vector<Point2>& polygon : whole.empty() ? face.Polygons.Loops : whole)
  {
    AddPolygon(plane, polygon, sums);
  }
  const double sign = face.Source->Reversed ? -1.0 : 1.0;
  const Point3 normal = { sign * (plane.U[1] * plane.V[2] - plane.U[2] * plane.V[1]),
    sign * (plane.U[2] * plane.V[0] - plane.U[0] * plane.V[2]),
    sign * (plane.U[0] * plane.V[1] - plane.U[1] * plane.V[0]) };
  double values[NumberOfIntegrals];
  for (int i = 0; i < NumberOfIntegrals; ++i)
  {
    values[i] = sums[i].Get();
  }
  for (int i = 0; i < 10; ++i)
  {
    moments[i] = normal[2] * values[i];
  }
  const double area = values[NumberOfIntegrals - 1];
  for (int c = 0; c < 3; ++c)
  {
    moments[10 + c] = normal[c] * area;
  }
  moments[13] = Norm(normal) * area;
  return moments;
}
}
