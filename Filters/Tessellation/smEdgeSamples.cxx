#include "smEdgeSamples.h"

#include "smPatchParts.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr std::size_t MostSamples = 20000;
/// Intervals of a curved piece on which the wanted density of points is constant.
constexpr int PieceIntervals = 4;
/// Pieces of a curve beyond which one interval each will do.
constexpr int ManyPieces = 64;
/// A corner in a curve that gets a point of its own, in radians.
constexpr double CornerAngle = 0.02;
/// Part of the deflection that a chord may take in a face: triangles along it need more.
constexpr double ChordShare = 0.6;
/// Share of the deflection that a coarse bound must be below for the sharp one to be so for certain.
constexpr double CertainShare = 0.999;

double GetAngle(const Vector3& a, const Vector3& b)
{
  return std::atan2(Norm(Cross(a, b)), Dot(a, b));
}

/// Vector `v` without its component along the unit vector `along`.
Vector3 Reject(const Vector3& v, const Vector3& along)
{
  const double x = Dot(v, along);
  return { v[0] - x * along[0], v[1] - x * along[1], v[2] - x * along[2] };
}

Vector3 GetEndTangent(const EdgeCurve& curve, int piece, bool atEnd)
{
  const BernsteinPiece<3> b = curve.GetPiece(piece);
  // Equal coefficients at the end have no direction.
  for (int i = 1; i <= b.Degree; ++i)
  {
    const Vector3 d = atEnd ? Subtract(b.Coefficients[b.Degree], b.Coefficients[b.Degree - i])
                            : Subtract(b.Coefficients[i], b.Coefficients[0]);
    if (Dot(d, d) > 0.0)
    {
      return d;
    }
  }
  return { 0.0, 0.0, 0.0 };
}

bool IsBent(const TrimCurve& trim)
{
  for (int k = 0; k < trim.GetNumberOfPieces(); ++k)
  {
    if (trim.GetDegree(k) > 1)
    {
      return true;
    }
  }
  return false;
}

/// No chord within piece k is farther from the curve than this times the square of its length in parameters, by BoundSagitta(): second
/// differences of a part are means of those of the piece; coefficients are off even steps along the chord by at most n / (n - 1) of
/// what second differences allow the curve.
double BoundBend(const EdgeCurve& curve, int k)
{
  const BernsteinPiece<3> b = curve.GetPiece(k);
  const double width = curve.Breaks[k + 1] - curve.Breaks[k];
  double largest = 0.0;
  for (int i = 0; i + 2 <= b.Degree; ++i)
  {
    const Vector3 second{ b.Coefficients[i + 2][0] - 2.0 * b.Coefficients[i + 1][0] + b.Coefficients[i][0],
      b.Coefficients[i + 2][1] - 2.0 * b.Coefficients[i + 1][1] + b.Coefficients[i][1],
      b.Coefficients[i + 2][2] - 2.0 * b.Coefficients[i + 1][2] + b.Coefficients[i][2] };
    largest = std::max(largest, Norm(second));
  }
  const double n = b.Degree;
  return n < 2 ? 0.0 : 0.125 * n * (n - 1.0) * std::hypot(1.0, n / (n - 1.0)) * largest / (width * width);
}

class Sampler
{
public:
  Sampler(const Edge& edge, const std::vector<EdgeUse>& uses, const MeshLimits& limits)
    : Curve(edge.Curve)
    , IsPoint(edge.Degenerate)
    , Limits(limits)
  {
    for (const EdgeUse& use : uses)
    {
      // On a plane nothing depends on the points.
      if (!use.Blocks->IsFlat(limits.Deflection, limits.Angle))
      {
        this->Uses.push_back({ use, HUGE_VAL, {} });
      }
    }
    for (int k = 0; k < this->Curve.GetNumberOfPieces(); ++k)
    {
      this->Bends.push_back(BoundBend(this->Curve, k));
    }
    this->StraightInFaces =
      std::none_of(uses.begin(), uses.end(), [](const EdgeUse& use) { return IsBent(*use.Trim); });
  }

  std::vector<double> Run(int least)
  {
    this->MakeIntervals();
    std::vector<double> result{ this->Curve.GetStart() };
    std::size_t first = 0;
    for (std::size_t i = 0; i < this->Counts.size(); ++i)
    {
      if (i + 1 == this->Counts.size() || this->Corners[i + 1])
      {
        this->Distribute(first, i + 1, least, result);
        first = i + 1;
      }
    }
    return this->Refine(result);
  }

private:
  void MakeIntervals()
  {
    const int pieces = this->Curve.GetNumberOfPieces();
    for (int k = 0; k < pieces; ++k)
    {
      const bool straight = this->Curve.GetDegree(k) <= 1 && this->StraightInFaces;
      const int parts = straight || pieces > ManyPieces ? 1 : PieceIntervals;
      const double low = this->Curve.Breaks[k];
      const double high = this->Curve.Breaks[k + 1];
      bool corner = k == 0;
      if (k > 0 && !this->IsPoint)
      {
        corner = GetAngle(GetEndTangent(this->Curve, k - 1, true), GetEndTangent(this->Curve, k, false)) >
          CornerAngle;
      }
      for (int i = 0; i < parts; ++i)
      {
        const double from = low + (high - low) * i / parts;
        const double to = i + 1 == parts ? high : low + (high - low) * (i + 1) / parts;
        this->Ends.push_back(from);
        this->Corners.push_back(i == 0 && corner);
        this->Counts.push_back(std::max(this->CountByCurve(k, from, to), this->CountByFaces(from, to)));
      }
    }
    this->Ends.push_back(this->Curve.GetEnd());
  }

