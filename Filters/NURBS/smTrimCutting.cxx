#include "smTrimCutting.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// Below this width of the parameter a pair of sign changes counts as a touch: the excursion between them
// is smaller than rounding.
constexpr int MaximumCuts = 48;

int CountVariations(const double* b, int degree)
{
  int variations = 0;
  double last = 0.0;
  for (int i = 0; i <= degree; ++i)
  {
    if (b[i] != 0.0)
    {
      variations += last * b[i] < 0.0 ? 1 : 0;
      last = b[i] > 0.0 ? 1.0 : -1.0;
    }
  }
  return variations;
}

double EvaluateBernstein(const double* b, int degree, double x)
{
  double work[MaximumDegree + 1] = {};
  std::copy_n(b, degree + 1, work);
  for (int level = degree; level > 0; --level)
  {
    for (int i = 0; i < level; ++i)
    {
      work[i] = (1.0 - x) * work[i] + x * work[i + 1];
    }
  }
  return work[0];
}

/// The only sign change in (0,1), by the Illinois variant of regula falsi, to the last bit that matters.
double BracketedRoot(const double* b, int degree)
{
  const auto firstNonZero = std::find_if(b, b + degree + 1, [](double x) { return x != 0.0; });
  const double leftSign = *firstNonZero > 0.0 ? 1.0 : -1.0;
  double low = 0.0;
  double high = 1.0;
  double fLow = b[0] != 0.0 ? b[0] : leftSign * 1e-300;
  double fHigh = b[degree] != 0.0 ? b[degree] : -leftSign * 1e-300;
  int side = 0;
  for (int iteration = 0; iteration < 200 && high - low > 2.3e-16 * high; ++iteration)
  {
    double x = low - fLow * (high - low) / (fHigh - fLow);
    // Every third step halves, so that the bracket shrinks whatever the function does.
    if (!(x > low && x < high) || iteration % 3 == 2)
    {
      x = 0.5 * (low + high);
      if (x <= low || x >= high)
      {
        break;
      }
    }
    const double f = EvaluateBernstein(b, degree, x);
    if (f == 0.0)
    {
      return x;
    }
    if ((f > 0.0) == (leftSign > 0.0))
    {
      low = x;
      fLow = f;
      fHigh *= side == -1 ? 0.5 : 1.0;
      side = -1;
    }
    else
    {
      high = x;
      fHigh = f;
      fLow *= side == 1 ? 0.5 : 1.0;
      side = 1;
    }
  }
  return 0.5 * (low + high);
}

void Isolate(const double* b, int degree, double start, double width, int depth, std::vector<double>& roots)
{
  const int variations = CountVariations(b, degree);
  if (variations == 0)
  {
    return;
  }
  if (variations == 1)
  {
    roots.push_back(start + width * BracketedRoot(b, degree));
    return;
  }
  if (depth == MaximumCuts)
  {
    return;
  }
  double left[MaximumDegree + 1] = {};
  double right[MaximumDegree + 1] = {};
  std::copy_n(b, degree + 1, right);
  for (int i = 0; i <= degree; ++i)
  {
    left[i] = right[0];
    for (int j = 0; j < degree - i; ++j)
    {
      right[j] = 0.5 * (right[j] + right[j + 1]);
    }
  }
  Isolate(left, degree, start, 0.5 * width, depth + 1, roots);
  // The middle itself is a root that neither open half holds.
  if (right[0] == 0.0 && b[0] != 0.0)
  {
    const auto before = std::find_if(std::make_reverse_iterator(left + degree + 1),
      std::make_reverse_iterator(left), [](double x) { return x != 0.0; });
    const auto after = std::find_if(right, right + degree + 1, [](double x) { return x != 0.0; });
    if (after != right + degree + 1 && *before * *after < 0.0)
    {
      roots.push_back(start + 0.5 * width);
    }
  }
  Isolate(right, degree, start + 0.5 * width, 0.5 * width, depth + 1, roots);
}

struct Cut
{
  double Parameter;
  int Direction;
  double Knot;
};

