/**
 * @file smVariantPolynomial.h
 * @brief The ten moments of all variants of a solid as polynomials in the variables, with bounds
 *
 * With trims and weights fixed every point of the closed chain is affine in c (smVariantShape.h), so that the
 * volume, the first and the second moments are exact polynomials in c of degree 3, 4 and 5: for K = 10 of
 * 286, 1001 and 3003 coefficients. Make() integrates the coefficients once, and Evaluate() takes
 * microseconds.
 *
 * Moments are those of the signed volume of the chain: V, then the integrals of x y z, of xx yy zz xy yz xz,
 * with coordinates relative to GetReference(). Length unit of the model.
 *
 * Bounds are proved: quadrature by a theorem (Detail/smVariantOrders.h), rounding by counting (Higham,
 * Accuracy and Stability of Numerical Algorithms, lemma 3.1), both in the build and in the evaluation. They
 * hold for the chain that the model's numbers define; what reading a file or fitting its curves has changed
 * is not in them. A bound that is not known is NaN.
 */
#ifndef smVariantPolynomial_h
#define smVariantPolynomial_h

#include "smFiltersVariantsModule.h"

#include "smProgressCallback.h"
#include "smVariantShape.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sm
{
struct FormTables;

struct VariantOptions
{
  /// |c_k| for which the error of quadrature meets the tolerance, positive; one for each direction, or empty:
  /// all 1. Bounds hold for any c.
  std::vector<double> Ranges;
  /// Error of quadrature relative to the scales of the body, in [1e-15, 1].
  double Tolerance = 1e-12;
};

/// What of a direction opens: how far a face's boundary is from its edge for c_k = 1, the largest found at
/// the points where ribbons are integrated, a length and no bound; and the index of that face. Of faces
/// without loops nothing opens.
struct VariantGap
{
  double Distance = 0.0;
  int Face = -1;
};

/// What follows from the ten moments of a variant, with a bound of each entry, in part coordinates; NaN where
/// it does not exist, as for a volume that is not above its bound.
struct VariantProperties
{
  double Volume, VolumeBound;
  std::array<double, 3> Center;
  double CenterBound;
  /// About the centre, row-major, negative products off the diagonal, at density 1.
  std::array<double, 9> Inertia;
  double InertiaBound;
  /// Ascending.
  std::array<double, 3> Principal;
  double PrincipalBound;
};

/// Derives them by the inequalities of the mass properties. `values` and `bounds` are 10 numbers of a
/// variant, `reference` is the point that they are about. A solid whose volume is negative is reversed.
SMFILTERSVARIANTS_EXPORT VariantProperties DeriveProperties(
  const double* values, const double* bounds, const std::array<double, 3>& reference);

/// Immutable after Make(). Thread safe.
class SMFILTERSVARIANTS_EXPORT VariantPolynomial
{
public:
  static constexpr int NumberOfValues = 10;
  /// Directions that the polynomials are made for; more are for VariantIntegrator.
  static constexpr int MaximumDirections = 24;

  /// Integrates the coefficients, on the threads of vtkSMPTools. Returns null with the reason in `error`: an
  /// option out of its range, more than MaximumDirections, a face that cannot be cut, a lack of memory, or
  /// that `progress`, which the calling thread calls between portions of the faces, returned false.
  static std::shared_ptr<const VariantPolynomial> Make(const std::shared_ptr<const VariantShape>& shape,
    const VariantOptions& options, std::string& error, const ProgressCallback& progress = {});
  ~VariantPolynomial();

  int GetNumberOfDirections() const;
  const VariantShape& GetShape() const;
  /// The point that moments are about, in part coordinates: the middle of the model's LocalBounds.
  const std::array<double, 3>& GetReference() const;

  ///@{
  /// Coefficients of a moment: their number, value, bound of the error, and the powers of c_1 ... c_K.
  std::size_t GetNumberOfCoefficients(int moment) const;
  double GetCoefficient(int moment, std::size_t index) const;
  double GetCoefficientBound(int moment, std::size_t index) const;
  std::vector<int> GetPowers(int moment, std::size_t index) const;
  ///@}

  /**
   * Evaluates n variants, c[n][K], on the threads of vtkSMPTools: values[n][10]; and where they are not null
   * bounds[n][10] of their errors, gradients[n][10][K] by c, and bounds of these in the same order. A number
   * of a variant that is not finite makes all of them NaN for that variant. Throws std::bad_alloc.
   */
  void Evaluate(const double* c, std::size_t n, double* values, double* bounds = nullptr,
    double* gradients = nullptr, double* gradientBounds = nullptr) const;

  /// The bounds alone, of the same values and gradients.
  void EvaluateBounds(const double* c, std::size_t n, double* bounds, double* gradientBounds = nullptr) const;

  /// The forms of the moments, or of their derivatives by (1, c). For this module's own classes.
  const FormTables& GetTables(bool areDerivatives) const;

  /// What each direction opens.
  const std::vector<VariantGap>& GetGaps() const;
  /// Samples that were integrated, and the seconds that this took.
  std::int64_t GetNumberOfSamples() const;
  double GetSeconds() const;

private:
  struct Internals;
  explicit VariantPolynomial(std::unique_ptr<Internals> implementation);
  std::unique_ptr<Internals> Implementation;
};
}

#endif
