/**
 * @file smVariantChain.h
 * @brief The closed chain of a shape that is affine in its variables: patches, panels, ribbons and caps, with
 * their orders and the bounds of what they err
 */
#ifndef smVariantChain_h
#define smVariantChain_h

#include "smFacePanels.h"
#include "smVariantPatch.h"
#include "smVariantShape.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace sm
{
/// A part of a panel with its rule: points along the trim piece, and across.
struct VariantPanel
{
  std::uint32_t Patch;
  /// First number of the trim piece in Coefficients, (s, r) in the parameters of the patch.
  std::uint32_t Trim;
  int TrimDegree;
  double Start, End, AcrossStart, AcrossEnd;
  int Along, Across;
  double Sign;
};

struct VariantRibbon
{
  std::uint32_t Patch;
  std::uint32_t Trim;
  int TrimDegree;
  double Start, End;
  /// First number of the edge piece in Coefficients, [variable][coefficient][coordinate], relative to the
  /// centre of the patch; the same for each variable.
  std::uint32_t Edge;
  int EdgeDegree;
  double EdgeStart, EdgeEnd;
  int Along;
  double Sign;
  /// Index of the coedge, counted through the loops of the face; -1: at a corner.
  int Coedge;
};

/// A triangle: apex, from, to, [corner][coordinate][variable].
struct VariantCap
{
  std::array<std::array<std::vector<double>, 3>, 3> Corners;
  double Sign;
};

/// An error of the ten moments, whatever the variables are: that of forms with these coefficients,
/// ValueFactor times the flux bound of their values and ErrorFactor times that of their errors.
struct VariantError
{
  double ValueFactor = 0.0;
  double ErrorFactor = 0.0;
  TangentForms<ErrorBound> Forms;
  /// The patch whose panels' rounding it is; -1: another error.
  int Patch = -1;
};

struct VariantFaceChain
{
  /// The directions that move the face or its edges, increasing. Variable 0 is 1, variable i + 1 is c of
  /// Directions[i].
  std::vector<int> Directions;
  std::vector<VariantPatch> Patches;
  std::vector<double> Coefficients;
  std::vector<VariantPanel> Panels;
  std::vector<VariantRibbon> Ribbons;
  std::vector<VariantCap> Caps;
  std::vector<VariantError> Errors;
  /// Largest distance, by variable, of the face's boundary from its edges at the points of the ribbons.
  std::vector<double> Gaps;

  int GetNumberOfVariables() const { return static_cast<int>(this->Directions.size()) + 1; }
};

struct VariantChainOptions
{
  /// Point that the moments are about, in the coordinates of the stored faces.
  std::array<double, 3> Reference{};
  /// Largest |c| of each direction that orders are chosen for; bounds hold for any c.
  std::vector<double> Ranges;
  /// Quadrature error of the body at |c| = range, relative to the scales of the moments.
  double Tolerance = 1e-12;
  /// Scales of the volume, and of first and second moments.
  std::array<double, 3> Scales{};
  /// Number of panels and ribbons of the body, which share the tolerance.
  double Items = 1.0;
};

/// Cuts a face and chooses the orders of its panels and ribbons. Throws std::runtime_error with the reason if
/// the face cannot be cut.
VariantFaceChain MakeFaceChain(
  const VariantShape& shape, std::size_t face, const VariantChainOptions& options);

/// Samples of position and tangents, [coordinate * variables + variable]; the moments of the chain are the
/// sums of `weight` times the flux of each sample, n = First x Second.
struct VariantSample
{
  double Weight;
  std::vector<double> Position, First, Second;
};

/// Calls visit(sample) for all samples of a face.
void VisitSamples(const VariantFaceChain& chain, const std::function<void(const VariantSample&)>& visit);
///@{
/// The same for one item.
void VisitPanel(const VariantFaceChain& chain, const VariantPanel& panel,
  const std::function<void(const VariantSample&)>& visit);
void VisitRibbon(const VariantFaceChain& chain, const VariantRibbon& ribbon,
  const std::function<void(const VariantSample&)>& visit);
void VisitCap(const VariantCap& cap, int variables, const std::function<void(const VariantSample&)>& visit);
///@}

/// Both curves of a ribbon at a node, relative to the centre of the patch, and their derivatives by the
/// ribbon's parameter on [0,1], [coordinate * variables + variable].
struct RibbonNode
{
  double Weight;
  std::vector<double> Face, Edge, FaceTangent, EdgeTangent;
};
void VisitRibbonNodes(const VariantFaceChain& chain, const VariantRibbon& ribbon,
  const std::function<void(const RibbonNode&)>& visit);

/// Returns the piece of an edge that a ribbon of the cut face refers to, whose trim piece runs over [start,
/// start + width] of the edge's parameter. In the middle of a ribbon of a rounding's length another may lie.
SMFILTERSVARIANTS_EXPORT int FindEdgePiece(
  const EdgeCurve& curve, const Ribbon& ribbon, double start, double width);

/// Evaluates a trim piece, degree + 1 pairs (s, r), and its derivative.
void EvaluateTrim(const double* trim, int degree, double t, double point[2], double slope[2]);

/// Calls visit(weight, s, r) for the nodes of a panel.
void VisitPanelNodes(const VariantFaceChain& chain, const VariantPanel& panel,
  const std::function<void(double weight, double s, double r)>& visit);

/// Returns how many samples there are, without those of caps.
std::int64_t CountSamples(const VariantFaceChain& chain);
}

#endif
