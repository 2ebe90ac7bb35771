#include "smOCCTNativeTrim.h"

#include "Geometry/smChebyshevFit.h"
#include "smOCCTSpline.h"

#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_OffsetCurve.hxx>

#include <algorithm>

namespace sm
{
std::array<double, 2> NativeTrim::Evaluate(double parameter) const
{
  if (this->Feet)
  {
    const std::array<double, 2> p = this->Feet->Evaluate(parameter);
    return { p[0] + this->Shift[0], p[1] + this->Shift[1] };
  }
  const gp_Pnt2d p = this->Curve->Value(parameter);
  return { p.X() + this->Shift[0], p.Y() + this->Shift[1] };
}

std::vector<double> NativeTrim::GetBreaks() const
{
  if (this->Feet)
  {
    return this->Feet->GetBreaks();
  }
  Handle(Geom2d_Curve) curve = GetBasis(this->Curve);
  while (const auto offset = Handle(Geom2d_OffsetCurve)::DownCast(curve))
  {
    curve = GetBasis(offset->BasisCurve());
  }
  if (const auto spline = Handle(Geom2d_BSplineCurve)::DownCast(curve))
  {
    return GetSplineBreaks(spline, this->First, this->Last);
  }
  return { this->First, this->Last };
}

Handle(Geom2d_Line) NativeTrim::GetLine() const
{
  return this->Feet ? Handle(Geom2d_Line)() : Handle(Geom2d_Line)::DownCast(GetBasis(this->Curve));
}

std::vector<std::array<double, 2>> NativeTrim::Sample() const
{
  std::vector<std::array<double, 2>> points;
  const std::vector<double> breaks = this->GetBreaks();
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
  {
    for (int i = 0; i <= FitOrder; ++i)
    {
      const double t =
        i == FitOrder ? breaks[k + 1] : breaks[k] + GetFitNodes()[i] * (breaks[k + 1] - breaks[k]);
      if (this->Feet)
      {
        points.push_back(this->Feet->Evaluate(t));
        continue;
      }
      const gp_Pnt2d p = this->Curve->Value(t);
      points.push_back({ p.X(), p.Y() });
    }
  }
  return points;
}

void NativeTrim::AddTo(NativeBox& box) const
{
  const auto add = [&box](double u, double v)
  {
    box.Low[0] = std::min(box.Low[0], u);
    box.High[0] = std::max(box.High[0], u);
    box.Low[1] = std::min(box.Low[1], v);
    box.High[1] = std::max(box.High[1], v);
  };
  if (const auto line = this->GetLine())
  {
    const gp_Pnt2d a = line->Value(this->First);
    const gp_Pnt2d b = line->Value(this->Last);
    add(a.X(), a.Y());
    add(b.X(), b.Y());
    return;
  }
  if (this->Feet)
  {
    this->Feet->VisitExtremes(add);
  }
  const std::vector<std::array<double, 2>> points = this->Samples.empty() ? this->Sample() : this->Samples;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    add(points[k][0], points[k][1]);
    // Between samples a smooth curve exceeds them by about an eighth of the second difference at most.
    const std::size_t i = k % (FitOrder + 1);
    if (i > 0 && i < FitOrder)
    {
      double raised[2];
      for (int d = 0; d < 2; ++d)
      {
        raised[d] = points[k][d] + 0.25 * (points[k][d] - 0.5 * (points[k - 1][d] + points[k + 1][d]));
      }
      add(raised[0], raised[1]);
    }
  }
}
}
