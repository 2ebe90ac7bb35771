/**
 * @file smSchemeFaces.h
 * @brief Surfaces and trimmed faces for the tests of the paper's schemes
 */
#ifndef smSchemeFaces_h
#define smSchemeFaces_h

#include "smFace.h"

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace smtest
{
using Point2 = std::array<double, 2>;
using Point3 = std::array<double, 3>;

/// Clamped knots of simple breaks.
inline std::vector<double> MakeKnots(int degree, const std::vector<double>& breaks)
{
  std::vector<double> knots(degree, breaks.front());
  knots.insert(knots.end(), breaks.begin(), breaks.end());
  knots.insert(knots.end(), degree, breaks.back());
  return knots;
}

/// A surface whose control points are given by their indices.
inline sm::NURBSSurface MakeSurface(int degreeU, int degreeV, const std::vector<double>& breaksU,
  const std::vector<double>& breaksV, const std::function<std::array<double, 4>(int, int)>& point)
{
  sm::NURBSSurface surface;
  surface.Degree[0] = degreeU;
  surface.Degree[1] = degreeV;
  surface.Knots[0] = MakeKnots(degreeU, breaksU);
  surface.Knots[1] = MakeKnots(degreeV, breaksV);
  for (int d = 0; d < 2; ++d)
  {
    surface.NumberOfControlPoints[d] = static_cast<int>(surface.Knots[d].size()) - surface.Degree[d] - 1;
  }
  for (int j = 0; j < surface.NumberOfControlPoints[1]; ++j)
  {
    for (int i = 0; i < surface.NumberOfControlPoints[0]; ++i)
    {
      surface.ControlPoints.push_back(point(i, j));
      surface.Rational = surface.Rational || surface.ControlPoints.back()[3] != surface.ControlPoints[0][3];
    }
  }
  return surface;
}

/// S(u,v) = origin + u U + v V on [u0,u1] x [v0,v1].
inline sm::NURBSSurface MakePlane(
  const Point3& origin, const Point3& u, const Point3& v, double u0, double u1, double v0, double v1)
{
  return MakeSurface(1, 1, { u0, u1 }, { v0, v1 },
    [&](int i, int j)
    {
      const double a = i == 0 ? u0 : u1;
      const double b = j == 0 ? v0 : v1;
      return std::array<double, 4>{ origin[0] + a * u[0] + b * v[0], origin[1] + a * u[1] + b * v[1],
        origin[2] + a * u[2] + b * v[2], 1.0 };
    });
}

/// S(u,v) = (u, v, a u^2 + b u v + c v^2), of degree 2 x 2: control points are polar forms, (s + t)/2 of u
/// and s t of u^2 at two neighbouring knots s, t.
inline sm::NURBSSurface MakeParaboloid(
  double a, double b, double c, const std::vector<double>& breaksU, const std::vector<double>& breaksV)
{
  const std::vector<double> knotsU = MakeKnots(2, breaksU);
  const std::vector<double> knotsV = MakeKnots(2, breaksV);
  return MakeSurface(2, 2, breaksU, breaksV,
    [&](int i, int j)
    {
      const double u = 0.5 * (knotsU[i + 1] + knotsU[i + 2]);
      const double v = 0.5 * (knotsV[j + 1] + knotsV[j + 2]);
      return std::array<double, 4>{ u, v,
        a * knotsU[i + 1] * knotsU[i + 2] + b * u * v + c * knotsV[j + 1] * knotsV[j + 2], 1.0 };
    });
}

/// A quarter of a cylinder lying along y: radius (1-u^2, ., 2u) / (1+u^2), y = length v, on [0,1] x [0,1].
/// From x = radius (u = 0) to z = radius. The normal Su x Sv = length (-z', 0, x') points to the axis.
inline sm::NURBSSurface MakeQuarterCylinder(double radius, double length)
{
  return MakeSurface(2, 1, { 0.0, 1.0 }, { 0.0, 1.0 },
    [radius, length](int i, int j)
    {
      const double w = i == 2 ? 2.0 : 1.0;
      return std::array<double, 4>{ i == 2 ? 0.0 : radius, w * length * j, i * radius, w };
    });
}

/// The same cylinder with the arc that readers make: weights 1, cos 45 degrees, 1.
inline sm::NURBSSurface MakeSymmetricQuarterCylinder(double radius, double length)
{
  return MakeSurface(2, 1, { 0.0, 1.0 }, { 0.0, 1.0 },
    [radius, length](int i, int j)
    {
      const double w = i == 1 ? std::sqrt(0.5) : 1.0;
      return std::array<double, 4>{ i == 2 ? 0.0 : w * radius, w * length * j, i == 0 ? 0.0 : w * radius, w };
    });
}

/// Control points on a grid, moved at random by `noise` of its spacing; weights e^(+-spread).
inline sm::NURBSSurface MakeRandomSurface(std::mt19937& random, int degreeU, int degreeV,
  const std::vector<double>& breaksU, const std::vector<double>& breaksV, double noise, double spread)
{
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  return MakeSurface(degreeU, degreeV, breaksU, breaksV,
    [&](int i, int j)
    {
      const double w = std::exp(spread * unit(random));
      const Point3 p = { i + noise * unit(random), j + noise * unit(random), 3.0 * noise * unit(random) };
      return std::array<double, 4>{ w * p[0], w * p[1], w * p[2], w };
    });
}

/// A coedge whose trim curve has these Bernstein pieces in loop direction; stored backwards when `reversed`.
inline sm::Coedge MakeCoedge(std::vector<std::vector<Point2>> pieces, bool reversed)
{
  sm::Coedge coedge;
  coedge.Reversed = reversed;
  coedge.Use = std::make_shared<sm::Edge>();
  coedge.Curve.Breaks = { 0.0 };
  if (reversed)
  {
    pieces = { pieces.rbegin(), pieces.rend() };
  }
  for (std::vector<Point2>& piece : pieces)
  {
    if (reversed)
    {
      piece = { piece.rbegin(), piece.rend() };
    }
    coedge.Curve.AppendPiece(
      coedge.Curve.Breaks.back() + 1.0, piece.data(), static_cast<int>(piece.size()) - 1);
  }
  return coedge;
}

/// Straight coedges; every other one runs against its edge.
inline sm::Loop MakePolygonLoop(const std::vector<Point2>& corners)
{
  sm::Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    loop.Coedges.push_back(MakeCoedge({ { corners[i], corners[(i + 1) % corners.size()] } }, i % 2 == 1));
  }
  return loop;
}