  /// Chords that the curve wants between two parameters of one piece.
  double CountByCurve(int piece, double from, double to)
  {
    if (this->IsPoint || this->Curve.GetDegree(piece) <= 1)
    {
      return 0.0;
    }
    Vector3 tangent[3] = { this->Tangent };
    if (from != this->TangentAt)
    {
      this->Curve.Evaluate(from, &tangent[0]);
    }
    this->Curve.Evaluate(from + 0.5 * (to - from), &tangent[1]);
    if (to == this->Curve.Breaks[piece + 1])
    {
      // Evaluate() at a break belongs to the next piece.
      tangent[2] = GetEndTangent(this->Curve, piece, true);
      this->TangentAt = HUGE_VAL;
    }
    else
    {
      this->TangentAt = from + (to - from);
      this->Curve.Evaluate(this->TangentAt, &tangent[2]);
      this->Tangent = tangent[2];
    }
    const double angle = GetAngle(tangent[0], tangent[1]) + GetAngle(tangent[1], tangent[2]);
    const double length = (to - from) * Norm(tangent[1]);
    // A circular arc of n chords deviates by length * angle / (8 n^2).
    return std::max(angle / this->Limits.Angle, std::sqrt(0.125 * length * angle / this->Limits.Deflection));
  }

  double CountByFaces(double from, double to)
  {
    double count = 0.0;
    for (Use& use : this->Uses)
    {
      const std::array<double, 2> a = use.Evaluate(from);
      const std::array<double, 2> b = use.Evaluate(to);
      ParameterBox box{ a, a };
      box.Add(b);
      if (this->IsPoint)
      {
        // A pole gets as many points as the rows around it, so that a triangle with it leads straight to a row.
        const ParameterBox& all = use.Source.Blocks->GetCovered();
        const int across = std::abs(a[0] - b[0]) >= std::abs(a[1] - b[1]) ? 1 : 0;
        box.Low[across] = all.Low[across];
        box.High[across] = all.High[across];
      }
      const SurfaceBlocks::Block m = use.Source.Blocks->GetLargest(box);
      const double w[2] = { std::abs(a[0] - b[0]), std::abs(a[1] - b[1]) };
      const double error = 0.125 * (m.Uu * w[0] * w[0] + 2.0 * m.Uv * w[0] * w[1] + m.Vv * w[1] * w[1]);
      count = std::max({ count, std::sqrt(error / (ChordShare * this->Limits.Deflection)),
        std::hypot(m.Turn[0] * w[0], m.Turn[1] * w[1]) / this->Limits.Angle });
    }
    return count;
  }

  /// Points between two corners, at equal steps of the wanted number of chords; the start is there already.
  void Distribute(std::size_t first, std::size_t last, int least, std::vector<double>& result) const
  {
    double total = 0.0;
    for (std::size_t i = first; i < last; ++i)
    {
      total += this->Counts[i];
    }
    const double end = this->Ends[last];
    const double start = this->Ends[first];
    const double wanted = std::min(total, 0.25 * MostSamples);
    const int chords =
      std::max(static_cast<int>(std::ceil(wanted - 1e-3)), this->Counts.size() == last - first ? least : 1);
    std::size_t at = first;
    double before = 0.0;
    for (int i = 1; i < chords; ++i)
    {
      const double target = total * i / chords;
      while (at + 1 < last && before + this->Counts[at] < target)
      {
        before += this->Counts[at++];
      }
      const double share = this->Counts[at] > 0.0 ? (target - before) / this->Counts[at] : 0.0;
      const double t = total > 0.0
        ? this->Ends[at] + std::min(share, 1.0) * (this->Ends[at + 1] - this->Ends[at])
        : start + (end - start) * i / chords;
      if (t > result.back() && t < end)
      {
        result.push_back(t);
      }
    }
    result.push_back(end);
  }

  bool IsNearCurve(double low, double high) const
  {
    const int piece = this->Curve.FindPiece(low);
    const double coarse = this->Bends[piece] * (high - low) * (high - low);
    return (high <= this->Curve.Breaks[piece + 1] && coarse < CertainShare * this->Limits.Deflection) ||
      BoundSagitta(this->Curve, low, high) <= this->Limits.Deflection;
  }

