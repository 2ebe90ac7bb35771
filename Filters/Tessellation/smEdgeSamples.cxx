#include "smEdgeSamples.h"

#include "smBernstein.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Points of an edge. A face that wants more chords than that keeps no promise, and has no say in where the
/// points lie.
constexpr std::size_t MaxSamples = 20000;
/// Intervals of a curved piece on which the wanted density of points is constant.
constexpr int PieceIntervals = 4;
/// Pieces of a curve beyond which one interval each will do.
constexpr int ManyPieces = 64;
/// A corner in a curve that gets a point of its own, in radians.
constexpr double CornerAngle = 0.02;
/// Part of the deflection that a chord may take in a face: triangles along it need more.
constexpr double ChordShare = 0.6;
/// Points nearer to the end of an interval than this part of it are there.
constexpr double SnapShare = 1e-6;
/// No chord is halved below this part of the edge: points of a face that are nearer than a step of its grid
/// would be one.
constexpr double MinChord = 1e-7;
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

/// No chord within piece k is farther from the curve than this times the square of its length in parameters,
/// by BoundSagitta(): second differences of a part are means of those of the piece; coefficients are off even
/// steps along the chord by at most n / (n - 1) of what second differences allow the curve.
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
    largest = std::max(largest, Dot(second, second));
  }
  const double n = b.Degree;
  const double off = n / std::max(n - 1.0, 1.0);
  return 0.125 * n * (n - 1.0) * std::sqrt((1.0 + off * off) * largest) / (width * width);
}

void AppendPoints(const TrimCurve& trim, EdgeSamples& samples)
{
  for (const double t : samples.T)
  {
    samples.At.push_back(EvaluateByBasis(trim, t));
  }
}

/// Values of the Bernstein polynomials of every degree where tangents are compared: at the ends and in the
/// middle of the intervals of a piece.
class TangentBasis
{
public:
  static constexpr int Steps = 2 * PieceIntervals;

  static const double* Get(int degree, int step)
  {
    static const TangentBasis basis;
    return basis.Values[degree][step];
  }

private:
  TangentBasis()
  {
    for (int degree = 0; degree <= MaximumDegree; ++degree)
    {
      for (int step = 0; step <= Steps; ++step)
      {
        EvaluateBasis(static_cast<double>(step) / Steps, degree, this->Values[degree][step]);
      }
    }
  }
  double Values[MaximumDegree + 1][Steps + 1][MaximumDegree + 1];
};

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
        this->Uses.push_back({ use, HUGE_VAL, {}, 0.0, {} });
      }
    }
    const auto pieces = static_cast<std::size_t>(this->Curve.GetNumberOfPieces());
    this->Bends.reserve(pieces);
    this->Ends.reserve(PieceIntervals * pieces + 1);
    this->Corners.reserve(PieceIntervals * pieces);
    this->Counts.reserve(PieceIntervals * pieces);
    for (int k = 0; k < this->Curve.GetNumberOfPieces(); ++k)
    {
      this->Bends.push_back(BoundBend(this->Curve, k));
    }
    this->StraightInFaces =
      std::none_of(uses.begin(), uses.end(), [](const EdgeUse& use) { return IsBent(*use.Trim); });
  }

  EdgeSamples Run(const std::vector<EdgeUse>& uses, int minimum)
  {
    this->MakeIntervals();
    const auto bad = std::remove_if(
      this->Uses.begin(), this->Uses.end(), [](const Use& use) { return !(use.Wanted < MaxSamples); });
    if (bad != this->Uses.end())
    {
      this->Uses.erase(bad, this->Uses.end());
      this->MakeIntervals();
    }
    std::vector<double> result{ this->Curve.GetStart() };
    std::size_t first = 0;
    for (std::size_t i = 0; i < this->Counts.size(); ++i)
    {
      if (i + 1 == this->Counts.size() || this->Corners[i + 1])
      {
        this->Distribute(first, i + 1, minimum, result);
        first = i + 1;
      }
    }
    EdgeSamples samples;
    samples.T = this->Refine(result);
    samples.At.reserve(uses.size() * samples.T.size());
    auto known = this->Uses.cbegin();
    for (const EdgeUse& use : uses)
    {
      if (known != this->Uses.cend() && known->Source.Trim == use.Trim)
      {
        samples.At.insert(samples.At.end(), known->Samples.begin(), known->Samples.end());
        ++known;
        continue;
      }
      AppendPoints(*use.Trim, samples);
    }
    return samples;
  }

