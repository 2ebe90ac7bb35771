/**
 * @file smVariantIntegrator.h
 * @brief The ten moments of many variants of a solid, as polynomials or at frozen points, whichever is faster
 *
 * At frozen points the samples of the faces that move, and the values of their basis, are computed once; the
 * nets of each variant are products with c, and several variants are evaluated side by side. The effort grows
 * with the number of samples, not with that of coefficients, so that it pays for many directions, or for few
 * variants.
 *
 * Moments and bounds are those of smVariantPolynomial.h. At frozen points a bound is that of the variant's
 * own c: the bounds of all items are forms, which are evaluated at |c|.
 */
#ifndef smVariantIntegrator_h
#define smVariantIntegrator_h

#include "smFiltersVariantsModule.h"

#include "smVariantPolynomial.h"

#include <cstdint>
#include <memory>
#include <string>

namespace sm
{
enum class VariantMethod
{
  /// Points and polynomials are timed, and the faster one for the expected number of variants is taken.
  Automatic,
  Polynomial,
  Points
};

/// Immutable after Make(). Thread safe.
class SMFILTERSVARIANTS_EXPORT VariantIntegrator
{
public:
  static constexpr int NumberOfValues = 10;

  /// `expected` is the number of variants, which decides between both with Automatic. Returns null with the
  /// reason in `error`, see VariantPolynomial::Make().
  static std::shared_ptr<const VariantIntegrator> Make(const std::shared_ptr<const VariantShape>& shape,
    const VariantOptions& options, std::string& error, VariantMethod method = VariantMethod::Automatic,
    std::int64_t expected = 100000);
  ~VariantIntegrator();

  /// Polynomial or Points.
  VariantMethod GetMethod() const;
  /// Why: the seconds of both, for a variant and for making them; a sentence.
  const std::string& GetReason() const;
  int GetNumberOfDirections() const;
  const std::array<double, 3>& GetReference() const;
  const std::vector<VariantGap>& GetGaps() const;
  /// The polynomials; null with Points.
  const VariantPolynomial* GetPolynomial() const;
  /// Samples that are evaluated for each variant; those of faces that nothing moves are not among them.
  std::int64_t GetNumberOfSamples() const;

  /// Evaluates n variants, c[n][K], on the threads of vtkSMPTools: values[n][10], and if it is not null
  /// bounds[n][10]; NaN for a variant with a number that is not finite. Throws std::bad_alloc.
  void Evaluate(const double* c, std::size_t n, double* values, double* bounds = nullptr) const;

private:
  struct Internals;
  explicit VariantIntegrator(std::unique_ptr<Internals> implementation);
  std::unique_ptr<Internals> Implementation;
};
}

#endif
