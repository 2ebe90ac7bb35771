/**
 * @file smPatchLines.h
 * @brief The points of a patch's plan line by line, as processor and shaders evaluate them
 *
 * A line has one r, that of a node along a trim piece, and nodes across it from s = 0 to the piece. What is
 * the same on a line, in wider numbers where it is a quotient or a basis value, is made here.
 */
#ifndef smPatchLines_h
#define smPatchLines_h

#include "smBernstein.h"
#include "smFacePanels.h"
#include "smPatchPlans.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sm
{
/// A patch whose integrals are wanted.
struct PatchTask
{
  const FacePanels* Panels = nullptr;
  std::uint32_t Index = 0;
  const PatchPlan* Plan = nullptr;
  /// That of PlanRequest.
  std::array<double, 3> Shift{};
  /// Bounds by how far, in x, y and z, the control points may be off.
  std::array<double, 3> Moved{};

  const Patch& GetPatch() const { return this->Panels->Patches[this->Index]; }
  const std::array<double, 4>* GetPoints() const
  {
    return this->Panels->Points.data() + this->GetPatch().FirstPoint;
  }
};

/// What is the same on a patch.
struct PatchConstants
{
  /// The patch's centre, from the point that moments are about.
  std::array<double, 3> Origin{};
  /// Largest distance of a control point from Origin, and largest steps of the net, see Patch.
  double Radius = 0.0;
  double Stretch[2] = { 0.0, 0.0 };
  /// Bounds of the distances by which a point, and its derivatives in s and r, are off because the net is; in
  /// units of u, as all roundings.
  double Off = 0.0;
  double OffSlope[2] = { 0.0, 0.0 };
  /// Number of roundings of a sample, and of additions to a sum.
  double Roundings = 0.0;
  double Additions = 0.0;
};

PatchConstants MakePatchConstants(const PatchTask& task);

struct PatchLine
{
  /// The sign of the coverage, and of the outward normal.
  double Coverage;
  double Side;
  /// s at the trim curve, and r.
  double EdgeS;
  double R;
  /// BoundBasis() of the panel.
  double Growth;
  /// Rounding of the trim curve in units of u of the patch's width, as in smPanel.glsl.
  double TrimRounding;
  /// The node along, and the range of xi: s is EdgeS (XiStart + XiWidth x) at a node x across, whose weight
  /// is Weight times that of x.
  double Weight;
  double XiStart;
  double XiWidth;
  /// Number of nodes across.
  int Across;
};

/// Returns the lines of all items of the plan.
std::vector<PatchLine> MakePatchLines(const PatchTask& task);

/// Returns a bound of the sums of the absolute values of the patch's Bernstein polynomials on a panel: 1
/// unless the trim curve leaves the patch.
double BoundBasis(const FacePanels& panels, const Panel& panel);

/// Bernstein polynomials of a degree at x, those of one degree less, and the derivatives.
struct DerivedBasis
{
  double Values[MaximumDegree + 1];
  double Lower[MaximumDegree + 1];
  double Slopes[MaximumDegree + 1];

  DerivedBasis(int degree, double x);
};
}

#endif