private:
  void MakeIntervals()
  {
    this->Ends.clear();
    this->Corners.clear();
    this->Counts.clear();
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
      this->FindTangents(k, parts);
      for (int i = 0; i < parts; ++i)
      {
        const double from = low + (high - low) * i / parts;
        const double to = i + 1 == parts ? high : low + (high - low) * (i + 1) / parts;
        this->Ends.push_back(from);
        this->Corners.push_back(i == 0 && corner);
        this->Counts.push_back(std::max(this->CountByCurve(i, to - from), this->CountByFaces(from, to)));
      }
    }
    this->Ends.push_back(this->Curve.GetEnd());
  }

  /// Sets Tangents at the ends and in the middle of the intervals of piece k, of which there are `parts`.
  void FindTangents(int k, int parts)
  {
    this->Tangents.clear();
    const BernsteinPiece<3> piece = this->Curve.GetPiece(k);
    if (this->IsPoint || piece.Degree <= 1)
    {
      return;
    }
    const double factor = piece.Degree / (this->Curve.Breaks[k + 1] - this->Curve.Breaks[k]);
    Vector3 slopes[MaximumDegree];
    for (int i = 0; i < piece.Degree; ++i)
    {
      slopes[i] = Subtract(piece.Coefficients[i + 1], piece.Coefficients[i]);
    }
    for (int step = 0; step <= 2 * parts; ++step)
    {
      const double* const basis = TangentBasis::Get(piece.Degree - 1, step * PieceIntervals / parts);
      Vector3 tangent{ 0.0, 0.0, 0.0 };
      for (int i = 0; i < piece.Degree; ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          tangent[c] += factor * basis[i] * slopes[i][c];
        }
      }
      this->Tangents.push_back(tangent);
    }
    this->Tangents.back() = GetEndTangent(this->Curve, k, true);
  }

  /// Chords that the curve wants in an interval of the piece of Tangents.
  double CountByCurve(int interval, double width) const
  {
    if (this->Tangents.empty())
    {
      return 0.0;
    }
    const Vector3* const tangent = this->Tangents.data() + 2 * interval;
    const double angle = GetAngle(tangent[0], tangent[1]) + GetAngle(tangent[1], tangent[2]);
    const double length = width * Norm(tangent[1]);
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
        // A pole gets as many points as the rows around it, so that a triangle with it leads straight to a
        // row.
        const ParameterBox& all = use.Source.Blocks->GetCovered();
        const int across = std::abs(a[0] - b[0]) >= std::abs(a[1] - b[1]) ? 1 : 0;
        box.Low[across] = all.Low[across];
        box.High[across] = all.High[across];
      }
      const SurfaceBlocks::Block m = use.Source.Blocks->GetLargest(box);
      const double w[2] = { std::abs(a[0] - b[0]), std::abs(a[1] - b[1]) };
      const double error = 0.125 * (m.Uu * w[0] * w[0] + 2.0 * m.Uv * w[0] * w[1] + m.Vv * w[1] * w[1]);
      const double wanted = std::max(std::sqrt(error / (ChordShare * this->Limits.Deflection)),
        std::hypot(m.Turn[0] * w[0], m.Turn[1] * w[1]) / this->Limits.Angle);
      use.Wanted += wanted;
      count = std::max(count, wanted);
    }
    return count;
  }

  /// Points between two corners, at equal steps of the wanted number of chords; the start is there already.
  void Distribute(std::size_t first, std::size_t last, int minimum, std::vector<double>& result) const
  {
    double total = 0.0;
    for (std::size_t i = first; i < last; ++i)
    {
      total += this->Counts[i];
    }
    const double end = this->Ends[last];
    const double start = this->Ends[first];
    const double wanted = std::min(total, 0.25 * MaxSamples);
    const int chords =
      std::max(static_cast<int>(std::ceil(wanted - 1e-3)), this->Counts.size() == last - first ? minimum : 1);
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
      // Not next to the end of an interval, which may be the end of a piece.
      const double t = !(total > 0.0) ? start + (end - start) * i / chords
        : share < SnapShare           ? this->Ends[at]
        : share > 1.0 - SnapShare     ? this->Ends[at + 1]
                                      : this->Ends[at] + share * (this->Ends[at + 1] - this->Ends[at]);
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
    std::vector<double> result;
    result.reserve(2 * coarse.size());
    for (Use& use : this->Uses)
    {
      use.Samples.reserve(2 * coarse.size());
    }
    const auto accept = [&](double t)
    {
      result.push_back(t);
      for (Use& use : this->Uses)
      {
        use.Samples.push_back(use.Evaluate(t));
      }
    };
    accept(coarse.front());
    // Chords that are still to be judged, the next one last.
    std::vector<double> ends(coarse.rbegin(), coarse.rend() - 1);
    while (!ends.empty())
    {
      const double low = result.back();
      const double high = ends.back();
      const double middle = 0.5 * (low + high);
      const double minimum = MinChord * (coarse.back() - coarse.front());
      if (result.size() + ends.size() < MaxSamples && high - low > minimum && !this->IsGood(low, high))
      {
        ends.push_back(middle);
        continue;
      }
      accept(high);
      ends.pop_back();
    }
    return result;
  }

  /// A face adjacent to the edge, and the last point that was asked for: intervals and chords meet there.
  /// Wanted: chords. Samples: the points of all chords.
  struct Use
  {
    EdgeUse Source;
    double T;
    std::array<double, 2> Point;
    double Wanted;
    std::vector<std::array<double, 2>> Samples;

    std::array<double, 2> Evaluate(double t)
    {
      this->Point = t == this->T ? this->Point : EvaluateByBasis(*this->Source.Trim, t);
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
  std::vector<Vector3> Tangents;
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
  // Distances from the line of the chord, by the convex hull: second differences where one piece holds the
  // chord, else the coefficients themselves.
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
    // A chord that begins a rounding step before the end of a piece has no part of it.
    if (!(to > from))
    {
      continue;
    }
    RestrictBernstein(b, piece.Degree, 1, from, to);
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

EdgeSamples SampleEdge(
  const Edge& edge, const std::vector<EdgeUse>& uses, const MeshLimits& limits, int minimum)
{
  return Sampler(edge, uses, limits).Run(uses, minimum);
}

void EvaluateTrims(const std::vector<EdgeUse>& uses, EdgeSamples& samples)
{
  samples.At.clear();
  for (const EdgeUse& use : uses)
  {
    AppendPoints(*use.Trim, samples);
  }
}
}
