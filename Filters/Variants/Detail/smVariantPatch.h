/**
 * @file smVariantPatch.h
 * @brief A rational Bézier patch whose control points are affine in the variables, and bounds of it
 */
#ifndef smVariantPatch_h
#define smVariantPatch_h

#include "smBezierPatch.h"
#include "smChebyshev.h"
#include "smVariantMonomials.h"

#include <array>
#include <vector>

namespace sm
{
/// Weights of the patch's basis at a point, so that position and tangents are linear in the nets.
struct PatchBasis
{
  /// For Points, StepsS and StepsR, in their order.
  std::vector<double> Position, First, Second;
  /// d/ds and d/dr add these times the position relative to the centre.
  double TurnS = 0.0;
  double TurnR = 0.0;
};

struct VariantPatch
{
  int Degree[2] = { 1, 1 };
  bool IsPolynomial = true;
  /// Number of variables: 1, and the directions that move the face.
  int Variables = 1;
  /// Control points (w x) relative to Centers, [variable][coordinate][point], s fastest; their differences in
  /// s times the degree, and in r; and the same of the weights.
  std::vector<double> Points, StepsS, StepsR;
  std::vector<double> Weights, WeightStepsS, WeightStepsR;
  /// By variable; that of the first is relative to the reference point.
  std::vector<std::array<double, 3>> Centers;
  /// Bounds of the distance by which control points and centre are rounded.
  std::vector<std::array<double, 3>> Moved;

  int GetNumberOfPoints() const { return (this->Degree[0] + 1) * (this->Degree[1] + 1); }
  int GetNumberOfStepsS() const { return this->Degree[0] * (this->Degree[1] + 1); }
  int GetNumberOfStepsR() const { return (this->Degree[0] + 1) * this->Degree[1]; }

  /// Appends a variable: its control points, (w x, w y, w z, w), and their patch.
  void AddVariable(const Patch& patch, const std::array<double, 4>* points,
    const std::array<double, 3>& center, double centerError);
  /// Computes the steps, after all variables were added.
  void Finish();

  void FillBasis(double s, double r, PatchBasis& basis) const;
  /// Position relative to the reference point, or to the centre if `isLocal`, and tangents, [coordinate *
  /// Variables + variable].
  void Sample(const PatchBasis& basis, double* position, double* first, double* second, bool isLocal) const;
};

/// Returns the bounds of a sample's position and tangents, and of their rounding, for parameters that leave
/// [0,1] by no more than `outside`: by the control net. `position` is relative to the reference point if
/// `center`.
TangentForms<ErrorBound> BoundSamples(const VariantPatch& patch, const double outside[2], bool withCenter);

/// Chebyshev series of a patch, which bound it for complex parameters, see Filters/Quadrature/Bounds.md.
class VariantSeries
{
public:
  explicit VariantSeries(const VariantPatch& patch);
  /// Bounds the moduli of position (relative to the reference point, or to the centre) and tangents for (s,
  /// r) in ellipses around [0,1]. Returns false if the weight may vanish.
  bool Bound(const Ellipse& s, const Ellipse& r, bool withCenter, TangentForms<double>& forms) const;

private:
  struct Table
  {
    std::vector<double> Value, First, Second;
    /// Bound of the rounding of a coefficient.
    double Noise = 0.0;
  };
  Table Expand(const double* net) const;

  const VariantPatch& Patch_;
  int Count[2];
  std::vector<Table> Tables;
  Table Weight;
};
}

#endif
