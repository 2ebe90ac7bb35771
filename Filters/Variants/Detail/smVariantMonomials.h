/**
 * @file smVariantMonomials.h
 * @brief Forms (homogeneous polynomials) in a few variables, and the flux of moments as forms
 *
 * The variables are 1, c_1 ... c_k, so that a form of degree d in k + 1 variables is a polynomial of degree d
 * in the c. A monomial x_a1 ... x_ad, a1 <= ... <= ad, has the index sum_i binomial(a_i + i - 1, i), the
 * colexicographic order: products of a variable a with all monomials of the variables up to a lie one after
 * another.
 */
#ifndef smVariantMonomials_h
#define smVariantMonomials_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sm
{
/// Moments in the order of smMassIntegrands.h: volume, three first ones, XX YY ZZ XY YZ XZ.
constexpr int NumberOfMoments = 10;
/// The two coordinates of each second moment.
constexpr int SecondMomentAxes[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
/// Degree of the polynomial of each moment.
constexpr int GetMomentDegree(int moment)
{
  return moment == 0 ? 3 : moment < 4 ? 4 : 5;
}
constexpr int MaximumFormDegree = 5;

/// The monomials of a number of variables up to the degree 5.
class VariantMonomials
{
public:
  explicit VariantMonomials(int variables);

  int GetVariables() const { return this->Variables; }
  /// Returns the number of monomials of a degree; the index of the first that has the variable `a`, and no
  /// later one, is that of a - 1 variables.
  std::size_t GetCount(int degree) const { return this->Counts[degree][this->Variables]; }
  std::size_t GetCount(int degree, int variables) const { return this->Counts[degree][variables]; }
  /// Returns the index of a monomial of this degree times a variable.
  std::uint32_t Multiply(int degree, std::size_t monomial, int variable) const
  {
    return this->Products[degree][monomial * this->Variables + variable];
  }
  /// Returns the variables of a monomial, increasing.
  std::array<int, MaximumFormDegree> GetFactors(int degree, std::size_t monomial) const;

private:
  int Variables;
  std::array<std::vector<std::size_t>, MaximumFormDegree + 1> Counts;
  std::array<std::vector<std::uint32_t>, MaximumFormDegree> Products;
};

/// A bound of a value, and of its error. Products and sums of such numbers bound those of the values.
struct ErrorBound
{
  double Value = 0.0;
  double Error = 0.0;
};
inline ErrorBound operator+(const ErrorBound& a, const ErrorBound& b)
{
  return { a.Value + b.Value, a.Error + b.Error };
}
inline ErrorBound operator*(const ErrorBound& a, const ErrorBound& b)
{
  return { a.Value * b.Value, a.Value * b.Error + a.Error * (b.Value + b.Error) };
}
inline ErrorBound operator*(double a, const ErrorBound& b)
{
  return { a * b.Value, a * b.Error };
}

/// Three linear forms for each of position and two tangents, [coordinate][variable].
template <typename Scalar>
struct TangentForms
{
  std::array<std::vector<Scalar>, 3> Position, First, Second;
  explicit TangentForms(std::size_t variables = 0)
  {
    for (auto* forms : { &this->Position, &this->First, &this->Second })
    {
      forms->fill(std::vector<Scalar>(variables));
    }
  }
};

/// One form for each moment.
template <typename Scalar>
using MomentForms = std::array<std::vector<Scalar>, NumberOfMoments>;

/**
 * Adds the bounds of |x . n| g(x) / (3 + degree of g), g = 1, x_i, x_i x_j, n = First x Second, coefficient
 * by coefficient, from those of the linear forms' coefficients: all terms count with a positive sign.
 */
template <typename Scalar>
void AddFluxBounds(
  const VariantMonomials& monomials, const TangentForms<Scalar>& forms, MomentForms<Scalar>& sums)
{
  const int variables = monomials.GetVariables();
  const auto multiply = [&](const std::vector<Scalar>& form, int degree, const std::vector<Scalar>& linear,
                          std::vector<Scalar>& product)
  {
    for (std::size_t m = 0; m < form.size(); ++m)
    {
      for (int a = 0; a < variables; ++a)
      {
        Scalar& to = product[monomials.Multiply(degree, m, a)];
        to = to + form[m] * linear[a];
      }
    }
  };
  std::vector<Scalar> cubic(monomials.GetCount(3));
  for (int i = 0; i < 3; ++i)
  {
    std::vector<Scalar> normal(monomials.GetCount(2));
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    multiply(forms.First[j], 1, forms.Second[k], normal);
    multiply(forms.First[k], 1, forms.Second[j], normal);
    multiply(normal, 2, forms.Position[i], cubic);
  }
  std::array<std::vector<Scalar>, 3> quartic;
  for (int i = 0; i < 3; ++i)
  {
    quartic[i].resize(monomials.GetCount(4));
    multiply(cubic, 3, forms.Position[i], quartic[i]);
  }
  const auto add = [](std::vector<Scalar>& sum, double factor, const std::vector<Scalar>& form)
  {
    sum.resize(form.size());
    for (std::size_t m = 0; m < form.size(); ++m)
    {
      sum[m] = sum[m] + factor * form[m];
    }
  };
  add(sums[0], 1.0 / 3.0, cubic);
  for (int i = 0; i < 3; ++i)
  {
    add(sums[1 + i], 0.25, quartic[i]);
  }
  for (int s = 0; s < 6; ++s)
  {
    std::vector<Scalar> quintic(monomials.GetCount(5));
    multiply(quartic[SecondMomentAxes[s][0]], 4, forms.Position[SecondMomentAxes[s][1]], quintic);
    add(sums[4 + s], 0.2, quintic);
  }
}

/// The same for numbers: bounds of position and tangents, coordinate by coordinate.
template <typename Scalar>
std::array<Scalar, NumberOfMoments> GetFluxBounds(const std::array<Scalar, 3>& position,
  const std::array<Scalar, 3>& first, const std::array<Scalar, 3>& second)
{
  Scalar cubic{};
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    cubic = cubic + position[i] * (first[j] * second[k] + first[k] * second[j]);
  }
  std::array<Scalar, NumberOfMoments> flux{};
  flux[0] = 1.0 / 3.0 * cubic;
  for (int i = 0; i < 3; ++i)
  {
    flux[1 + i] = 0.25 * (cubic * position[i]);
  }
  for (int s = 0; s < 6; ++s)
  {
    flux[4 + s] = 0.2 * (cubic * position[SecondMomentAxes[s][0]] * position[SecondMomentAxes[s][1]]);
  }
  return flux;
}
}

#endif
