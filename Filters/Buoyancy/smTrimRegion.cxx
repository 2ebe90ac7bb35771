#include "Detail/smTrimRegion.h"

#include "smBernstein.h"
#include "smPolynomialCurve.h"
#include "smTrimCutting.h"
#include "smVector.h"

#include <algorithm>

namespace sm
{
namespace
{
// Largest number of halvings in the search for the extent of a piece, and its accuracy relative to the
// interval.
constexpr int ExtentDepth = 20;
constexpr double ExtentNoise = 1e-13;

/// Raises `maximum` to the largest value of the polynomial with Bernstein coefficients b, exceeding it by
/// less than `slack`.
void FindLargest(std::vector<std::array<double, 1>> b, int depth, double slack, double& maximum)
{
  const int degree = static_cast<int>(b.size()) - 1;
  maximum = std::max({ maximum, b.front()[0], b.back()[0] });
  const auto largest = std::max_element(b.begin(), b.end());
  if ((*largest)[0] <= maximum + slack || depth == 0)
  {
    maximum = std::max(maximum, (*largest)[0]);
    return;
  }
  std::vector<std::array<double, 1>> left(b.size());
  HalveBernstein(left.data(), b.data(), degree, 1);
  FindLargest(std::move(left), depth - 1, slack, maximum);
  FindLargest(std::move(b), depth - 1, slack, maximum);
}
}

std::array<double, 2> RegionPart::Evaluate(double t) const
{
  return BernsteinPiece<2>{ this->Piece->data(), this->GetDegree() }.Evaluate(t);
}

void SignedIntervals::Add(double start, double end, int sign)
{
  if (start == end)
  {
    return;
  }
  for (const auto& [at, change] : { std::make_pair(start, sign), std::make_pair(end, -sign) })
  {
    int& sum = this->Events[at];
    sum += change;
    if (sum == 0)
    {
      this->Events.erase(at);
    }
  }
}

std::vector<SignedIntervals::Interval> SignedIntervals::Get() const
{
  std::vector<Interval> intervals;
  int multiplicity = 0;
  double start = 0.0;
  for (const auto& [at, change] : this->Events)
  {
    if (multiplicity != 0)
    {
      intervals.push_back({ start, at, multiplicity });
    }
    multiplicity += change;
    start = at;
  }
  return intervals;
}

RegionPart MakeLine(double x, double start, double end, int sign)
{
  RegionPart line;
  line.From = { x, start };
  line.To = { x, end };
  line.Piece =
    std::make_shared<const std::vector<Point2>>(std::initializer_list<Point2>{ line.From, line.To });
  line.Sign = sign;
  line.Covered = true;
  return line;
}

RegionPart MakePart(const RegionPart& of, double start, double end, const Point2& from, const Point2& to)
{
  RegionPart part = of;
  part.Start = start;
  part.End = end;
  part.From = from;
  part.To = to;
  return part;
}

void CutPart(const RegionPart& part, int direction, double value, Region& below, Region& above)
{
  const int degree = part.GetDegree();
  std::vector<double> b;
  for (const Point2& point : *part.Piece)
  {
    b.push_back(point[direction] - value);
  }
  if (*std::max_element(b.begin(), b.end()) <= 0.0)
  {
    below.push_back(part);
    return;
  }
  if (*std::min_element(b.begin(), b.end()) >= 0.0)
  {
    above.push_back(part);
    return;
  }
  std::vector<double> roots;
  FindSignChanges(b.data(), degree, roots);
  double start = part.Start;
  Point2 from = part.From;
  const auto close = [&](double end, const Point2& to)
  {
    const double middle = part.Evaluate(0.5 * (start + end))[direction];
    (middle < value ? below : above).push_back(MakePart(part, start, end, from, to));
    start = end;
    from = to;
  };
  for (const double root : roots)
  {
    if (root > start && root < part.End)
    {
      Point2 point = part.Evaluate(root);
      point[direction] = value;
      close(root, point);
    }
  }
  close(part.End, part.To);
}

void CutRegion(const Region& region, int direction, double value, Region& below, Region& above)
{
  const std::size_t first = above.size();
  for (const RegionPart& part : region)
  {
    CutPart(part, direction, value, below, above);
  }
  if (direction == 0)
  {
    SignedIntervals covered;
    for (std::size_t i = first; i < above.size(); ++i)
    {
      covered.Add(above[i].From[1], above[i].To[1], above[i].Sign);
    }
    for (const SignedIntervals::Interval& interval : covered.Get())
    {
      below.push_back(MakeLine(value, interval.Start, interval.End, interval.Multiplicity));
    }
  }
}

Region ExchangeRegion(const Region& region, double left, double bottom)
{
  Region exchanged;
  std::map<double, SignedIntervals> horizontals;
  for (const RegionPart& part : region)
  {
    // The area left of the part is bounded counter-clockwise by the part, the line back to the left border,
    // the border downwards, and the line to the start of the part.
    horizontals[part.To[1]].Add(part.To[0], left, -part.Sign);
    horizontals[part.From[1]].Add(left, part.From[0], -part.Sign);
    RegionPart transposed = part;
    auto piece = std::make_shared<std::vector<Point2>>(*part.Piece);
    bool isLevel = true;
    for (Point2& point : *piece)
    {
      std::swap(point[0], point[1]);
      isLevel = isLevel && point[1] == (*piece)[0][1];
    }
    transposed.Piece = piece;
    transposed.From = { part.From[1], part.From[0] };
    transposed.To = { part.To[1], part.To[0] };
    transposed.Sign = -part.Sign;
    if (!isLevel)
    {
      exchanged.push_back(transposed);
    }
  }
  for (const auto& [y, intervals] : horizontals)
  {
    for (const SignedIntervals::Interval& interval : intervals.Get())
    {
      if (y != bottom)
      {
        exchanged.push_back(MakeLine(y, interval.Start, interval.End, interval.Multiplicity));
      }
    }
  }
  return exchanged;
}

std::array<double, 2> GetExtent(const RegionPart& part, int direction, double low, double high)
{
  std::array<double, 2> extent{ low, high };
  for (int side = 0; side < 2; ++side)
  {
    const double sign = side == 0 ? -1.0 : 1.0;
    std::vector<std::array<double, 1>> b;
    for (const Point2& point : *part.Piece)
    {
      b.push_back({ sign * point[direction] });
    }
    if (part.Start > 0.0 || part.End < 1.0)
    {
      RestrictBernstein(b.data(), part.GetDegree(), 1, part.Start, part.End);
    }
    double maximum = sign * extent[side];
    FindLargest(std::move(b), ExtentDepth, ExtentNoise * (high - low), maximum);
    extent[side] = sign * maximum;
  }
  return extent;
}
}
