/**
 * @file smPatchMajorants.h
 * @brief Bounds of the integrands on a box of a rational Bézier patch, also for complex parameters
 *
 * See Bounds.md. Position, normal and weight of the patch are expanded in Chebyshev series on the box; sums
 * of absolute coefficients times T_k T_l bound them on a product of ellipses. With P = (w x, w y, w z)
 * homogeneous,
 *
 *     m = w Ps x Pr + ws Pr x P + wr P x Ps,   n = Ss x Sr = m / w^3,   x.n = D / w^3,   D = det(P, Ps, Pr),
 *
 * so every integrand but the area's is a polynomial over a power of w: the numerators, which have degrees
 * 3p-2 and 3q-2, are sampled at 3p-1 by 3q-1 nodes and so known exactly. For the area see Area below.
 */
#ifndef smPatchMajorants_h
#define smPatchMajorants_h

#include "Detail/smPatchTraits.h"
#include "smChebyshev.h"
#include "smFacePanels.h"
#include "smFiltersQuadratureModule.h"

#include <array>
#include <vector>

namespace sm
{
/// Integrands that share one bound: those of one kind and one degree of the polynomial factor.
struct BoundClass
{
  enum KindType
  {
    /// x.n g(x) / (3 + Degree).
    VolumeMoment,
    /// A component of n.
    VectorArea,
    /// |n| g(x).
    AreaMoment,
    /// z n_z g(x) / (k + 1), k the power of z in g.
    HeightMoment,
    /// A component of n, times B_ij(s,r) g(x) / w(s,r) with any Bernstein polynomial B_ij of the patch.
    NormalBasis,
    /// x.n B_ij(s,r) g(x) / w(s,r).
    FluxBasis,
    /// With R = B_ij / w and e = n / |n|, of degree 0: a component of R_s (Sr x e) + R_r (e x Ss); of degree
    /// 1: x . that + 2 R |n|.
    AreaBasis
  };
  KindType Kind;
  int Degree;

  /// Returns true if the integrand has the factor B_ij / w, or its derivatives.
  bool HasBasis() const
  {
    return this->Kind == NormalBasis || this->Kind == FluxBasis || this->Kind == AreaBasis;
  }
  /// Returns true if the integrand depends on |n|.
  bool HasLength() const { return this->Kind == AreaMoment || this->Kind == AreaBasis; }

  bool operator==(const BoundClass& other) const
  {
    return this->Kind == other.Kind && this->Degree == other.Degree;
  }
};

constexpr BoundClass PlainArea = { BoundClass::AreaMoment, 0 };

/// Intervals of s and r.
struct ParameterBox
{
  double Middle[2];
  double Half[2];

  /// The smallest distance from an edge of the patch, s = 0, s = 1, r = 0, r = 1; negative beyond it.
  double GetDistance(int edge) const
  {
    const double middle = this->Middle[edge / 2];
    return (edge % 2 == 0 ? middle : 1.0 - middle) - this->Half[edge / 2];
  }
};

/// Const methods are thread safe.
class SMFILTERSQUADRATURE_EXPORT PatchMajorants
{
public:
  /// Expands the patch on the box. `origin`: the patch's centre as seen from the point that moments are
  /// about, so that x = origin + P / w.
  void Expand(const std::array<double, 4>* points, int p, int q, const PatchTraits& traits,
    const ParameterBox& box, const std::array<double, 3>& origin);
  /// The same of a whole patch; also finds the traits of its normals, `withForm`: PolynomialLength, too.
  /// `traits` has those of FindPatchTraits().
  void ExpandPatch(const std::array<double, 4>* points, int p, int q, PatchTraits& traits,
    const ParameterBox& box, const std::array<double, 3>& origin, bool withForm = true);
  /// Frees the memory that only the next expansion needs.
  void ReleaseSamples();
  /// Computes only the series that EvaluatePosition() needs.
  void ExpandWithoutNormal(
    const std::array<double, 4>* points, int p, int q, const PatchTraits& traits, const ParameterBox& box);

