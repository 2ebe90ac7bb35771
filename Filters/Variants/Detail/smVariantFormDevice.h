/**
 * @file smVariantFormDevice.h
 * @brief Evaluates variants as polynomials by compute shaders
 */
#ifndef smVariantFormDevice_h
#define smVariantFormDevice_h

#include <cstddef>
#include <memory>
#include <string>

class vtkComputeContext;

namespace sm
{
class VariantPolynomial;

/**
 * One invocation has a variant and four forms. Monomials by coefficients are nested sums, in which each term
 * has no more roundings than the matrix products of the CPU: 5 sums of at most K + 1 terms and 5 products
 * where K <= 12, against 72; beyond that the 64th part of the number of monomials is larger. The bounds of
 * the polynomial therefore hold. What the shaders rely on is said in smVariantDevice.h.
 *
 * Not thread safe.
 */
class VariantFormDevice
{
public:
  VariantFormDevice(vtkComputeContext* context, std::shared_ptr<const VariantPolynomial> polynomial);
  ~VariantFormDevice();

  vtkComputeContext* GetContext() const;
  /// True if buffers and programs are there, in the context's present generation.
  bool IsReady() const;
  /// Starts the context, uploads the coefficients and builds the programs.
  bool Prepare();
  /// Evaluates n variants: values[n][10], and if it is not null gradients[n][10][K]. A variant whose numbers
  /// are not in the range of smVariantNumbers.h is evaluated for c = 0: its results have no meaning.
  bool Evaluate(const double* c, std::size_t n, double* values, double* gradients);

  /// Why the last call failed.
  const std::string& GetError() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