void FindCuts(
  const BernsteinPiece<2>& piece, int direction, const std::vector<double>& breaks, std::vector<Cut>& cuts)
{
  double low = piece.Coefficients[0][direction];
  double high = low;
  for (int i = 1; i <= piece.Degree; ++i)
  {
    low = std::min(low, piece.Coefficients[i][direction]);
    high = std::max(high, piece.Coefficients[i][direction]);
  }
  // Only interior knots cut: outside the domain the nearest cell's polynomial goes on.
  const auto first = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, low);
  const auto last = std::lower_bound(first, breaks.end() - 1, high);
  std::vector<double> roots;
  for (auto knot = first; knot != last; ++knot)
  {
    double b[MaximumDegree + 1] = {};
    for (int i = 0; i <= piece.Degree; ++i)
    {
      b[i] = piece.Coefficients[i][direction] - *knot;
    }
    roots.clear();
    FindSignChanges(b, piece.Degree, roots);
    for (const double root : roots)
    {
      cuts.push_back({ root, direction, *knot });
    }
  }
}
}

int CellGrid::Find(const std::vector<double>& breaks, double x)
{
  const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, x);
  return static_cast<int>(after - breaks.begin()) - 1;
}

bool CellGrid::AreSame(const std::array<double, 2>& a, const std::array<double, 2>& b) const
{
  for (int d = 0; d < 2; ++d)
  {
    const std::vector<double>& breaks = d == 0 ? this->U : this->V;
    double scale = std::max(std::abs(breaks.front()), std::abs(breaks.back()));
    for (const int cell : { Find(breaks, a[d]), Find(breaks, b[d]) })
    {
      scale = std::min(scale, breaks[cell + 1] - breaks[cell]);
    }
    if (!(std::abs(a[d] - b[d]) <= 4e-16 * scale))
    {
      return false;
    }
  }
  return true;
}

void FindSignChanges(const double* coefficients, int degree, std::vector<double>& roots)
{
  Isolate(coefficients, degree, 0.0, 1.0, 0, roots);
}

void CutAtKnotLines(const BernsteinPiece<2>& piece, const CellGrid& grid, std::vector<TrimSegment>& segments)
{
  std::vector<Cut> cuts;
  FindCuts(piece, 0, grid.U, cuts);
  FindCuts(piece, 1, grid.V, cuts);
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.Parameter < b.Parameter; });

  TrimSegment segment;
  segment.StartPoint = piece.Coefficients[0];
  const auto close = [&](double end, const std::array<double, 2>& point)
  {
    segment.End = end;
    segment.EndPoint = point;
    std::array<double, 2> middle = piece.Evaluate(0.5 * (segment.Start + end));
    for (int d = 0; d < 2; ++d)
    {
      const auto [low, high] = std::minmax(segment.StartPoint[d], point[d]);
      middle[d] = segment.Start == end ? 0.5 * (low + high) : middle[d];
      // Between neighbouring doubles there is no middle.
      middle[d] = low < high && middle[d] >= high && std::nextafter(low, high) == high ? low : middle[d];
    }
    segment.Column = CellGrid::Find(grid.U, middle[0]);
    segment.Row = CellGrid::Find(grid.V, middle[1]);
    segments.push_back(segment);
    segment.Start = end;
    segment.StartPoint = point;
  };
  std::vector<double> knots[2];
  for (std::size_t i = 0; i < cuts.size();)
  {
    // At a corner of the grid both families are cut at one parameter, and so are neighbouring knots that are
    // closer than rounding.
    const double parameter = cuts[i].Parameter;
    knots[0].clear();
    knots[1].clear();
    for (; i < cuts.size() && cuts[i].Parameter == parameter; ++i)
    {
      knots[cuts[i].Direction].push_back(cuts[i].Knot);
    }
    if (!(parameter > segment.Start && parameter < 1.0))
    {
      continue;
    }
    std::array<double, 2> point = piece.Evaluate(parameter);
    for (int d = 0; d < 2; ++d)
    {
      std::sort(knots[d].begin(), knots[d].end());
      knots[d].erase(std::unique(knots[d].begin(), knots[d].end()), knots[d].end());
      if (!knots[d].empty() && knots[d].front() < segment.StartPoint[d])
      {
        std::reverse(knots[d].begin(), knots[d].end());
      }
    }
    for (std::size_t k = 0; k < std::max(knots[0].size(), knots[1].size()); ++k)
    {
      for (int d = 0; d < 2; ++d)
      {
        point[d] = knots[d].empty() ? point[d] : knots[d][std::min(k, knots[d].size() - 1)];
      }
      close(parameter, point);
    }
  }
  close(1.0, piece.Coefficients[piece.Degree]);
}
}
