#include "Detail/smHeightNet.h"

#include "smBernstein.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
double NetRange::GetMaxHeight() const
{
  return this->MinWeight > 0.0 ? std::max(std::abs(this->Low), std::abs(this->High)) / this->MinWeight
                               : std::numeric_limits<double>::infinity();
}

HeightNet::HeightNet(const FacePanels& panels, const Patch& patch, const HeightPlane& plane)
{
  long double offset = plane.Offset;
  for (int c = 0; c < 3; ++c)
  {
    offset += static_cast<long double>(plane.Up[c]) * patch.Center[c];
  }
  for (int d = 0; d < 2; ++d)
  {
    this->Degree[d] = patch.Degree[d];
    this->Start[d] = patch.Start[d];
    this->Width[d] = patch.Width[d];
  }
  const int count = (patch.Degree[0] + 1) * (patch.Degree[1] + 1);
  for (int i = 0; i < count; ++i)
  {
    const std::array<double, 4>& point = panels.Points[patch.FirstPoint + i];
    long double height = offset * point[3];
    for (int c = 0; c < 3; ++c)
    {
      height += static_cast<long double>(plane.Up[c]) * point[c];
    }
    this->Coefficients.push_back({ static_cast<double>(height), point[3] });
    this->MaxNumerator = std::max(this->MaxNumerator, std::abs(this->Coefficients.back()[0]));
    this->MaxWeight = std::max(this->MaxWeight, point[3]);
  }
  this->Normal = std::min(patch.Stretch[0] * patch.Stretch[1],
                   std::hypot(patch.Normal[0], patch.Normal[1], patch.Normal[2])) /
    (patch.Width[0] * patch.Width[1]);
}

HeightNet HeightNet::Exchanged() const
{
  HeightNet other;
  for (int d = 0; d < 2; ++d)
  {
    other.Degree[d] = this->Degree[1 - d];
    other.Start[d] = this->Start[1 - d];
    other.Width[d] = this->Width[1 - d];
  }
  other.Normal = this->Normal;
  other.MaxNumerator = this->MaxNumerator;
  other.MaxWeight = this->MaxWeight;
  other.Coefficients.resize(this->Coefficients.size());
  for (int j = 0; j <= this->Degree[1]; ++j)
  {
    for (int i = 0; i <= this->Degree[0]; ++i)
    {
      other.Coefficients[j + (this->Degree[1] + 1) * i] = this->Coefficients[i + (this->Degree[0] + 1) * j];
    }
  }
  return other;
}

double HeightNet::GetRounding() const
{
  // Counts three roundings per level of de Casteljau's algorithm, which runs twice in each direction to
  // restrict a net and once to evaluate it, and some for sums of series. The parameters of a point of a trim
  // piece are rounded, too, which changes N by its slopes times that rounding.
  double roundings = 32.0;
  for (int d = 0; d < 2; ++d)
  {
    roundings += this->Degree[d] * (24.0 + 8.0 * std::abs(this->Start[d]) / std::abs(this->Width[d]));
  }
  return roundings * UnitRoundoff * this->MaxNumerator;
}

NetRange HeightNet::GetRange(const ParameterRange& box) const
{
  static thread_local std::vector<std::array<double, 2>> net;
  net = this->Coefficients;
  const int p = this->Degree[0];
  const int q = this->Degree[1];
  double width[2];
  for (int d = 0; d < 2; ++d)
  {
    const double low = this->ToLocal(d, box.Low[d]);
    const double high = this->ToLocal(d, box.High[d]);
    width[d] = high - low;
    const int lines = d == 0 ? q + 1 : p + 1;
    for (int line = 0; line < lines; ++line)
    {
      RestrictBernstein(
        net.data() + line * (d == 0 ? p + 1 : 1), d == 0 ? p : q, d == 0 ? 1 : p + 1, low, high);
    }
  }
  NetRange range;
  range.Low = range.High = net[0][0];
  range.MinWeight = net[0][1];
  for (const std::array<double, 2>& entry : net)
  {
    range.Low = std::min(range.Low, entry[0]);
    range.High = std::max(range.High, entry[0]);
    range.MinWeight = std::min(range.MinWeight, entry[1]);
  }
  for (int d = 0; d < 2; ++d)
  {
    const int stride = d == 0 ? 1 : p + 1;
    const double scale = this->Degree[d] / width[d];
    range.SlopeLow[d] = std::numeric_limits<double>::infinity();
    range.SlopeHigh[d] = -range.SlopeLow[d];
    for (int j = 0; j <= q - d; ++j)
    {
      for (int i = 0; i <= p - (1 - d); ++i)
      {
        const int at = i + (p + 1) * j;
        const double slope = scale * (net[at + stride][0] - net[at][0]);
        range.SlopeLow[d] = std::min(range.SlopeLow[d], slope);
        range.SlopeHigh[d] = std::max(range.SlopeHigh[d], slope);
      }
    }
  }
  return range;
}

namespace
{
using Line = std::array<double, 1>[MaximumDegree + 1];

double EvaluateLine(const Line& b, int degree, double x, std::array<double, 1>* slope = nullptr)
{
  return BernsteinPiece<1>{ b, degree }.Evaluate(x, slope)[0];
}
}

double HeightNet::Evaluate(double u, double v) const
{
  const double s = this->ToLocal(0, u);
  const double r = this->ToLocal(1, v);
  Line line = {};
  Line across = {};
  for (int j = 0; j <= this->Degree[1]; ++j)
  {
    for (int i = 0; i <= this->Degree[0]; ++i)
    {
      line[i] = { this->Coefficients[i + (this->Degree[0] + 1) * j][0] };
    }
    across[j] = { EvaluateLine(line, this->Degree[0], s) };
  }
  return EvaluateLine(across, this->Degree[1], r);
}

double HeightNet::Solve(double v, double low, double high) const
{
  const double r = this->ToLocal(1, v);
  Line line = {};
  Line across = {};
  for (int i = 0; i <= this->Degree[0]; ++i)
  {
    for (int j = 0; j <= this->Degree[1]; ++j)
    {
      across[j] = { this->Coefficients[i + (this->Degree[0] + 1) * j][0] };
    }
    line[i] = { EvaluateLine(across, this->Degree[1], r) };
  }
  const auto evaluate = [&](double u, std::array<double, 1>* slope)
  { return EvaluateLine(line, this->Degree[0], this->ToLocal(0, u), slope); };
  const double atLow = evaluate(low, nullptr);
  const double atHigh = evaluate(high, nullptr);
  if ((atLow < 0.0) == (atHigh < 0.0))
  {
    return std::abs(atLow) < std::abs(atHigh) ? low : high;
  }
  double a = low;
  double b = high;
  double x = a + (b - a) * atLow / (atLow - atHigh);
  for (int step = 0; step < 80; ++step)
  {
    std::array<double, 1> slope;
    const double value = evaluate(x, &slope);
    ((value < 0.0) == (atLow < 0.0) ? a : b) = x;
    double next = x - this->Width[0] * value / slope[0];
    if (!(next > a && next < b))
    {
      next = 0.5 * (a + b);
    }
    if (value == 0.0 || std::abs(next - x) <= 1e-16 * (high - low))
    {
      return x;
    }
    x = next;
  }
  return x;
}
}
