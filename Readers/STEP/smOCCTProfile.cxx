#include "smOCCTProfile.h"

#include "smOCCTCurve.h"
#include "smOCCTSpline.h"

#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_TrimmedCurve.hxx>

#include <algorithm>

namespace sm
{
namespace
{
/// Sets the homogeneous poles of a conic: w * position = w * center + c X + s Y.
void SetConic(Profile& profile, const gp_XYZ& center, const gp_XYZ& x, const gp_XYZ& y)
{
  profile.Degree = 2;
  profile.Knots = profile.Map.GetKnots();
  for (const Vector3& p : profile.Map.GetControlPoints())
  {
    const gp_XYZ h = p[2] * center + (p[0] * x + p[1] * y);
    profile.Poles.push_back({ h.X(), h.Y(), h.Z(), p[2] });
  }
}

void SetBezierKnots(Profile& profile, int degree, double low, double high)
{
  profile.Degree = degree;
  profile.Knots.assign(degree + 1, low);
  profile.Knots.insert(profile.Knots.end(), degree + 1, high);
}

/// Sets a piecewise fit, raised to one degree, with knots of multiplicity equal to the degree.
void SetFit(Profile& profile, const Handle(Geom_Curve) & curve, double low, double high)
{
  const EdgeCurve fit = FitEdge(curve, low, high, AffineMap());
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

Profile ConvertProfile(const Handle(Geom_Curve) & source, double low, double high)
{
  Handle(Geom_Curve) curve = source;
  while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve))
  {
    curve = trimmed->BasisCurve();
  }
  Profile profile;
  if (Handle(Geom_Line)::DownCast(curve))
  {
    SetBezierKnots(profile, 1, low, high);
    for (const double t : { low, high })
    {
      const gp_Pnt p = curve->Value(t);
      profile.Poles.push_back({ p.X(), p.Y(), p.Z(), 1.0 });
    }
  }
  else if (const auto circle = Handle(Geom_Circle)::DownCast(curve))
  {
    const gp_Ax2& f = circle->Position();
    profile.Map = ParameterMap::MakeCircular(low, high);
    SetConic(profile, f.Location().XYZ(), circle->Radius() * f.XDirection().XYZ(),
      circle->Radius() * f.YDirection().XYZ());
  }
  else if (const auto ellipse = Handle(Geom_Ellipse)::DownCast(curve))
  {
    const gp_Ax2& f = ellipse->Position();
    profile.Map = ParameterMap::MakeCircular(low, high);
    SetConic(profile, f.Location().XYZ(), ellipse->MajorRadius() * f.XDirection().XYZ(),
      ellipse->MinorRadius() * f.YDirection().XYZ());
  }
  else if (const auto hyperbola = Handle(Geom_Hyperbola)::DownCast(curve))
  {
    const gp_Ax2& f = hyperbola->Position();
    profile.Map = ParameterMap::MakeHyperbolic(low, high);
    SetConic(profile, f.Location().XYZ(), hyperbola->MajorRadius() * f.XDirection().XYZ(),
      hyperbola->MinorRadius() * f.YDirection().XYZ());
  }
  else if (const auto parabola = Handle(Geom_Parabola)::DownCast(curve))
  {
    // P(t) = C + t^2/(4F) X + t Y; blossom t1 t2/(4F) X + (t1 + t2)/2 Y.
    const gp_Ax2& f = parabola->Position();
    SetBezierKnots(profile, 2, low, high);
    for (const auto& t : { std::array<double, 2>{ low, low }, { low, high }, { high, high } })
    {
      const gp_XYZ p = f.Location().XYZ() + t[0] * t[1] / (4.0 * parabola->Focal()) * f.XDirection().XYZ() +
        0.5 * (t[0] + t[1]) * f.YDirection().XYZ();
      profile.Poles.push_back({ p.X(), p.Y(), p.Z(), 1.0 });
    }
  }
  else if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve))
  {
    const FlatKnots flat = MakeFlatKnots(
      spline->Degree(), spline->Knots(), spline->Multiplicities(), spline->IsPeriodic(), low, high);
    profile.Degree = flat.Degree;
    profile.Knots = flat.Knots;
    for (const int i : flat.Poles)
    {
      const double w = spline->IsRational() ? spline->Weight(i + 1) : 1.0;
      const gp_Pnt p = spline->Pole(i + 1);
      profile.Poles.push_back({ w * p.X(), w * p.Y(), w * p.Z(), w });
    }
  }
  else if (const auto bezier = Handle(Geom_BezierCurve)::DownCast(curve))
  {
    SetBezierKnots(profile, bezier->Degree(), 0.0, 1.0);
    for (int i = 1; i <= bezier->NbPoles(); ++i)
    {
      const double w = bezier->IsRational() ? bezier->Weight(i) : 1.0;
      const gp_Pnt p = bezier->Pole(i);
      profile.Poles.push_back({ w * p.X(), w * p.Y(), w * p.Z(), w });
    }
  }
  else
  {
    SetFit(profile, curve, low, high);
  }
  return profile;
}
}
