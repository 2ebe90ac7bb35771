/**
 * @file smVariantOrders.h
 * @brief Orders of the rules for panels and ribbons that are affine in variables, and the errors that remain
 *
 * The theorem is that of smQuadratureBound.h: f analytic in the ellipse of radius rho with |f| <= M there is
 * integrated by N points up to (32/15) M rho^(-2N) / (1 - rho^-2). Here f is any coefficient of the
 * polynomial in the variables: the flux of moments, multiplied out, with the bounds of the linear forms'
 * coefficients in place of these, bounds every coefficient on the ellipse. Ellipses around a patch come from
 * a short list of targets. For a part of a panel the largest rho is taken whose ellipse the trim curve maps
 * into the target, so that all parts of a patch share the bounds of its targets. Where weights are constant
 * the integrand is a polynomial, which half its degree + 1 points integrate exactly.
 */
#ifndef smVariantOrders_h
#define smVariantOrders_h

#include "smTrimSeries.h"
#include "smVariantChain.h"

#include <memory>
#include <vector>

namespace sm
{
/// Plans the items of one face, all patches and coefficients of which are there.
class VariantOrders
{
public:
  /// `patches` are those of the cut face.
  VariantOrders(
    VariantFaceChain& chain, const std::vector<Patch>& patches, const VariantChainOptions& options);
  ~VariantOrders();

  /// Announces a trim piece, (u, v) pairs, before anything is planned: how far it leaves its patch.
  void Announce(std::uint32_t patch, const double* trim, int degree, double start, double end);
  /// Adds the parts of a panel or ribbon with their orders; `trim` has (u, v) pairs.
  void AddPanel(const VariantPanel& panel, const double* trim);
  void AddRibbon(const VariantRibbon& ribbon, const double* trim);
  /// Adds the errors of all items to the chain.
  void Finish();

private:
  struct Target;
  struct PatchState;
  struct EdgeBounds;
  PatchState& GetState(std::uint32_t patch);
  double Measure(const TangentForms<double>& forms) const;
  double FindRadius(const TrimSeries& trim, const Target& target, double acrossStart, double acrossEnd) const;
  void DividePanel(const VariantPanel& panel, const double* trim, int depth);
  void DivideRibbon(const VariantRibbon& ribbon, const double* trim, int depth);
  void AddRibbonRounding(const VariantRibbon& ribbon);
  void AddCapRounding(const VariantCap& cap);
  TangentForms<double> BoundRibbon(
    const VariantRibbon& ribbon, const TrimSeries& trim, const Target& target, double radius) const;

  VariantFaceChain& Chain;
  const std::vector<Patch>& Patches;
  const VariantChainOptions& Options;
  std::vector<double> Ranges;
  double Share;
  std::vector<std::unique_ptr<PatchState>> States;
};
}

#endif
