/**
 * @file smGapSeries.h
 * @brief The gap between a trim curve on its patch and its edge's curve as Chebyshev series, and its size for
 * complex parameters
 *
 * A ribbon X = (1-l) A + l C with A = P/w along the trim curve, C the edge's curve, G = C - A and k = 1 - l
 * has
 *
 *     x.n = det(C, G, C') - k det(C, G, G'),     n = G x (C' - k G').
 *
 * G = U/w with the polynomial U = C w - P, which is small where the gap is small: it is known in extended
 * precision, so that bounds, too, are as small as the gap. On a parallelogram U has a closed form, elsewhere
 * it is sampled.
 */
#ifndef smGapSeries_h
#define smGapSeries_h

#include "smPatchMajorants.h"
#include "smTrimSeries.h"
#include "smWideEvaluation.h"

#include <array>
#include <vector>

namespace sm
{
/// Bounds, on [0,1], of an error of a Chebyshev series and of its derivative.
struct SeriesNoise
{
  double Value = 0.0;
  double Slope = 0.0;

  /// A polynomial of degree n below e has a derivative below 2 n^2 e (Markov).
  static SeriesNoise OfPolynomial(double error, double degree)
  {
    return { error, 2.0 * degree * degree * error };
  }
  void Add(const SeriesNoise& other)
  {
    this->Value += other.Value;
    this->Slope += other.Slope;
  }
  /// The error of coefficient k.
  void Add(std::size_t k, double error) { this->Add(OfPolynomial(error, static_cast<double>(k))); }
};

class GapSeries
{
public:
  /// `shift`: see PlanRequest.
  GapSeries(const FacePanels& panels, const std::array<double, 3>& shift)
    : Panels(panels)
    , Shift(shift)
  {
  }

  /// Expands the part [start, end] of a ribbon.
  void Expand(const Ribbon& ribbon, double start, double end);

  /// Upper bounds in an ellipse of t: of |C|, |C'|, |G|, |G'| and |w'|; and a lower bound of w.
  struct Majorants
  {
    double Curve, CurveSlope, Gap, GapSlope, Weight, WeightSlope;
  };
  /// Returns false when the weight may vanish.
  bool Evaluate(const Ellipse& t, Majorants& majorants) const;

  /// Bounds of the differences of C, C', G and G' from their series at real t; infinite if there is no bound.
  /// `real`: the majorants for t in [0,1].
  struct Remainder
  {
    double Curve, CurveSlope, Gap, GapSlope;
  };
  Remainder GetRemainder(const Majorants& real) const;
  /// Returns true if the truncation error of the series of U is larger than its rounding error.
  bool IsRough() const { return this->Rough; }

  /// Upper bounds along the part: of |Ss| and |Sr|; of |Ss x Sr|; of |ds/dt| and |dr/dt|. They are estimates
  /// where the trim curve leaves its patch.
  const std::array<double, 2>& GetStretch() const { return this->Stretch; }
  double GetNormalLength() const { return this->NormalLength; }
  const std::array<double, 2>& GetTrimSlope() const { return this->TrimSlope; }

private:
  const std::array<double, 4>* GetPoints(const Ribbon& ribbon) const;
  template <class Real>
  void ExpandEdge(const Ribbon& ribbon, double start, double end);
  /// Expands in closed form on a parallelogram, for curves that share their parameter. Returns false for any
  /// other ribbon.
  bool ExpandOnPlane(const Ribbon& ribbon, double start, double end);
  /// Returns the number of nodes that determine U and w up to the truncation error Tail.
  int ChooseNodes(const Ribbon& ribbon);
  void Sample(const Ribbon& ribbon, double start, double end, int nodes);
  /// Computes Gap and its noise from samples of U and w, whose largest values are `largest` and
  /// `largestWeight`.
  template <class Real>
  void TransformSamples(
    const std::vector<std::array<Wide, 4>>& samples, double largest, double largestWeight);
  /// Returns a bound of the rounding of the samples of U; `weight` is their largest weight. Needs Stretch.
  double GetSampleNoise(const Ribbon& ribbon, double weight) const;
  /// Sets TrimSlope, and Stretch and NormalLength from the patch's. Returns false, with these 0, where the
  /// trim curve leaves the patch.
  bool BoundTangents(const Patch& patch);
  /// Raises Stretch and NormalLength to twice the values at a sample: a guess of the largest.
  void SampleTangents(const Ribbon& ribbon, const std::array<double, 2>& at);
  /// Computes Sums, which Evaluate() uses.
  void Summarize();

  const FacePanels& Panels;
  std::array<double, 3> Shift;
  TrimSeries Trim;
  PatchMajorants Crude;
  std::vector<std::array<double, 3>> Curve;
  /// Series coefficients of U (3 components) and w.
  std::vector<std::array<double, 4>> Gap;
  double CurveDistance = 0.0;
  /// Bounds, at real t, of the rounding of the series of C, U and w, and of the truncation error of U where
  /// its degree is higher than that of the series.
  double CurveNoise = 0.0;
  double Noise = 0.0;
  SeriesNoise WeightNoise;
  double Tail = 0.0;
  int GapDegree = 0;
  bool Rough = false;
  std::array<double, 2> Stretch{};
  double NormalLength = 0.0;
  std::array<double, 2> TrimSlope{};
  /// Coefficients of T_k(A) in the bounds of |C|, |C'|, |U|, |U'|, w and |w'|.
  std::vector<std::array<double, 6>> Sums;
  mutable std::vector<double> Powers;
};
}

#endif
