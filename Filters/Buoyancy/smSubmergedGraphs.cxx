#include "Detail/smSubmergedPanels.h"

#include "Detail/smSignChanges.h"
#include "smBernstein.h"
#include "smChebyshev.h"
#include "smPatchParts.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
// Degrees of the polynomials that approximate graphs.
constexpr int GraphDegrees[] = { 3, 5, 7, 9 };
constexpr int MaxNodes = 10;
// Largest error of a crossing of the waterline, relative to the room next to a box, so that the graph still
// contains the crossing.
constexpr double CrossingRoom = 0.05;
// This factor makes up for the rounding of the stretch of a part.
constexpr double StretchRounding = 1.001;
// Halvings of a part around a point where it crosses the waterline.
constexpr int MaxUncertainHalvings = 16;
// Largest number of subdivisions of a piece whose degree is too high for a Chebyshev series of its height.
constexpr std::size_t MaxParts = 4096;

using Matrix = std::vector<std::vector<long double>>;

/// The inverse of the matrix whose row i holds the n Bernstein polynomials at node i of the Chebyshev rule on
/// [0,1].
Matrix InvertBernstein(int n)
{
  // Degrees are 9 at most, so that elimination in extended precision is accurate to rounding.
  const ChebyshevRule& rule = ChebyshevRule::Get(n);
  Matrix rows(n, std::vector<long double>(2 * n, 0.0L));
  for (int i = 0; i < n; ++i)
  {
    const long double x = 0.5L * (1.0L + rule.GetNode(i));
    for (int j = 0; j < n; ++j)
    {
      rows[i][j] = Binomials[n - 1][j] * std::pow(x, j) * std::pow(1.0L - x, n - 1 - j);
    }
    rows[i][n + i] = 1.0L;
  }
  for (int k = 0; k < n; ++k)
  {
    const auto largest = std::max_element(rows.begin() + k, rows.end(),
      [k](const auto& a, const auto& b) { return std::abs(a[k]) < std::abs(b[k]); });
    std::swap(rows[k], *largest);
    for (int i = 0; i < n; ++i)
    {
      const long double factor = i == k ? 0.0L : rows[i][k] / rows[k][k];
      for (int j = k; j < 2 * n && i != k; ++j)
      {
        rows[i][j] -= factor * rows[k][j];
      }
    }
  }
  for (int k = 0; k < n; ++k)
  {
    const long double pivot = rows[k][k];
    rows[k].erase(rows[k].begin(), rows[k].begin() + n);
    for (long double& value : rows[k])
    {
      value /= pivot;
    }
  }
  return rows;
}

/// Returns the Bernstein coefficients of the polynomial with these values at the Chebyshev nodes of [0,1].
std::vector<double> ToBernstein(const std::vector<double>& values)
{
  static const std::vector<Matrix> inverses = []
  {
    std::vector<Matrix> all;
    for (int n = 0; n <= MaxNodes; ++n)
    {
      all.push_back(n > 0 ? InvertBernstein(n) : Matrix());
    }
    return all;
  }();
  const Matrix& inverse = inverses.at(values.size());
  std::vector<double> coefficients(values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    long double sum = 0.0L;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      sum += inverse[k][i] * values[i];
    }
    coefficients[k] = static_cast<double>(sum);
  }
  return coefficients;
}

/// Returns an upper bound of the total variation of a coordinate along a part.
double GetVariation(const RegionPart& part, int direction, double start, double end)
{
  const std::vector<Point2>& b = *part.Piece;
  double largest = 0.0;
  for (std::size_t i = 1; i < b.size(); ++i)
  {
    largest = std::max(largest, std::abs(b[i][direction] - b[i - 1][direction]));
  }
  return part.GetDegree() * largest * (end - start);
}
}

CutErrors SubmergedPanels::GetCost(const Monotone& box, double largest, double length) const
{
  return { box.Rate * largest * largest * length, box.AreaRate * (largest + box.Noise) * length };
}