  bool IsGood(double low, double high)
  {
    if (!this->IsPoint && !this->IsNearCurve(low, high))
    {
      return false;
    }
    for (Use& use : this->Uses)
    {
      const std::array<double, 2> a = use.Evaluate(low);
      ParameterBox box{ a, a };
      box.Add(use.Evaluate(high));
      if (!(use.Source.Blocks->GetError(box) <= 1.25 * ChordShare * this->Limits.Deflection))
      {
        return false;
      }
    }
    return true;
  }

  std::vector<double> Refine(const std::vector<double>& coarse)
  {
    std::vector<double> result{ coarse.front() };
    // Chords that are still to be judged, the next one last.
    std::vector<double> ends(coarse.rbegin(), coarse.rend() - 1);
    while (!ends.empty())
    {
      const double low = result.back();
      const double high = ends.back();
      const double middle = 0.5 * (low + high);
      const double least = 1e-9 * (coarse.back() - coarse.front());
      if (result.size() + ends.size() < MostSamples && high - low > least && !this->IsGood(low, high))
      {
        ends.push_back(middle);
        continue;
      }
      result.push_back(high);
      ends.pop_back();
    }
    return result;
  }

  /// A face beside the edge, and the last point that was asked for: intervals and chords meet there.
  struct Use
  {
    EdgeUse Source;
    double T;
    std::array<double, 2> Point;

    std::array<double, 2> Evaluate(double t)
    {
      this->Point = t == this->T ? this->Point : this->Source.Trim->Evaluate(t);
      this->T = t;
      return this->Point;
    }
  };

  const EdgeCurve& Curve;
  bool IsPoint;
  bool StraightInFaces;
  /// The faces that are not flat.
  std::vector<Use> Uses;
  const MeshLimits& Limits;
  /// BoundBend() of the pieces.
  std::vector<double> Bends;
  /// The curve's derivative at a parameter.
  Vector3 Tangent{};
  double TangentAt = HUGE_VAL;
  /// Where intervals begin, and where the last one ends.
  std::vector<double> Ends;
  /// True where an interval begins at a corner.
  std::vector<bool> Corners;
  /// Chords that each interval wants, a fraction perhaps.
  std::vector<double> Counts;
};
}

double BoundSagitta(const EdgeCurve& curve, double low, double high)
{
  const Vector3 start = curve.Evaluate(low);
  const Vector3 chord = Subtract(curve.Evaluate(high), start);
  const double length = Norm(chord);
  const Vector3 along = length > 0.0 ? Normalized(chord) : Vector3{ 0.0, 0.0, 0.0 };
  const int first = curve.FindPiece(low);
  int last = curve.FindPiece(high);
  last = last > first && curve.Breaks[last] >= high ? last - 1 : last;
  // Distances from the line of the chord, by the convex hull: second differences where one piece holds the chord, else
  // the coefficients themselves.
  double largest = 0.0;
  // Beyond the ends of the chord.
  double excess = 0.0;
  for (int k = first; k <= last; ++k)
  {
    std::array<double, 3> b[MaximumDegree + 1];
    const BernsteinPiece<3> piece = curve.GetPiece(k);
    std::copy(piece.Coefficients, piece.Coefficients + piece.Degree + 1, b);
    const double width = curve.Breaks[k + 1] - curve.Breaks[k];
    const double from = std::max((low - curve.Breaks[k]) / width, 0.0);
    const double to = std::min((high - curve.Breaks[k]) / width, 1.0);
    if (piece.Degree > 0 && to > from)
    {
      RestrictBernstein(b, piece.Degree, 1, from, to);
    }
    for (int i = 0; i <= piece.Degree; ++i)
    {
      const double x = Dot(Subtract(b[i], start), along);
      excess = std::max({ excess, -x, x - length });
    }
    for (int i = 0; first != last && i <= piece.Degree; ++i)
    {
      largest = std::max(largest, Norm(Reject(Subtract(b[i], start), along)));
    }
    for (int i = 0; first == last && i + 2 <= piece.Degree; ++i)
    {
      const Vector3 second{ b[i + 2][0] - 2.0 * b[i + 1][0] + b[i][0],
        b[i + 2][1] - 2.0 * b[i + 1][1] + b[i][1], b[i + 2][2] - 2.0 * b[i + 1][2] + b[i][2] };
      largest = std::max(largest, 0.125 * piece.Degree * (piece.Degree - 1.0) * Norm(Reject(second, along)));
    }
  }
  return std::hypot(largest, excess);
}

std::vector<double> SampleEdge(
  const Edge& edge, const std::vector<EdgeUse>& uses, const MeshLimits& limits, int least)
{
  return Sampler(edge, uses, limits).Run(least);
}
}
