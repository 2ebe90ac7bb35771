#include "smParameterMap.h"

#include "smUnitRoundoff.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sm
{
namespace
{
double SnapToZero(double value)
{
  return std::abs(value) < 4.0 * UnitRoundoff ? 0.0 : value;
}
}

Vector3 AffineMap::MapVector(const Vector3& v) const
{
  Vector3 r;
  for (int i = 0; i < 3; ++i)
  {
    r[i] = this->Linear[i][0] * v[0] + this->Linear[i][1] * v[1] + this->Linear[i][2] * v[2];
  }
  return r;
}

Vector3 AffineMap::MapPoint(const Vector3& p) const
{
  Vector3 r = this->MapVector(p);
  for (int i = 0; i < 3; ++i)
  {
    r[i] += this->Translation[i];
  }
  return r;
}

bool AffineMap::IsMirrored() const
{
  const auto& m = this->Linear;
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) <
    0.0;
}

double AffineMap::GetScale() const
{
  const auto& m = this->Linear;
  return std::sqrt(m[0][0] * m[0][0] + m[1][0] * m[1][0] + m[2][0] * m[2][0]);
}

ParameterMap ParameterMap::MakeCircular(double low, double high)
{
  ParameterMap map;
  map.Type = Kind::Circular;
  map.Start = low;
  double turn = high - low;
  if (!(std::max(std::abs(low), std::abs(high)) <= MaximumTurns * 2.0 * vtkMath::Pi()))
  {
    throw std::runtime_error("it covers an angle that no face has");
  }
  if (std::abs(turn - 2.0 * vtkMath::Pi()) < 1e-9)
  {
    turn = 2.0 * vtkMath::Pi();
  }
  map.Count = std::max(1, static_cast<int>(std::ceil(turn / (0.5 * vtkMath::Pi()) - 1e-9)));
  map.Width = turn / map.Count;
  return map;
}

ParameterMap ParameterMap::MakeHyperbolic(double low, double high)
{
  ParameterMap map;
  map.Type = Kind::Hyperbolic;
  map.Start = low;
  map.Width = high - low;
  return map;
}

int ParameterMap::FindArc(double native) const
{
  const double arc = std::floor((native - this->Start) / this->Width);
  return static_cast<int>(std::clamp(arc, 0.0, this->Count - 1.0));
}

double ParameterMap::EvaluateInArc(int arc, double native) const
{
  const double phi = native - (this->Start + (arc + 0.5) * this->Width);
  const double ratio = this->Type == Kind::Hyperbolic ? std::tanh(0.5 * phi) / std::tanh(0.25 * this->Width)
                                                      : std::tan(0.5 * phi) / std::tan(0.25 * this->Width);
  const double s = 0.5 * (1.0 + ratio);
  // A parameter within rounding of a border counts as on the border, because trim curves are cut there.
  const double rounding = this->GetRounding();
  if (std::abs(s) <= rounding)
  {
    return arc;
  }
  if (std::abs(s - 1.0) <= rounding)
  {
    return arc + 1.0;
  }
  return arc + s;
}

double ParameterMap::GetMaxSlope() const
{
  // The slope is largest at the ends of an arc, and in the middle of a piece of a hyperbola.
  return this->Type == Kind::Identity ? 1.0
    : this->Type == Kind::Hyperbolic  ? 0.25 / std::tanh(0.25 * this->Width)
                                      : 0.5 / std::sin(0.5 * this->Width);
}

double ParameterMap::GetRounding() const
{
  if (this->Type == Kind::Identity)
  {
    return 0.0;
  }
  const double largest = std::max(std::abs(this->Start), std::abs(this->GetBorder(this->Count)));
  return 4.0 * UnitRoundoff * std::max(1.0, largest / this->Width);
}

std::vector<Vector3> ParameterMap::GetControlPoints() const
{
  std::vector<Vector3> points;
  const double half = 0.5 * this->Width;
  for (int k = 0; k <= 2 * this->Count; ++k)
  {
    const double angle = this->Start + k * half;
    if (this->Type == Kind::Hyperbolic)
    {
      // The middle control point is the intersection of the tangents at the ends, times its weight, cosh of
      // the half opening.
      points.push_back({ std::cosh(angle), std::sinh(angle), k % 2 ? std::cosh(half) : 1.0 });
    }
    else
    {
      points.push_back(
        { SnapToZero(std::cos(angle)), SnapToZero(std::sin(angle)), k % 2 ? std::cos(half) : 1.0 });
    }
  }
  return points;
}

std::vector<double> ParameterMap::GetKnots() const
{
  std::vector<double> knots{ 0.0 };
  for (int k = 0; k <= this->Count; ++k)
  {
    knots.insert(knots.end(), 2, k);
  }
  knots.push_back(this->Count);
  return knots;
}
}