std::vector<SignedRange> SubmergedPanels::FindRanges(const Monotone& box, const RegionPart& part)
{
  const std::vector<SignedRange> ranges = this->FindSigns(box, part);
  if (this->Limits.HasArea())
  {
    // N is monotone between a zero as found and the true one.
    double largest = 0.0;
    for (std::size_t i = 1; i < ranges.size(); ++i)
    {
      const Point2 at = part.Evaluate(ranges[i].Start);
      largest = std::max(largest, std::abs(box.Net->Evaluate(at[0], at[1])));
    }
    const double length =
      this->GetUncertainVariation(box, part, part.Start, part.End, largest + box.Noise, 0);
    this->Errors.Area += length > 0.0 ? this->GetAreaBeside(box, part, largest, length) : 0.0;
  }
  return ranges;
}

double SubmergedPanels::GetUncertainVariation(
  const Monotone& box, const RegionPart& part, double start, double end, double maximum, int depth) const
{
  const int degree = (box.Net->GetDegree(0) + box.Net->GetDegree(1)) * part.GetDegree();
  if (degree >= ChebyshevRule::MaximumSize || depth == MaxUncertainHalvings)
  {
    return GetVariation(part, 1, start, end);
  }
  std::vector<double> series;
  ExpandPolynomial(
    [&](double t)
    {
      const Point2 at = part.Evaluate(t);
      return box.Net->Evaluate(at[0], at[1]);
    },
    degree, start, end, series);
  const double largest = GetLargest(series);
  if (2.0 * std::abs(series[0]) - largest > maximum)
  {
    return 0.0;
  }
  if (largest <= 2.0 * maximum)
  {
    return GetVariation(part, 1, start, end);
  }
  const double middle = 0.5 * (start + end);
  return this->GetUncertainVariation(box, part, start, middle, maximum, depth + 1) +
    this->GetUncertainVariation(box, part, middle, end, maximum, depth + 1);
}

double SubmergedPanels::GetAreaBeside(
  const Monotone& box, const RegionPart& part, double largest, double length) const
{
  const double maximum = largest + box.Noise;
  ParameterRange around;
  for (int d = 0; d < 2; ++d)
  {
    const std::array<double, 2> extent = GetExtent(part, d, part.From[d], part.From[d]);
    const double room = d == 0 ? std::max(2.0 * maximum / box.Slope, 0.5 * box.Room) : 0.0;
    around.Low[d] = extent[0] - room;
    around.High[d] = extent[1] + room;
  }
  if (!(around.High[1] > around.Low[1]))
  {
    return this->GetCost(box, largest, length).Area;
  }
  const NetRange range = box.Net->GetRange(around);
  const double width = box.Net->ToLocal(0, around.High[0]) - box.Net->ToLocal(0, around.Low[0]);
  // Per unit of the trim pieces' parameter, as box.Slope.
  const double minimum = range.SlopeLow[0] > 0.0 || range.SlopeHigh[0] < 0.0
    ? std::min(std::abs(range.SlopeLow[0]), std::abs(range.SlopeHigh[0]))
    : 0.0;
  const double slope = (minimum - 2.0 * box.Net->GetDegree(0) * box.Net->GetRounding() / width) * width /
    (around.High[0] - around.Low[0]);
  const double normal = this->GetMaxNormal(box.SourcePatch, box.Exchanged ? around.Exchanged() : around);
  return std::min(normal / std::max(slope, box.Slope), box.AreaRate) * maximum * length;
}

