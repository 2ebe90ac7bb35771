#include "smNativeSurface.h"

#include "smChebyshevFit.h"
#include "smPlacement.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace sm
{
namespace
{
constexpr double WholeCircle = 2.0 * vtkMath::Pi();
constexpr double NativeTrimTolerance = 4e-14;
constexpr int NativeTrimDegree = 12;
constexpr int NativeTrimDepth = 10;

/// Fits the image of one piece of a trim curve; halves it where one polynomial does not suffice.
class TrimMapper
{
public:
  TrimMapper(const TrimCurve& trim, const NativeSurface& native)
    : Trim(trim)
    , Native(native)
  {
    // Lengths are rounded as those from which they follow, also where they are 0 themselves.
    double extent[2] = { std::max(native.Surface.Radii[0], std::abs(native.Start[0])),
      std::max(native.Surface.Radii[0], std::abs(native.Start[1])) };
    for (const TrimCurve::Point& p : trim.Coefficients)
    {
      const std::array<double, 2> q = native.Map(p[0], p[1]);
      for (int d = 0; d < 2; ++d)
      {
        extent[d] = std::max(extent[d], std::abs(q[d]));
      }
    }
    for (int d = 0; d < 2; ++d)
    {
      this->Tolerance[d] = NativeTrimTolerance * (native.Parameters[d].IsCircular ? 1.0 : extent[d]) + 1e-300;
    }
  }

  std::optional<TrimCurve> Map()
  {
    this->Result.Breaks.push_back(this->Trim.GetStart());
    if (this->MapStraight())
    {
      return std::move(this->Result);
    }
    if (!this->Native.Parameters[0].IsCircular && !this->Native.Parameters[1].IsCircular)
    {
      // The image under an affine map has the images of the coefficients.
      this->Result = this->Trim;
      for (TrimCurve::Point& p : this->Result.Coefficients)
      {
        p = this->Native.Map(p[0], p[1]);
      }
      return std::move(this->Result);
    }
    for (int piece = 0; piece < this->Trim.GetNumberOfPieces(); ++piece)
    {
      if (!this->MapPiece(piece, 0.0, 1.0, 0))
      {
        return std::nullopt;
      }
    }
    return std::move(this->Result);
  }

private:
  using Samples = std::array<std::array<double, 2>, FitOrder + 1>;

  TrimCurve::Point GetNative(int piece, double x) const
  {
    const TrimCurve::Point p = this->Trim.GetPiece(piece).Evaluate(x);
    return this->Native.Map(p[0], p[1]);
  }

  bool MapStraight()
  {
    const int last = this->Trim.GetNumberOfPieces() - 1;
    const TrimCurve::Point ends[2] = { this->GetNative(0, 0.0), this->GetNative(last, 1.0) };
    const double start = this->Trim.GetStart();
    const double length = this->Trim.GetEnd() - start;
    for (int piece = 0; piece <= last; ++piece)
    {
      const double from = this->Trim.Breaks[piece];
      const double width = this->Trim.Breaks[piece + 1] - from;
      for (const double x : GetFitNodes())
      {
        const TrimCurve::Point p = this->GetNative(piece, x);
        const double share = (from + x * width - start) / length;
        for (int d = 0; d < 2; ++d)
        {
          if (std::abs(p[d] - ((1.0 - share) * ends[0][d] + share * ends[1][d])) > this->Tolerance[d])
          {
            return false;
          }
        }
      }
    }
    this->Result.AppendPiece(this->Trim.GetEnd(), ends, 1);
    return true;
  }

  bool MapPiece(int piece, double low, double high, int depth)
  {
    Samples samples;
    for (int i = 0; i <= FitOrder; ++i)
    {
      samples[i] = this->GetNative(piece, i == FitOrder ? high : low + GetFitNodes()[i] * (high - low));
    }
    FittedPiece<2> fitted;
    const bool met = FitPiece<2>(samples, NativeTrimDegree, this->Tolerance, fitted) &&
      fitted.Residual[0] <= 4.0 * this->Tolerance[0] && fitted.Residual[1] <= 4.0 * this->Tolerance[1];
    if (!met)
    {
      const double middle = 0.5 * (low + high);
      return depth < NativeTrimDepth && this->MapPiece(piece, low, middle, depth + 1) &&
        this->MapPiece(piece, middle, high, depth + 1);
    }
    const double from = this->Trim.Breaks[piece];
    const double to = this->Trim.Breaks[piece + 1];
    const double end = high == 1.0 ? to : from + high * (to - from);
    if (!(end > this->Result.Breaks.back()))
    {
      return false;
    }
    this->Result.AppendPiece(end, fitted.Coefficients.data(), fitted.Degree);
    return true;
  }

  const TrimCurve& Trim;
  const NativeSurface& Native;
  std::array<double, 2> Tolerance{};
  TrimCurve Result;
};
}

std::optional<NativeCurve> FindNativeCurve(const EdgeCurve& curve)
{
  const Vector3& start = curve.GetStartPoint();
  const double length = curve.GetEnd() - curve.GetStart();
  double size = 0.0;
  double magnitude = 0.0;
  for (const Vector3& p : curve.Coefficients)
  {
    size = std::max(size, GetDistance(p, start));
    magnitude = std::max({ magnitude, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  const double allowed = 1e-13 * size + 32.0 * UnitRoundoff * magnitude;
  const auto follows = [&](const std::function<Vector3(double)>& evaluate)
  {
    for (int piece = 0; piece < curve.GetNumberOfPieces(); ++piece)
    {
      const double width = curve.Breaks[piece + 1] - curve.Breaks[piece];
      for (const double x : GetFitNodes())
      {
        const double t = curve.Breaks[piece] + x * width;
        if (!(GetDistance(curve.GetPiece(piece).Evaluate(x), evaluate((t - curve.GetStart()) / length)) <=
              allowed))
        {
          return false;
        }
      }
    }
    return true;
  };
  const Vector3 chord = Subtract(curve.GetEndPoint(), start);
  if (Norm(chord) > 1e3 * allowed &&
    follows([&](double share) { return Sum(start, Multiply(share, chord)); }))
  {
    return NativeCurve{ LineCurve<3>{ start, Normalized(chord) }, curve.GetStart(), Norm(chord) / length };
  }
  // Two points at thirds of an arc of at most one turn are neither each other nor the start.
  const Vector3 a = Subtract(curve.Evaluate(curve.GetStart() + length / 3.0), start);
  const Vector3 b = Subtract(curve.Evaluate(curve.GetStart() + 2.0 * length / 3.0), start);
  const Vector3 normal = Cross(a, b);
  const double square = Dot(normal, normal);
  if (!(std::sqrt(square) > 1e-4 * Norm(a) * Norm(b)))
  {
    return std::nullopt;
  }
  // The centre of the circle through 0, a and b.
  const Vector3 center =
    Multiply(0.5 / square, Sum(Multiply(Dot(a, a), Cross(b, normal)), Multiply(Dot(b, b), Cross(normal, a))));
  ConicCurve<3> circle;
  circle.Kind = ConicCurve<3>::Type::Ellipse;
  circle.Center = Sum(start, center);
  circle.Radii[0] = circle.Radii[1] = Norm(center);
  circle.X = Normalized(Multiply(-1.0, center));
  circle.Y = Cross(Normalized(normal), circle.X);
  const Vector3 first = Subtract(a, center);
  double third = std::atan2(Dot(first, circle.Y), Dot(first, circle.X));
  third = third < 0.0 ? third + WholeCircle : third;
  const double turn = std::abs(3.0 * third - WholeCircle) < 1e-9 ? WholeCircle : 3.0 * third;
  if (turn > WholeCircle ||
    !follows(
      [&](double share)
      {
        return Sum(circle.Center,
          Multiply(circle.Radii[0],
            Sum(Multiply(std::cos(share * turn), circle.X), Multiply(std::sin(share * turn), circle.Y))));
      }))
  {
    return std::nullopt;
  }
  return NativeCurve{ circle, curve.GetStart(), turn / length };
}

std::optional<TrimCurve> MapTrim(const TrimCurve& trim, const NativeSurface& native)
{
  try
  {
    return TrimMapper(trim, native).Map();
  }
  catch (const std::runtime_error&)
  {
    return std::nullopt;
  }
}
}
