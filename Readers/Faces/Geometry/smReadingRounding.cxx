#include "smReadingRounding.h"

#include "smUnitRoundoff.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// Roundings of every coordinate: conversion of its decimals, and the subtraction of the origin.
constexpr int Plain = 2;
// Roundings by another output unit: its factor, and the product.
constexpr int Scaled = 2;
// Roundings by a rotation: entries of the matrix, which come from normalized directions and products of
// placements, and three products each.
constexpr int Rotated = 16;
// Roundings of a profile's distance from its axis, or of an offset.
constexpr int Profiled = 6;
// Roundings of lengths in a local frame: directions are normalized, made orthogonal, mapped, and multiplied
// by sines and cosines.
constexpr int Framed = 16;
// Roundings of weights, relative to distances between control points.
constexpr int Weighted = 4;

Vector3 GetPoint(const std::array<double, 4>& h)
{
  return { h[0] / h[3], h[1] / h[3], h[2] / h[3] };
}

/// The local frame of an elementary surface, if the surface has one.
struct Frame
{
  bool Exists = false;
  Vector3 Location{};
  /// True if its directions are exactly those of the coordinate axes.
  bool Aligned = false;
};

bool IsAxis(const Vector3& direction)
{
  const double largest = std::max({ std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2]) });
  return std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2]) == largest &&
    largest == 1.0;
}

Frame GetFrame(const GeometricSurface& surface, const AffineMap& map)
{
  if (const auto* elementary = surface.GetIf<ElementarySurface>())
  {
    const GeometricFrame& frame = elementary->Frame;
    return { true, map.MapPoint(frame.Origin), IsAxis(frame.Axes[2]) && IsAxis(frame.Axes[0]) };
  }
  if (const auto* revolution = surface.GetIf<RevolvedSurface>())
  {
    return { true, map.MapPoint(revolution->Origin), false };
  }
  return {};
}

bool IsRotated(const AffineMap& map)
{
  const double scale = std::abs(map.Linear[0][0]);
  bool rotated = false;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      rotated = rotated || map.Linear[i][j] != (i == j ? scale : 0.0);
    }
  }
  return rotated;
}

/**
 * Returns a bound of the displacement of the surface by the rounding of the knots t_j of one direction. The
 * derivative with respect to a knot is a B-spline whose knots have t_j once more, with coefficients (P_(i+1)
 * - P_i) / (t_(i+p+1) - t_(i+1)); a point depends on p knots before and after it. With weights these are
 * differences of homogeneous points relative to a point of the surface, divided by weights between w_i and
 * w_(i+1), which the surface has after the insertion of t_j. A knot moves no control point beyond its
 * neighbour, and differences whose support does not meet the box, which the face covers, are not counted.
 */
double GetKnotRounding(const NURBSSurface& surface, int direction, const NativeBox& box, double diameter)
{
  const int p = surface.Degree[direction];
  const int count = surface.NumberOfControlPoints[direction];
  const std::size_t stride = direction == 0 ? 1 : static_cast<std::size_t>(surface.NumberOfControlPoints[0]);
  const std::vector<double>& knots = surface.Knots[direction];
  double largest = 0.0;
  for (std::size_t k = 0; k + stride < surface.ControlPoints.size(); ++k)
  {
    const int i = static_cast<int>(k / stride) % count;
    if (i + 1 < count && knots[i + 1] < box.High[direction] && knots[i + p + 1] > box.Low[direction])
    {
      const std::array<double, 4>& a = surface.ControlPoints[k];
      const std::array<double, 4>& b = surface.ControlPoints[k + stride];
      const double step = b[3] * Norm(Subtract(GetPoint(b), GetPoint(a))) + std::abs(b[3] - a[3]) * diameter;
      const double moved = UnitRoundoff * std::max(std::abs(knots[i + 1]), std::abs(knots[i + p + 1]));
      const double width = knots[i + p + 1] - knots[i + 1];
      largest = std::max(largest, (moved < width ? moved / width : 1.0) * step / std::min(a[3], b[3]));
    }
  }
  return 2.0 * p * largest;
}

/// Returns a bound of the displacement of a spline by the rounding of its weights and knots.
double GetSplineRounding(const NURBSSurface& surface, const NativeBox& box, double diameter)
{
  return (surface.Rational ? Weighted * UnitRoundoff * diameter : 0.0) +
    GetKnotRounding(surface, 0, box, diameter) + GetKnotRounding(surface, 1, box, diameter);
}
}

std::array<double, 3> GetReadingRounding(const GeometricSurface& source, const NativeBox& box,
  const AffineMap& map, const double origin[3], int roundings, const NURBSSurface& converted)
{
  const Frame frame = GetFrame(source, map);
  Vector3 reach{};
  Vector3 fromFrame{};
  Vector3 low = GetPoint(converted.ControlPoints[0]);
  Vector3 high = low;
  for (const std::array<double, 4>& h : converted.ControlPoints)
  {
    const Vector3 point = GetPoint(h);
    for (int c = 0; c < 3; ++c)
    {
      low[c] = std::min(low[c], point[c]);
      high[c] = std::max(high[c], point[c]);
    }
  }
  const bool spline = source.GetIf<SplineSurface>() != nullptr;
  const bool rotated = IsRotated(map);
  const int steps = Plain + roundings + (map.GetScale() != 1.0 ? Scaled : 0) + (rotated ? Rotated : 0) +
    (spline || source.GetIf<ElementarySurface>() ? 0 : Profiled);
  for (int c = 0; c < 3; ++c)
  {
    reach[c] = std::max(std::abs(low[c] + origin[c]), std::abs(high[c] + origin[c]));
    if (frame.Exists)
    {
      reach[c] = std::max(reach[c], std::abs(frame.Location[c] + origin[c]));
      fromFrame[c] = std::max(frame.Location[c] - low[c], high[c] - frame.Location[c]);
    }
    // Before the placement, a coordinate may have been as large as the translation plus its present value.
    reach[c] += 2.0 * std::abs(map.Translation[c] + origin[c]);
  }
  const double spread = spline ? GetSplineRounding(converted, box, Norm(Subtract(high, low))) : 0.0;
  Vector3 rounding;
  for (int c = 0; c < 3; ++c)
  {
    // With a frame along the axes each coordinate has only its own errors, not those of the others.
    const double near = frame.Aligned && !rotated ? fromFrame[c] : Norm(fromFrame);
    rounding[c] = UnitRoundoff * (steps * (rotated ? Norm(reach) : reach[c]) + Framed * near) + spread;
  }
  return rounding;
}
}