std::vector<SignedRange> SubmergedPanels::FindSigns(const Monotone& box, const RegionPart& part)
{
  const std::vector<Point2>& b = *part.Piece;
  int degree = 0;
  for (int d = 0; d < 2; ++d)
  {
    const bool constant =
      std::all_of(b.begin(), b.end(), [&](const Point2& point) { return point[d] == b[0][d]; });
    degree += constant ? 0 : box.Net->GetDegree(d) * part.GetDegree();
  }
  std::vector<SignedRange> ranges;
  if (degree < ChebyshevRule::MaximumSize)
  {
    FindSignedRanges(
      [&](double t)
      {
        const Point2 at = part.Evaluate(t);
        return box.Net->Evaluate(at[0], at[1]);
      },
      degree, part.Start, part.End,
      [&](double start, double end, double largest, bool last)
      {
        const CutErrors cost = this->GetCost(box, largest, GetVariation(part, 1, start, end));
        if (last ||
          (this->IsSmall(cost, largest, box.Noise) && largest <= CrossingRoom * box.Room * box.Slope))
        {
          this->Add(cost);
          return true;
        }
        return false;
      },
      ranges);
    return ranges;
  }
  // For higher degrees, the part is subdivided until the height has one sign on the box of each piece, or its
  // error is small.
  std::vector<std::array<double, 2>> open{ { part.End, part.Start } };
  for (std::size_t steps = 0; !open.empty(); ++steps)
  {
    const double start = open.back()[1];
    const double end = open.back()[0];
    open.pop_back();
    const RegionPart small = MakePart(part, start, end, part.Evaluate(start), part.Evaluate(end));
    ParameterRange around;
    for (int d = 0; d < 2; ++d)
    {
      const double low = std::min(small.From[d], small.To[d]);
      const double width = box.Range.High[d] - box.Range.Low[d];
      const std::array<double, 2> extent =
        GetExtent(small, d, low, std::max(std::max(small.From[d], small.To[d]), low + 1e-12 * width));
      around.Low[d] = extent[0];
      around.High[d] = extent[1];
    }
    const NetRange range = box.Net->GetRange(around);
    const double largest = std::max(std::abs(range.Low), std::abs(range.High));
    const CutErrors cost = this->GetCost(box, largest, GetVariation(part, 1, start, end));
    const bool sure = range.High <= 0.0 || range.Low >= 0.0;
    const bool isSmall =
      this->IsSmall(cost, largest, box.Noise) && largest <= CrossingRoom * box.Room * box.Slope;
    if (sure || isSmall || steps > MaxParts)
    {
      this->Add(sure ? CutErrors() : cost);
      ranges.push_back({ start, end, range.Low + range.High < 0.0 });
    }
    else
    {
      open.push_back({ end, 0.5 * (start + end) });
      open.push_back({ 0.5 * (start + end), start });
    }
  }
  return ranges;
}

void SubmergedPanels::CutMonotone(const Source& source, Monotone& box, const Region& region)
{
  FacePanels& result = this->Results[box.Exchanged ? 1 : 0];
  const ParameterRange own = box.Exchanged ? box.Range.Exchanged() : box.Range;
  box.SourcePatch = source.Patch;
  box.Patch = AppendPatchPart(this->From, source.Patch, own.Low, own.High, box.Exchanged, result);
  box.Shape = !box.Exchanged || source.Shape == PanelShape::Flat ? source.Shape : PanelShape::General;
  this->Flip = source.Flip != box.Exchanged;
  SignedIntervals waterline;
  for (const RegionPart& part : region)
  {
    Point2 from = part.From;
    const std::vector<SignedRange> ranges = this->FindRanges(box, part);
    for (const SignedRange& range : ranges)
    {
      const Point2 to = range.End == part.End ? part.To : part.Evaluate(range.End);
      if (range.Negative)
      {
        this->AddPanel(
          box.Exchanged, box.Patch, box.Shape, this->Flip, MakePart(part, range.Start, range.End, from, to));
      }
      if (range.Negative != box.Increasing)
      {
        waterline.Add(from[1], to[1], range.Negative ? -part.Sign : part.Sign);
      }
      from = to;
    }
  }
  for (const SignedIntervals::Interval& interval : waterline.Get())
  {
    // Where the waterline is left of the box, there is no area between it and the border.
    const RegionPart border = MakeLine(box.Range.Low[0], interval.Start, interval.End, 1);
    for (const SignedRange& range : this->FindRanges(box, border))
    {
      if (range.Negative == box.Increasing)
      {
        const double start = range.Start == 0.0 ? interval.Start : border.Evaluate(range.Start)[1];
        const double end = range.End == 1.0 ? interval.End : border.Evaluate(range.End)[1];
        this->AddGraph(box, start, end, interval.Multiplicity);
      }
    }
  }
}

