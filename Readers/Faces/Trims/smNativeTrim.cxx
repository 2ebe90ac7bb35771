#include "smNativeTrim.h"

#include "Geometry/smChebyshevFit.h"

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
  const std::array<double, 2> p = this->Curve->Evaluate(parameter);
  return { p[0] + this->Shift[0], p[1] + this->Shift[1] };
}

std::vector<double> NativeTrim::GetBreaks() const
{
  return this->Feet ? this->Feet->GetBreaks() : this->Curve->GetBreaks(this->First, this->Last);
}

const LineCurve<2>* NativeTrim::GetLine() const
{
  return this->Feet || !this->Curve ? nullptr : this->Curve->GetIf<LineCurve<2>>();
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
      points.push_back(this->Feet ? this->Feet->Evaluate(t) : this->Curve->Evaluate(t));
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
  if (this->GetLine())
  {
    for (const double t : { this->First, this->Last })
    {
      const std::array<double, 2> p = this->Curve->Evaluate(t);
      add(p[0], p[1]);
    }
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
