#include "Detail/smTrimRises.h"

#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// Variation of v relative to the largest |v| of a face below which an extremum counts as rounding.
constexpr double Resolution = 0x1p-46;
// Largest number of halvings of a piece with several extrema.
constexpr int MaximumDepth = 40;

int GetSign(double x)
{
  return x > 0.0 ? 1 : x < 0.0 ? -1 : 0;
}

/// Returns the number of sign changes among the differences of the coefficients of v. It equals the number of
/// extrema of v or exceeds it by an even number.
int CountSignChanges(const TrimRise& b)
{
  int changes = 0;
  int last = 0;
  for (std::size_t i = 0; i + 1 < b.size(); ++i)
  {
    const int sign = GetSign(b[i + 1][1] - b[i][1]);
    changes += sign * last < 0 ? 1 : 0;
    last = sign != 0 ? sign : last;
  }
  return changes;
}

/// Splits at x by de Casteljau's algorithm; the end points remain bitwise the same.
void Split(const TrimRise& b, double x, TrimRise& left, TrimRise& right)
{
  right = b;
  left.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i)
  {
    left[i] = right[0];
    for (std::size_t j = 0; j + i + 1 < b.size(); ++j)
    {
      for (int c = 0; c < 2; ++c)
      {
        right[j][c] = (1.0 - x) * right[j][c] + x * right[j + 1][c];
      }
    }
  }
}

/// Returns the extremum of v if the differences change sign once, by bisection to adjacent doubles.
double FindExtremum(const TrimRise& b)
{
  const BernsteinPiece<2> piece{ b.data(), static_cast<int>(b.size()) - 1 };
  const auto first =
    std::find_if(b.begin() + 1, b.end(), [&b](const Point2& p) { return p[1] != b.front()[1]; });
  const int sign = GetSign((*first)[1] - b.front()[1]);
  double low = 0.0;
  double high = 1.0;
  for (double x = 0.5; low < x && x < high; x = 0.5 * (low + high))
  {
    Point2 derivative;
    piece.Evaluate(x, &derivative);
    (GetSign(derivative[1]) == sign ? low : high) = x;
  }
  return high;
}

class Cutter
{
public:
  explicit Cutter(double resolution)
    : Smallest(resolution)
  {
  }

  void AddLoop(const Loop& loop);
  std::vector<TrimRise> Result;

private:
  void AddPiece(const TrimRise& b, int depth);
  void Keep(const TrimRise& b)
  {
    if (b.front()[1] != b.back()[1])
    {
      this->Result.push_back(b);
    }
  }

  double Smallest;
};

void Cutter::AddPiece(const TrimRise& b, int depth)
{
  const int changes = CountSignChanges(b);
  if (changes == 0)
  {
    this->Keep(b);
    return;
  }
  const auto ends =
    std::minmax_element(b.begin(), b.end(), [](const Point2& p, const Point2& q) { return p[1] < q[1]; });
  if (depth == MaximumDepth || (*ends.second)[1] - (*ends.first)[1] <= this->Smallest)
  {
    this->Keep({ b.front(), b.back() });
    return;
  }
  TrimRise left;
  TrimRise right;
  Split(b, changes == 1 ? FindExtremum(b) : 0.5, left, right);
  if (changes == 1)
  {
    // By Descartes' rule v' has one zero, so that both parts are monotone; clamping removes the effect of
    // rounding on their coefficients.
    for (TrimRise* part : { &left, &right })
    {
      const double from = part->front()[1];
      const double to = part->back()[1];
      for (Point2& p : *part)
      {
        p[1] = std::clamp(p[1], std::min(from, to), std::max(from, to));
      }
      this->Keep(*part);
    }
    return;
  }
  this->AddPiece(left, depth + 1);
  this->AddPiece(right, depth + 1);
}

void Cutter::AddLoop(const Loop& loop)
{
  TrimRise piece;
  Point2 start{};
  Point2 end{};
  bool any = false;
  for (const Coedge& coedge : loop.Coedges)
  {
    const int count = coedge.Curve.GetNumberOfPieces();
    for (int k = 0; k < count; ++k)
    {
      const BernsteinPiece<2> source = coedge.Curve.GetPiece(coedge.Reversed ? count - 1 - k : k);
      piece.assign(source.Coefficients, source.Coefficients + source.Degree + 1);
      if (coedge.Reversed)
      {
        std::reverse(piece.begin(), piece.end());
      }
      if (any)
      {
        this->Keep({ end, piece.front() });
      }
      start = any ? start : piece.front();
      end = piece.back();
      any = true;
      this->AddPiece(piece, 0);
    }
  }
  if (any)
  {
    this->Keep({ end, start });
  }
}
}

std::vector<TrimRise> CutIntoRises(const Face& face)
{
  double largest = 0.0;
  for (const Loop& loop : face.Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      for (const Point2& p : coedge.Curve.Coefficients)
      {
        largest = std::max(largest, std::abs(p[1]));
      }
    }
  }
  Cutter cutter(Resolution * largest);
  for (const Loop& loop : face.Loops)
  {
    cutter.AddLoop(loop);
  }
  return std::move(cutter.Result);
}
}