void SubmergedPanels::AddSweep(
  const Monotone& box, const std::vector<Point2>& graph, const std::array<double, 2>& extent)
{
  if (!this->Limits.HasArea())
  {
    return;
  }
  // The part that the graph is on: next to the box, derivatives may be larger than on it.
  const ParameterRange range{ { extent[0], box.Range.Low[1] }, { extent[1], box.Range.High[1] } };
  const ParameterRange own = box.Exchanged ? range.Exchanged() : range;
  FacePanels part;
  AppendPatchPart(this->From, box.SourcePatch, own.Low, own.High, box.Exchanged, part);
  const Patch& patch = part.Patches[0];
  for (std::size_t i = 1; i < graph.size(); ++i)
  {
    for (int d = 0; d < 2; ++d)
    {
      this->Errors.Area += StretchRounding * this->Limits.Displacement * patch.Stretch[d] / patch.Width[d] *
        std::abs(graph[i][d] - graph[i - 1][d]);
    }
  }
}

bool SubmergedPanels::FitGraph(
  const Monotone& box, double start, double end, int degree, bool accept, PiecePointer& piece)
{
  const ChebyshevRule& rule = ChebyshevRule::Get(degree + 1);
  const double low = box.Range.Low[0] - 0.5 * box.Room;
  const double high = box.Range.High[0] + 0.5 * box.Room;
  std::vector<double> values;
  for (int i = 0; i <= degree; ++i)
  {
    const double y = start + (end - start) * 0.5 * (1.0 + rule.GetNode(i));
    values.push_back(box.Net->Solve(y, low, high));
  }
  const std::vector<double> coefficients = ToBernstein(values);
  std::vector<Point2> points;
  for (int i = 0; i <= degree; ++i)
  {
    points.push_back({ coefficients[i], i == degree ? end : start + (end - start) * i / degree });
  }
  RegionPart graph;
  graph.Piece = std::make_shared<const std::vector<Point2>>(std::move(points));
  std::vector<double> series;
  ExpandPolynomial(
    [&](double t)
    {
      const Point2 at = graph.Evaluate(t);
      return box.Net->Evaluate(at[0], at[1]);
    },
    box.Net->GetDegree(0) * degree + box.Net->GetDegree(1), 0.0, 1.0, series);
  const double largest = GetLargest(series);
  // The sliver between the graph and the waterline must lie where the height is known to be monotone.
  const std::array<double, 2> extent = GetExtent(graph, 0, low, high);
  const bool inside = extent[0] > box.Range.Low[0] - box.Room && extent[1] < box.Range.High[0] + box.Room &&
    largest <= 0.25 * box.Room * box.Slope;
  const double width = std::abs(end - start);
  CutErrors cost{ box.Whole.Volume * width, box.Whole.Area * width };
  if (inside)
  {
    const CutErrors sliver = this->GetCost(box, largest, width);
    cost = { std::min(sliver.Volume, cost.Volume), std::min(sliver.Area, cost.Area) };
    if (this->Limits.HasArea())
    {
      graph.From = graph.Piece->front();
      graph.To = graph.Piece->back();
      cost.Area = std::min(cost.Area, this->GetAreaBeside(box, graph, largest, width));
    }
  }
  if (this->IsSmall(cost, inside ? largest : std::numeric_limits<double>::infinity(), box.Noise) || accept)
  {
    this->Add(cost);
    this->AddSweep(box, *graph.Piece, extent);
    piece = graph.Piece;
    return true;
  }
  return false;
}

void SubmergedPanels::AddGraph(Monotone& box, double start, double end, int sign)
{
  RegionPart graph;
  const int maximum = (ChebyshevRule::MaximumSize - 1 - box.Net->GetDegree(1)) / box.Net->GetDegree(0);
  for (const int degree : GraphDegrees)
  {
    const bool last = degree == 9 || degree + 2 > maximum;
    if (this->FitGraph(box, start, end, std::min(degree, maximum), last && box.Halvings == 0, graph.Piece))
    {
      graph.From = graph.Piece->front();
      graph.To = graph.Piece->back();
      graph.Sign = sign;
      // The ends of the graph are the points where trim curves cross the plane, which are known to rounding.
      graph.Covered = true;
      this->AddPanel(box.Exchanged, box.Patch, box.Shape, this->Flip, graph);
      return;
    }
    if (last)
    {
      break;
    }
  }
  --box.Halvings;
  const double middle = 0.5 * (start + end);
  this->AddGraph(box, start, middle, sign);
  this->AddGraph(box, middle, end, sign);
}
}
