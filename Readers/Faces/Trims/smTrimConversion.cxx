#include "smTrimConversion.h"

#include "Geometry/smChebyshevFit.h"
#include "Geometry/smFlatKnots.h"
#include "smTrimResidual.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace sm
{
namespace
{
constexpr int TrimDegree = 9;

/// Maps the parameter of a pcurve to that of its edge; they are equal unless their ranges differ in the file.
struct RangeMap
{
  double From[2];
  double To[2];
  double operator()(double t) const
  {
    if (t == this->From[0])
    {
      return this->To[0];
    }
    if (t == this->From[1])
    {
      return this->To[1];
    }
    if (this->From[0] == this->To[0] && this->From[1] == this->To[1])
    {
      return t;
    }
    return this->To[0] + (t - this->From[0]) / (this->From[1] - this->From[0]) * (this->To[1] - this->To[0]);
  }
};

/// Sets a component that is equal for all poles up to rounding to exactly one value, without the rounding of
/// blossoming.
void KeepConstant(const std::vector<TrimCurve::Point>& poles, TrimCurve& curve)
{
  for (int d = 0; d < 2; ++d)
  {
    double low = poles[0][d];
    double high = low;
    for (const TrimCurve::Point& p : poles)
    {
      low = std::min(low, p[d]);
      high = std::max(high, p[d]);
    }
    if (high - low <= 8.0 * UnitRoundoff * std::max(std::abs(low), std::abs(high)))
    {
      for (TrimCurve::Point& p : curve.Coefficients)
      {
        p[d] = poles[0][d];
      }
      curve.RaiseResidual(d, high - low);
    }
  }
}

/// Fits a trim curve for which at least one parameter map is not linear.
class TrimFitter
{
public:
  TrimFitter(const NativeTrim& trim, const RangeMap& range, const ParameterMap maps[2], const double width[2])
    : Trim(trim)
    , Range(range)
    , Maps(maps)
    , Width{ width[0], width[1] }
  {
    this->Tolerance = GetTrimTolerance(maps, width);
    if (trim.Feet)
    {
      this->Most = 40 + 4 * static_cast<int>(trim.GetBreaks().size());
    }
  }

  /// Returns true if the fit is poor: its residual is far above rounding, or it was stopped after many more
  /// pieces than the curve has. Foot points close to a nearly singular point of the surface are not a smooth
  /// function of the parameter.
  bool IsPoor() const { return this->GivenUp || this->HasLargeResidual(); }

  /// Returns true if the fit was stopped before the end of the curve.
  bool IsIncomplete() const { return this->GivenUp; }

  const TrimCurve& Fit()
  {
    this->FindConstants();
    this->Result.Breaks.push_back(this->Range(this->Trim.First));
    if (this->IsStraight())
    {
      TrimCurve::Point ends[2] = { this->Trim.GetStart(), this->Trim.GetEnd() };
      for (int d = 0; d < 2; ++d)
      {
        if (this->Constant[d])
        {
          ends[0][d] = ends[1][d] = this->Value[d];
        }
      }
      this->Result.AppendPiece(this->Range(this->Trim.Last), ends, 1);
      return this->Result;
    }
    const std::vector<double> breaks = this->Trim.GetBreaks();
    const auto points = this->Trim.Samples.empty() ? this->Trim.Sample() : this->Trim.Samples;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
      Samples native;
      for (int k = 0; k <= FitOrder; ++k)
      {
        const std::array<double, 2>& p = points[i * (FitOrder + 1) + k];
        native[k] = { p[0] + this->Trim.Shift[0], p[1] + this->Trim.Shift[1] };
      }
      this->CutAndFit(breaks[i], breaks[i + 1], native, Attempt());
    }
    if (this->HasLargeResidual())
    {
      this->SetPieceResiduals();
    }
    return this->Result;
  }

private:
  using Samples = std::array<std::array<double, 2>, FitOrder + 1>;

  /// Number of halvings of an interval, and the residual of its parent in tolerances.
  struct Attempt
  {
    int Depth = 0;
    double Excess = std::numeric_limits<double>::infinity();
  };

  void SampleNative(double a, double b, Samples& native) const
  {
    for (int i = 0; i <= FitOrder; ++i)
    {
      const double x = GetFitNodes()[i];
      native[i] = this->Trim.Evaluate(i == FitOrder ? b : a + x * (b - a));
    }
  }

  /// Finds components that vary by no more than the tolerance, which are made constant.
  void FindConstants()
  {
    NativeBox box{ { 1e300, 1e300 }, { -1e300, -1e300 } };
    this->Trim.AddTo(box);
    for (int d = 0; d < 2; ++d)
    {
      const double largest = std::max(std::abs(box.Low[d]), std::abs(box.High[d]));
      const double cell = this->Maps[d].Type == ParameterMap::Kind::Identity ? 1.0 : this->Maps[d].Width;
      const double spread = box.High[d] - box.Low[d];
      this->Constant[d] = spread <= std::max(8.0 * UnitRoundoff * largest, 0.2 * this->Tolerance[d] * cell);
      if (this->Constant[d])
      {
        const double middle = spread == 0.0 ? box.Low[d] : 0.5 * (box.Low[d] + box.High[d]);
        this->Value[d] = this->Maps[d].Evaluate(middle + this->Trim.Shift[d]);
        const double slope = this->Maps[d].Type == ParameterMap::Kind::Identity ? 1.0 : 1.0 / cell;
        this->Result.RaiseResidual(d, 0.5 * spread * slope);
      }
    }
  }

  /// Returns true for a line along which the parameters with nonlinear maps are constant.
  bool IsStraight() const
  {
    if (!this->Trim.GetLine())
    {
      return false;
    }
    return (this->Constant[0] || this->Maps[0].Type == ParameterMap::Kind::Identity) &&
      (this->Constant[1] || this->Maps[1].Type == ParameterMap::Kind::Identity);
  }

  /// Returns the parameter at which component d crosses `border` inside [a, b]; its differences from it at
  /// the ends must have different signs.
  double FindCrossing(int d, double border, double a, double b, bool rising) const
  {
    for (int i = 0; i < 80; ++i)
    {
      const double middle = 0.5 * (a + b);
      if (!(middle > a && middle < b))
      {
        break;
      }
      ((this->Trim.Evaluate(middle)[d] > border) == rising ? b : a) = middle;
    }
    return 0.5 * (a + b);
  }

  bool HasLargeResidual() const
  {
    constexpr double large = 1e-10;
    for (int d = 0; d < 2; ++d)
    {
      const double width = this->Maps[d].Type == ParameterMap::Kind::Identity ? this->Width[d] : 1.0;
      if (this->Result.Residual[d] > large * width)
      {
        return true;
      }
    }
    return false;
  }

  /// The curve is far from the original in a few short pieces, around a singular point of the surface.
  void SetPieceResiduals()
  {
    for (TrimCurve::Point& residual : this->FitResiduals)
    {
      for (int d = 0; d < 2; ++d)
      {
        residual[d] = this->Constant[d] ? this->Result.Residual[d] : residual[d];
      }
    }
    this->Result.PieceResiduals = std::move(this->FitResiduals);
  }

  /// A circle that passes a pole of its sphere needs many pieces, each of which is good.
  bool IsGivenUp()
  {
    const int maximum = this->HasLargeResidual() ? this->Most : MaxGoodPieces * this->Most;
    this->GivenUp = this->Trim.Feet && this->Result.GetNumberOfPieces() >= maximum;
    return this->GivenUp;
  }

  void FitInterval(double a, double b, const Attempt& attempt)
  {
    if (this->IsGivenUp())
    {
      return;
    }
    Samples native;
    this->SampleNative(a, b, native);
    this->CutAndFit(a, b, native, attempt);
  }

  /// Cuts at the borders of arcs, then fits the parts between them.
  void CutAndFit(double a, double b, const Samples& native, const Attempt& attempt)
  {
    if (this->IsGivenUp())
    {
      return;
    }
    std::vector<double> cuts;
    for (int d = 0; d < 2; ++d)
    {
      const ParameterMap& map = this->Maps[d];
      if (map.Type != ParameterMap::Kind::Circular || this->Constant[d])
      {
        continue;
      }
      double low = native[0][d];
      double high = low;
      for (const auto& p : native)
      {
        low = std::min(low, p[d]);
        high = std::max(high, p[d]);
      }
      const int end = std::min(map.Count, map.FindArc(high) + 2);
      for (int k = std::max(1, map.FindArc(low)); k < end; ++k)
      {
        const double border = map.GetBorder(k);
        // A piece that only touches the border at an end is not cut there.
        const double slack = 8.0 * UnitRoundoff * std::max({ 1.0, std::abs(map.Start), std::abs(border) });
        for (int i = 0; i < FitOrder; ++i)
        {
          const double before = native[i][d] - border;
          const double after = native[i + 1][d] - border;
          if ((before < -slack && after > slack) || (before > slack && after < -slack))
          {
            const double x0 = a + GetFitNodes()[i] * (b - a);
            const double x1 = a + GetFitNodes()[i + 1] * (b - a);
            cuts.push_back(this->FindCrossing(d, border, x0, x1, after > 0.0));
          }
          else if (i > 0 && std::abs(before) <= slack &&
            (native[i - 1][d] - border) * (native[i + 1][d] - border) < 0.0)
          {
            cuts.push_back(a + GetFitNodes()[i] * (b - a));
          }
        }
      }
    }
    std::sort(cuts.begin(), cuts.end());
    const double slack = std::max(1e-13 * (b - a), 4.0 * UnitRoundoff * std::max(std::abs(a), std::abs(b)));
    double start = a;
    for (const double cut : cuts)
    {
      if (cut > start + slack && cut < b - slack)
      {
        this->FitPieceWithin(start, cut, attempt);
        start = cut;
      }
    }
    if (start == a)
    {
      this->FitSampled(a, b, native, attempt);
    }
    else
    {
      this->FitPieceWithin(start, b, attempt);
    }
  }

  void FitPieceWithin(double a, double b, const Attempt& attempt)
  {
    Samples native;
    this->SampleNative(a, b, native);
    this->FitSampled(a, b, native, attempt);
  }

  void FitSampled(double a, double b, const Samples& native, const Attempt& attempt)
  {
    Samples mapped;
    for (int d = 0; d < 2; ++d)
    {
      const ParameterMap& map = this->Maps[d];
      const int arc = map.FindArc(native[FitOrder / 2][d]);
      for (int i = 0; i <= FitOrder; ++i)
      {
        mapped[i][d] = this->Constant[d]             ? this->Value[d]
          : map.Type == ParameterMap::Kind::Identity ? native[i][d]
                                                     : map.EvaluateInArc(arc, native[i][d]);
      }
    }
    std::array<double, 2> tolerance = this->Tolerance;
    for (int d = 0; d < 2; ++d)
    {
      tolerance[d] = std::max(
        tolerance[d], 8.0 * UnitRoundoff * std::max(std::abs(mapped[0][d]), std::abs(mapped[FitOrder][d])));
    }
    FittedPiece<2> piece;
    const bool met = FitPiece<2>(mapped, TrimDegree, tolerance, piece);
    const double excess = std::max(piece.Residual[0] / tolerance[0], piece.Residual[1] / tolerance[1]);
    const bool noise = excess > NoiseRatio * attempt.Excess && excess < MaximumNoise;
    const double middle = 0.5 * (a + b);
    if (!met && !noise && attempt.Depth < MaximumDepth && middle > a && middle < b)
    {
      const Attempt next{ attempt.Depth + 1, excess };
      this->FitInterval(a, middle, next);
      this->FitInterval(middle, b, next);
      return;
    }
    for (int d = 0; d < 2; ++d)
    {
      if (this->Constant[d])
      {
        for (int i = 0; i <= piece.Degree; ++i)
        {
          piece.Coefficients[i][d] = this->Value[d];
        }
      }
      else
      {
        this->Result.RaiseResidual(d, piece.Residual[d]);
      }
    }
    this->FitResiduals.push_back(piece.Residual);
    if (this->Result.GetNumberOfPieces() >= MaximumPieces)
    {
      throw std::runtime_error(
        "the curve of an edge on it needs more than " + std::to_string(MaximumPieces) + " pieces");
    }
    this->Result.AppendPiece(this->Range(b), piece.Coefficients.data(), piece.Degree);
  }

  const NativeTrim& Trim;
  RangeMap Range;
  const ParameterMap* Maps;
  std::array<double, 2> Tolerance{};
  bool Constant[2] = { false, false };
  double Value[2] = { 0.0, 0.0 };
  const double Width[2];
  static constexpr int MaxGoodPieces = 5;
  /// Number of pieces at which the fit is stopped; MaxGoodPieces times as many if all pieces are good.
  int Most = MaximumPieces;
  bool GivenUp = false;
  /// Residuals of the fits of all pieces.
  std::vector<TrimCurve::Point> FitResiduals;
  TrimCurve Result;
};
}

