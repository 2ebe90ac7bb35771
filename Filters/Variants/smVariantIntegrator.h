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
 *
 * Either way runs on the CPU, or by compute shaders (OpenGL 4.3 with doubles), one invocation for each
 * variant. Both have the same samples or coefficients; their sums are rounded differently, within the bounds.
 */
#ifndef smVariantIntegrator_h
#define smVariantIntegrator_h

#include "smFiltersVariantsModule.h"

#include "smBackendChoice.h"
#include "smVariantPolynomial.h"

#include <cstdint>
#include <memory>
#include <string>

class vtkComputeContext;

namespace sm
{
enum class VariantMethod
{
  /// Points and polynomials are timed, and the faster one for the expected number of variants is taken.
  Automatic,
  Polynomial,
  Points
};

/// How an integrator is made.
struct VariantSettings
{
  VariantSettings(
    VariantMethod method = VariantMethod::Automatic, BackendChoice backend = BackendChoice::Automatic)
    : Method(method)
    , Backend(backend)
  {
  }

  VariantMethod Method;
  /// Automatic takes OpenGL on a GPU where the expected variants take all threads of the CPU more than a
  /// second and OpenGL is measured to be faster than these.
  BackendChoice Backend;
  /// The number of variants that Automatic is to be fast for.
  std::int64_t Expected = 100000;
  /// Called by the thread that calls Make(), between portions of the faces; returns false to stop.
  ProgressCallback Progress;
  /// For OpenGL; null: a context of its own, on the X display or without any by EGL. It is used by one thread
  /// at a time, and by none but the integrator during a call of it.
  vtkComputeContext* Context = nullptr;
};

/// Immutable after Make(), except that it leaves OpenGL where that fails. Thread safe; with OpenGL one call
/// of Evaluate() runs at a time.
class SMFILTERSVARIANTS_EXPORT VariantIntegrator
{
public:
  static constexpr int NumberOfValues = 10;

  /// Returns null with the reason in `error`, see VariantPolynomial::Make().
  static std::shared_ptr<const VariantIntegrator> Make(const std::shared_ptr<const VariantShape>& shape,
    const VariantOptions& options, std::string& error, const VariantSettings& settings = {});
  ~VariantIntegrator();

  /// Polynomial or Points.
  VariantMethod GetMethod() const;
  /// CPU or OpenGL. It becomes CPU where OpenGL fails.
  BackendChoice GetBackend() const;
  /// Why: the seconds of those that were tried, for a variant and for making them, and why OpenGL was left.
  std::string GetReason() const;
  int GetNumberOfDirections() const;
  const std::array<double, 3>& GetReference() const;
  const std::vector<VariantGap>& GetGaps() const;
  /// The polynomials; null with Points.
  const VariantPolynomial* GetPolynomial() const;
  /// Samples that are evaluated for each variant; those of faces that nothing moves are not among them.
  std::int64_t GetNumberOfSamples() const;

  /**
   * Evaluates n variants, c[n][K], by OpenGL or on the threads of vtkSMPTools: values[n][10], and where they
   * are not null bounds[n][10]; with polynomials also gradients[n][10][K] by c, and bounds of these, which
   * are NaN with points. All are NaN for a variant with a number that is not finite. The bits of a variant do
   * not depend on the others of the call. Where OpenGL fails the CPU evaluates all of them. Throws
   * std::bad_alloc.
   */
  void Evaluate(const double* c, std::size_t n, double* values, double* bounds = nullptr,
    double* gradients = nullptr, double* gradientBounds = nullptr) const;

private:
  struct Internals;
  explicit VariantIntegrator(std::unique_ptr<Internals> implementation);
  std::unique_ptr<Internals> Implementation;
};
}

#endif