  /// Bounds of the integrands of each class, without the Jacobian of the panel, for s and r (scaled to [-1,1]
  /// on the box) in the two ellipses. Returns false when the weight may vanish there; the bound of an area is
  /// infinite where |m| may vanish.
  bool Evaluate(const Ellipse& s, const Ellipse& r, const std::vector<BoundClass>& classes,
    std::vector<double>& bounds) const;
  /// Largest distance from the point that moments are about; infinite where the weight may vanish, as the
  /// next bounds are.
  double GetReach() const;
  /// A lower bound of w on the box; 0 if there is none above it.
  double GetMinWeight() const;
  /// Returns true if w is nowhere on the box below a tenth of its mean, so that the polynomial m divided by
  /// w^3 has no narrow peaks.
  bool HasEvenWeight() const;

  /// Upper bound, for real parameters, of the difference between |n| and its series where |n| is taken for a
  /// polynomial.
  double GetLengthDeviation() const;

  /// Upper bound, for real parameters, of the relative difference between |n| and its series where |n| is
  /// taken for a polynomial.
  double GetDirectionDeviation() const;
  /// Bounds of derivatives in s and r: the sums of all |R_s| and |R_r|, and |Ss| and |Sr|.
  struct Slopes
  {
    double OfBasis[2];
    double OfSurface[2];

    /// A bound of |R_s| |Sr| + |R_r| |Ss|, see BoundClass::AreaBasis.
    double GetArea() const
    {
      return this->OfBasis[0] * this->OfSurface[1] + this->OfBasis[1] * this->OfSurface[0];
    }
  };
  /// The same for real parameters.
  Slopes GetSlopes() const;

  /// |n| has no zero on the box, but at collapsed edges.
  bool HasLength() const;
  /// A lower bound of |n| on the box; 0 if there is none above it.
  double GetMinLength() const;
  /// Bounds, for real parameters, of the terms that the series omit as rounding; without the Jacobian.
  void GetDropped(const std::vector<BoundClass>& classes, std::vector<double>& dropped) const;
  /// Where the box extends beyond a collapsed edge, |n| has a kink at the edge, but its factor (s, for
  /// example) has none. Returns twice the length by which the box extends, relative to the factor's largest
  /// value, in s (0) or r (1).
  double GetKink(int direction) const;

  /// Upper bounds in the ellipses of |w x| relative to the patch's centre, and of w.
  void EvaluatePosition(const Ellipse& s, const Ellipse& r, double& position, double& weight) const;

