#include "smTrimPolygons.h"

#include "smBernstein.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
// 2^14 parts of a piece, each of up to 4 chords.
constexpr int MaximumDepth = 14;
constexpr double MaximumUniformChords = 4.0;

class Flattener
{
public:
  explicit Flattener(const TrimTolerance& tolerance)
    : Tolerance(tolerance)
  {
  }

  void AddLoop(const Loop& loop);
  TrimPolygons Result;

private:
  void AddPiece(const std::vector<Point2>& coefficients);
  void AddPart(const Point2* b, int degree, int depth);
  void AddPoint(const Point2& point)
  {
    // Coedges that meet share a point, which is added once; so chords of length 0 are left out.
    if (this->Points.empty() || this->Points.back() != point)
    {
      this->Points.push_back(point);
    }
  }

  const TrimTolerance& Tolerance;
  std::vector<Point2> Points;
};

/// Adds the points of one part of a piece after its first one.
void Flattener::AddPart(const Point2* b, int degree, int depth)
{
  // Over a parameter interval of length h a function leaves its chord by at most h^2/8 max |c''|, and
  // Bernstein coefficients bound c'' = d (d-1) sum_i (b_i - 2 b_i+1 + b_i+2) B_i^(d-2). So N equal chords
  // deviate by at most d (d-1) max|second difference| / (8 N^2).
  Point2 low = b[0];
  Point2 high = b[0];
  Point2 bound{};
  for (int i = 0; i <= degree; ++i)
  {
    for (int c = 0; c < 2; ++c)
    {
      low[c] = std::min(low[c], b[i][c]);
      high[c] = std::max(high[c], b[i][c]);
      if (i + 2 <= degree)
      {
        bound[c] = std::max(bound[c],
          0.125 * degree * (degree - 1) * std::abs((b[i][c] - b[i + 1][c]) - (b[i + 1][c] - b[i + 2][c])));
      }
    }
  }
  const bool straight = bound[0] == 0.0 && bound[1] == 0.0;
  const Point2 tolerance = straight ? Point2{} : this->Tolerance(low, high);
  double chords = 1.0;
  for (int c = 0; c < 2; ++c)
  {
    if (bound[c] > tolerance[c])
    {
      chords =
        std::max(chords, tolerance[c] > 0.0 ? std::ceil(std::sqrt(bound[c] / tolerance[c])) : HUGE_VAL);
    }
  }
  if (chords > MaximumUniformChords && depth < MaximumDepth)
  {
    Point2 left[MaximumDegree + 1];
    Point2 right[MaximumDegree + 1];
    std::copy_n(b, degree + 1, right);
    HalveBernstein(left, right, degree, 1);
    this->AddPart(left, degree, depth + 1);
    this->AddPart(right, degree, depth + 1);
    return;
  }
  chords = std::min(chords, MaximumUniformChords);
  const BernsteinPiece<2> piece{ b, degree };
  for (int i = 1; i < static_cast<int>(chords); ++i)
  {
    this->AddPoint(piece.Evaluate(i / chords));
  }
  this->AddPoint(b[degree]);
  for (int c = 0; c < 2; ++c)
  {
    this->Result.Deviation[c] = std::max(this->Result.Deviation[c], bound[c] / (chords * chords));
  }
}

void Flattener::AddPiece(const std::vector<Point2>& coefficients)
{
  this->AddPoint(coefficients.front());
  this->AddPart(coefficients.data(), static_cast<int>(coefficients.size()) - 1, 0);
}

void Flattener::AddLoop(const Loop& loop)
{
  this->Points.clear();
  std::vector<Point2> coefficients;
  for (const Coedge& coedge : loop.Coedges)
  {
    const TrimCurve& curve = coedge.Curve;
    const int count = curve.GetNumberOfPieces();
    for (int k = 0; k < count; ++k)
    {
      const BernsteinPiece<2> piece = curve.GetPiece(coedge.Reversed ? count - 1 - k : k);
      coefficients.assign(piece.Coefficients, piece.Coefficients + piece.Degree + 1);
      if (coedge.Reversed)
      {
        std::reverse(coefficients.begin(), coefficients.end());
      }
      this->AddPiece(coefficients);
    }
  }
  while (this->Points.size() > 1 && this->Points.front() == this->Points.back())
  {
    this->Points.pop_back();
  }
  this->Result.Loops.push_back(this->Points);
}
}

TrimPolygons FlattenLoops(const Face& face, const TrimTolerance& tolerance)
{
  Flattener flattener(tolerance);
  for (const Loop& loop : face.Loops)
  {
    flattener.AddLoop(loop);
  }
  return std::move(flattener.Result);
}

TrimPolygons FlattenLoops(const Face& face, const std::array<double, 2>& tolerance)
{
  return FlattenLoops(face, [&tolerance](const Point2&, const Point2&) { return tolerance; });
}
}
