/**
 * @file smReferenceIntegral.h
 * @brief The truth of the hostile sweep: moments and area of untrimmed patches in extended precision
 *
 * Written apart from the library on purpose: no trim curve, no ribbon, no knot line, no shader, no double in
 * a sum. A solid's moments are the fluxes of r g(r) / (3 + deg g) through the patches that bound it; its
 * patches share their boundary control points, so they close exactly.
 */
#ifndef smReferenceIntegral_h
#define smReferenceIntegral_h

#include <array>
#include <vector>

namespace smhostile
{
using Real = long double;
/// Homogeneous (w x, w y, w z, w).
using RealPoint = std::array<Real, 4>;

/// A rational Bézier patch; points with the first index fastest.
struct ReferencePatch
{
  int Degree[2] = { 1, 1 };
  std::vector<RealPoint> Points;
  /// The outward normal is -(Su x Sv).
  bool Reversed = false;
};

/// Volume, first moments, second moments XX YY ZZ XY YZ XZ, area; about the patches' own origin.
constexpr int NumberOfIntegrals = 11;
constexpr int AreaIntegral = 10;

struct ReferenceIntegrals
{
  std::array<Real, NumberOfIntegrals> Value{};
  /// Error bounds of the values: the last refinements' changes and the rounding of extended precision.
  std::array<Real, NumberOfIntegrals> Error{};
};

/// Values and derivatives of the Bernstein polynomials of a degree at x.
void EvaluateBernstein(int degree, Real x, std::vector<Real>& values, std::vector<Real>& derivatives);

/// Nodes and weights of the n-point Gauss rule on [0,1] in extended precision.
void ComputeExtendedGauss(int n, std::vector<Real>& nodes, std::vector<Real>& weights);

/**
 * Adaptive Gauss with 24 x 24 points on each cell: exact on any cell for the moments of polynomial patches up
 * to degree
 * 9. The cell that changes most is quartered until nothing changes above 1e-18 of the whole, or
 * `maximumCells` were quartered: then the error says what is left (the area of a patch whose normal vanishes
 * inside it).
 */
ReferenceIntegrals IntegratePatches(const std::vector<ReferencePatch>& patches, int maximumCells);

/// A polynomial or rational map of the unit cube: tensor-product Bernstein, first index fastest.
struct ReferenceBlock
{
  int Degree[3] = { 0, 0, 0 };
  std::vector<RealPoint> Points;
};

/// The same moments from the other side of the divergence theorem: integral of det DF times monomials over
/// the cube with n^3 Gauss points. Checks IntegratePatches; the area stays 0.
std::array<Real, NumberOfIntegrals> IntegrateBlock(const ReferenceBlock& block, int n);

/// A quantity in the world with the uncertainty of its truth.
template <int Count>
struct ReferenceQuantity
{
  std::array<Real, Count> Value{};
  Real Error = 0;
};

struct ReferenceProperties
{
  ReferenceQuantity<1> Volume, Area;
  ReferenceQuantity<3> Center, First, Principal, Gyration;
  ReferenceQuantity<6> Second;
  ReferenceQuantity<9> Inertia, InertiaAtOrigin;
};

/// Mass properties of the solid placed at placement * (origin + x). The 3x3 part of the placement stands for
/// a rotation or reflection and is applied to the moments as its doubles say. A negative volume changes its
/// sign.
ReferenceProperties PlaceReference(
  const ReferenceIntegrals& integrals, const double origin[3], const double placement[16]);
}

#endif