  /// The direction in which weight and normal change more across the box: 0 for s, 1 for r.
  int GetVaryingDirection() const;

private:
  struct Table
  {
    int CountS = 0;
    int CountR = 0;
    std::vector<double> Entries;
    void Resize(int countS, int countR);
    double Sum(const std::vector<double>& s, const std::vector<double>& r) const;
  };
  using ProductEntry = std::array<double, 4>;
  ProductEntry SumProducts(const std::vector<double>& s, const std::vector<double>& r) const;
  /// The cube of the weight at a point of the box: n = factors m~ / w^3, so lengths of m~ are compared after
  /// division by it.
  double EvaluateCube(double x, double y) const;
  /// Calls visit(sample, cube of the weight there) for all nodes.
  template <class Visit>
  void VisitSamples(const Visit& visit) const;
  /// The largest |m~| / w^3 of all samples; `longest` becomes that sample.
  double FindLongestSample(const double*& longest) const;
  /// The largest part of a sample across the longest one, relative to the cube of the weight; `bound` bounds
  /// |m~ - (m~.e) e|, which has the degrees of m~.
  double MeasureAcross(const std::array<double, 4>* points, const double* longest, double& bound) const;
  /// The smallest product of the collapsed edges' factors at the nodes of samples.
  double GetMinimumFactor() const;
  /// The series of m~ and of |m~| in extended precision, four numbers a coefficient, s fastest.
  std::vector<long double> ExpandWideNormal(const std::array<double, 4>* points) const;
  /// Returns true when |m~| is the polynomial h within `allowed`, and nowhere much smaller than `largest`;
  /// `square` bounds |m~.m~ - h^2|, known in extended precision.
  bool MeasureLengthDeviation(
    const std::array<double, 4>* points, double allowed, double largest, double& square) const;
  /// |m~| is a polynomial on the box.
  bool IsPolynomialLength() const;
  /// The first part of Expand(): samples the numerators.
  void ExpandSamples(const std::array<double, 4>* points, int p, int q, const PatchTraits& traits,
    const ParameterBox& box, const std::array<double, 3>& origin);
  void MeasureNet(const std::array<double, 4>* points);
  void ExpandNet(const double* net, int countS, int countR, std::vector<double>& series);
  void ExpandDerivatives(const std::array<double, 4>* points);
  void SampleNumerators(const std::array<double, 3>& origin);
  /// The first `Used` components of the samples; the others become 0.
  template <int Used>
  void Transform(int countS, int countR);
  void MakeTables(int countS, int countR);
  void DropNoise(std::size_t count, double noise);
  /// The product of the factors of collapsed edges (s, 1-s, r, 1-r): at a point; its largest modulus in the
  /// ellipses.
  template <class Real>
  Real GetFactor(Real s, Real r) const
  {
    const std::array<bool, 4>& collapsed = this->Traits.Collapsed;
    return (collapsed[0] ? s : Real(1)) * (collapsed[1] ? 1 - s : Real(1)) * (collapsed[2] ? r : Real(1)) *
      (collapsed[3] ? 1 - r : Real(1));
  }
  double GetFactorMajorant(const Ellipse& s, const Ellipse& r) const;
  /// |z| + |1 - z| in an ellipse of direction d, no less than 1.
  double GetSpread(const Ellipse& ellipse, int d) const;
  /// The largest sum of |B_ij| in the ellipses.
  double GetBasisMajorant(const Ellipse& s, const Ellipse& r) const;
  /// GetSlopes() in the ellipses, where |w| is at least `weight`.
  Slopes GetSlopes(const Ellipse& s, const Ellipse& r, double weight) const;

  int P = 1;
  int Q = 1;
  ParameterBox Box{};
  PatchTraits Traits;
  /// |w_00|, and |m~_00| or |h_00|.
  double FirstWeight = 1.0;
  double FirstLength = 0.0;
  /// The largest difference of neighbours in s and r, times the degree: of control points relative to the
  /// patch's centre, and of weights; and the largest |w x| of a control point.
  double NetSteps[2] = { 0.0, 0.0 };
  double WeightSteps[2] = { 0.0, 0.0 };
  double NetRadius = 0.0;
  /// A lower bound of |m~| or |h| on the box, where that is positive.
  double MinimumLength = 0.0;
  /// h, or m~ . e with its direction e at the middle, is positive on the box; and |m~| is.
  bool Positive = false;
  bool Nonzero = false;
  /// Sums of the coefficients of D, m~ and h that were dropped.
  std::array<double, 3> Dropped{};
  /// Distance of the box's centre from the origin of moments, and from the patch's centre.
  double CenterDistance = 0.0;
  double CenterOffset = 0.0;

  // Series of (w x, w y, w z, w) and of its derivatives, four doubles a coefficient, s fastest.
  std::vector<double> Series[3];
  // Samples, then coefficients, of D, m~ (3) and |m~|: five doubles a node; and the samples of w.
  static constexpr int Components = 5;
  std::vector<double> Samples;
  std::vector<double> Weights;
  std::vector<double> Scratch;

  Table Weight;   // |w_kl| without the first
  Table Position; // |P_kl - c w_kl|, c = P_00 / w_00
  // Four tables of one size, entry by entry, which are summed together.
  enum Product
  {
    Numerator, // |D_kl|
    Normal,    // |m_kl|, or |m~_kl| with m = factors m~
    Along,     // |m~_kl . e| without the first, e = m~_00 / |m~_00|; or |h_kl|, h = |m~|
    Across     // |m~_kl - (m~_kl . e) e|
  };
  int CountS = 0;
  int CountR = 0;
  std::vector<ProductEntry> Products;
};
}

#endif