/// A closed loop about (x,y) of two coedges, each of two parabolas whose middle coefficients lie on the
/// tangents: with `bulge` beyond the chord by that part of the corner between the ends. Area: MakeLeafArea.
inline sm::Loop MakeLeaf(double x, double y, double radius, double bulge, bool clockwise)
{
  sm::Loop loop;
  std::vector<std::vector<Point2>> pieces;
  for (int i = 0; i < 4; ++i)
  {
    const int from = clockwise ? 4 - i : i;
    const int to = clockwise ? 3 - i : i + 1;
    const Point2 corners[4] = { { 1.0, 0.0 }, { 0.0, 1.0 }, { -1.0, 0.0 }, { 0.0, -1.0 } };
    const Point2& a = corners[from % 4];
    const Point2& b = corners[to % 4];
    pieces.push_back({ { x + radius * a[0], y + radius * a[1] },
      { x + radius * (0.5 + bulge) * (a[0] + b[0]), y + radius * (0.5 + bulge) * (a[1] + b[1]) },
      { x + radius * b[0], y + radius * b[1] } });
  }
  loop.Coedges.push_back(MakeCoedge({ pieces[0], pieces[1] }, false));
  loop.Coedges.push_back(MakeCoedge({ pieces[2], pieces[3] }, true));
  return loop;
}

/// The square of half diagonal `radius`, 2 r^2, and four segments of a parabola, each 2/3 of its triangle
/// with base r sqrt 2 and height sqrt 2 bulge r: (2/3) bulge r^2 each.
inline double GetLeafArea(double radius, double bulge)
{
  return radius * radius * (2.0 + 4.0 * 2.0 / 3.0 * bulge);
}

inline sm::FacePointer MakeFace(
  const sm::NURBSSurface& surface, const std::vector<sm::Loop>& loops, bool reversed = false)
{
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  face->FileId = 31;
  face->Surface = surface;
  face->Loops = loops;
  face->Reversed = reversed;
  return face;
}
}

#endif