std::array<double, 2> GetTrimTolerance(const ParameterMap maps[2], const double width[2])
{
  // If the other parameter is an angle, whose arcs have width 1, a length is fitted to rounding: the
  // tolerance 1e-13 of a long cylinder would be far larger than 1e-13 of an arc.
  const bool plain = maps[0].Type == maps[1].Type;
  std::array<double, 2> tolerance;
  for (int d = 0; d < 2; ++d)
  {
    tolerance[d] = maps[d].Type == ParameterMap::Kind::Identity
      ? (plain ? 1e-13 : 1e-15) * width[d]
      : std::max(1e-13, 2.0 * maps[d].GetRounding());
  }
  return tolerance;
}

namespace
{
/// Adds the trim curve's distance from the foot points that it stands for to its residual.
void AddNativeResidual(const double residual[2], const ParameterMap maps[2], TrimCurve& curve)
{
  for (int d = 0; d < 2; ++d)
  {
    curve.AddResidual(d, residual[d] * maps[d].GetMaxSlope());
  }
}

TrimCurve ConvertTo(
  const NativeTrim& trim, const RangeMap& range, const ParameterMap maps[2], const double width[2]);

/// Converts a spline through foot points that are not a smooth function, to its measured distance from
/// them. Empty if it fails.
TrimCurve ConvertApproximation(
  const NativeTrim& trim, const RangeMap& range, const ParameterMap maps[2], const double width[2])
{
  NativeTrim other = trim;
  other.Curve = trim.Feet->Approximate();
  other.Feet = nullptr;
  other.Samples.clear();
  if (!other.Curve)
  {
    return {};
  }
  const std::vector<double> breaks = trim.GetBreaks();
  double residual[2] = { 0.0, 0.0 };
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
  {
    for (const double x : GetFitNodes())
    {
      const double t = (1.0 - x) * breaks[k] + x * breaks[k + 1];
      const std::array<double, 2> foot = trim.Evaluate(t);
      const std::array<double, 2> point = other.Evaluate(t);
      for (int d = 0; d < 2; ++d)
      {
        residual[d] = std::max(residual[d], std::abs(point[d] - foot[d]));
      }
    }
  }
  TrimCurve result = ConvertTo(other, range, maps, width);
  AddNativeResidual(residual, maps, result);
  return result;
}

TrimCurve ConvertTo(
  const NativeTrim& trim, const RangeMap& range, const ParameterMap maps[2], const double width[2])
{
  const auto* spline = trim.Feet ? nullptr : trim.Curve->GetIf<SplineCurve<2>>();
  const bool plain = !trim.Feet && maps[0].Type == ParameterMap::Kind::Identity &&
    maps[1].Type == ParameterMap::Kind::Identity;
  if (plain && spline && spline->Weights.empty())
  {
    const FlatKnots flat = spline->Basis.Flatten(trim.First, trim.Last);
    std::vector<TrimCurve::Point> poles;
    for (const int i : flat.Poles)
    {
      poles.push_back({ spline->Poles[i][0] + trim.Shift[0], spline->Poles[i][1] + trim.Shift[1] });
    }
    TrimCurve result;
    const std::vector<double> breaks = trim.GetBreaks();
    result.Breaks.push_back(range(breaks[0]));
    TrimCurve::Point piece[MaximumDegree + 1];
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    {
      ExtractBezierPiece<2>(flat, poles, breaks[i], breaks[i + 1], piece);
      result.AppendPiece(range(breaks[i + 1]), piece, flat.Degree);
    }
    KeepConstant(poles, result);
    return result;
  }
  TrimFitter fitter(trim, range, maps, width);
  const TrimCurve& fitted = fitter.Fit();
  if (!trim.Feet || !fitter.IsPoor())
  {
    return fitted;
  }
  TrimCurve approximation = ConvertApproximation(trim, range, maps, width);
  const bool isUsable = approximation.GetNumberOfPieces() > 0;
  if (!fitter.IsIncomplete() && !(isUsable && GetSweptArea(approximation) < GetSweptArea(fitted)))
  {
    return fitted;
  }
  if (!isUsable)
  {
    throw std::runtime_error("the feet of an edge on it do not move smoothly");
  }
  return approximation;
}
}

TrimCurve ConvertTrim(const NativeTrim& trim, double edgeFirst, double edgeLast, const ParameterMap maps[2],
  const double width[2])
{
  TrimCurve result = ConvertTo(trim, { { trim.First, trim.Last }, { edgeFirst, edgeLast } }, maps, width);
  AddNativeResidual(trim.Residual, maps, result);
  return result;
}
}
