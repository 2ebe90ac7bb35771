#include "smGeometryConversion.h"

#include "smCurveFit.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Sets the homogeneous poles of a conic: w * position = w * center + c X + s Y.
void SetConic(RationalProfile& profile, const ConicCurve<3>& conic)
{
  profile.Degree = 2;
  profile.Knots = profile.Map.GetKnots();
  for (const Vector3& p : profile.Map.GetControlPoints())
  {
    std::array<double, 4> h{ 0.0, 0.0, 0.0, p[2] };
    for (int c = 0; c < 3; ++c)
    {
      h[c] = p[2] * conic.Center[c] +
        (p[0] * (conic.Radii[0] * conic.X[c]) + p[1] * (conic.Radii[1] * conic.Y[c]));
    }
    profile.Poles.push_back(h);
  }
}

void SetBezierKnots(RationalProfile& profile, int degree, double low, double high)
{
  profile.Degree = degree;
  profile.Knots.assign(degree + 1, low);
  profile.Knots.insert(profile.Knots.end(), degree + 1, high);
}

/// P(t) = C + t^2/(4F) X + t Y; blossom t1 t2/(4F) X + (t1 + t2)/2 Y.
void SetParabola(RationalProfile& profile, const ConicCurve<3>& parabola, double low, double high)
{
  SetBezierKnots(profile, 2, low, high);
  for (const auto& t : { std::array<double, 2>{ low, low }, { low, high }, { high, high } })
  {
    std::array<double, 4> h{ 0.0, 0.0, 0.0, 1.0 };
    const double x = t[0] * t[1] / (4.0 * parabola.Radii[0]);
    const double y = 0.5 * (t[0] + t[1]);
    for (int c = 0; c < 3; ++c)
    {
      h[c] = parabola.Center[c] + x * parabola.X[c] + y * parabola.Y[c];
    }
    profile.Poles.push_back(h);
  }
}

/// Sets a piecewise fit, raised to one degree, with knots of multiplicity equal to the degree.
void SetFit(RationalProfile& profile, const GeometricCurve<3>& curve, double low, double high)
{
  const EdgeCurve fit =
    FitEdge([&curve](double t) { return curve.Evaluate(t); }, curve.GetBreaks(low, high), 0.0);
  const int pieces = fit.GetNumberOfPieces();
  int degree = 1;
  for (int i = 0; i < pieces; ++i)
  {
    degree = std::max(degree, fit.GetDegree(i));
  }
  profile.Degree = degree;
  profile.Residual = std::hypot(fit.Residual[0], fit.Residual[1], fit.Residual[2]);
  profile.Knots.assign(1, fit.Breaks.front());
  for (const double t : fit.Breaks)
  {
    profile.Knots.insert(profile.Knots.end(), degree, t);
  }
  profile.Knots.push_back(fit.Breaks.back());
  for (int i = 0; i < pieces; ++i)
  {
    std::vector<Vector3> b(
      fit.Coefficients.begin() + fit.Offsets[i], fit.Coefficients.begin() + fit.Offsets[i + 1]);
    while (static_cast<int>(b.size()) <= degree)
    {
      const int n = static_cast<int>(b.size());
      std::vector<Vector3> raised(n + 1, b[n - 1]);
      raised[0] = b[0];
      for (int j = 1; j < n; ++j)
      {
        const double share = static_cast<double>(j) / n;
        for (int c = 0; c < 3; ++c)
        {
          raised[j][c] = share * b[j - 1][c] + (1.0 - share) * b[j][c];
        }
      }
      b = raised;
    }
    for (int j = i == 0 ? 0 : 1; j <= degree; ++j)
    {
      profile.Poles.push_back({ b[j][0], b[j][1], b[j][2], 1.0 });
    }
  }
}
}

RationalProfile ConvertProfile(const GeometricCurve<3>& curve, double low, double high)
{
  RationalProfile profile;
  if (curve.GetIf<LineCurve<3>>())
  {
    SetBezierKnots(profile, 1, low, high);
    for (const double t : { low, high })
    {
      const Vector3 p = curve.Evaluate(t);
      profile.Poles.push_back({ p[0], p[1], p[2], 1.0 });
    }
  }
  else if (const auto* conic = curve.GetIf<ConicCurve<3>>())
  {
    if (conic->Kind == ConicCurve<3>::Type::Parabola)
    {
      SetParabola(profile, *conic, low, high);
      return profile;
    }
    profile.Map = conic->Kind == ConicCurve<3>::Type::Ellipse ? ParameterMap::MakeCircular(low, high)
                                                              : ParameterMap::MakeHyperbolic(low, high);
    SetConic(profile, *conic);
  }
  else if (const auto* spline = curve.GetIf<SplineCurve<3>>())
  {
    const FlatKnots flat = spline->Basis.Flatten(low, high);
    profile.Degree = flat.Degree;
    profile.Knots = flat.Knots;
    for (const int i : flat.Poles)
    {
      const double w = spline->Weights.empty() ? 1.0 : spline->Weights[i];
      const Vector3& p = spline->Poles[i];
      profile.Poles.push_back({ w * p[0], w * p[1], w * p[2], w });
    }
  }
  else
  {
    SetFit(profile, curve, low, high);
  }
  return profile;
}

EdgeCurve ConvertCurve(const GeometricCurve<3>& curve, double first, double last, const AffineMap& map)
{
  EdgeCurve result;
  if (curve.GetIf<LineCurve<3>>())
  {
    const Vector3 ends[2] = { map.MapPoint(curve.Evaluate(first)), map.MapPoint(curve.Evaluate(last)) };
    result.Breaks.push_back(first);
    result.AppendPiece(last, ends, 1);
    return result;
  }
  const auto* spline = curve.GetIf<SplineCurve<3>>();
  if (spline && spline->Weights.empty())
  {
    const FlatKnots flat = spline->Basis.Flatten(first, last);
    std::vector<Vector3> poles;
    for (const int i : flat.Poles)
    {
      poles.push_back(map.MapPoint(spline->Poles[i]));
    }
    const std::vector<double> breaks = MakeBreaks(first, last, flat.Knots);
    result.Breaks.push_back(first);
    Vector3 piece[MaximumDegree + 1];
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
      ExtractBezierPiece<3>(flat, poles, breaks[i], breaks[i + 1], piece);
      result.AppendPiece(breaks[i + 1], piece, flat.Degree);
    }
    return result;
  }
  // Values are rounded before a translation that may cancel most of them.
  const Vector3& t = map.Translation;
  return FitEdge([&](double x) { return map.MapPoint(curve.Evaluate(x)); }, curve.GetBreaks(first, last),
    std::max({ std::abs(t[0]), std::abs(t[1]), std::abs(t[2]) }));
}
}
