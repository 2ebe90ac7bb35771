/**
 * @file smFacePanels.h
 * @brief A face cut into the work items of integration: panels, ribbons and caps
 *
 * A **panel** is the part {(xi s(t), r(t)) : 0 <= xi <= 1} of one rational Bézier patch, left of one piece
 * (s(t), r(t)) of a trim curve, in the patch's own parameters (s,r) in [0,1]^2. A **ribbon** is the ruled
 * strip (1-l) S(c(t)) + l C(t) that leads a face's boundary to its edge's curve. A **cap** is a flat triangle
 * at a corner of a loop. Along a loop, pieces that run upwards in r add the part left of them and pieces that
 * run downwards subtract it (Green's theorem), so that the panels of all loops add up to the integral over
 * the trimmed face. Together they are the closed chain of the face: the rest of its boundary are the edge
 * curves and the stubs between vertices and the ends of the edge curves, which cancel between faces. In the
 * field's terms a panel is a strip of Green's theorem, a ribbon a gap strip and a cap a corner cone;
 * Documentation/Numerics.md has a drawing.
 *
 * Everything is local to the face: the items of a face depend on nothing but the face. Where the degree in
 * u is the higher one, u and v are exchanged, so that the inner direction s is the one of lower degree.
 */
#ifndef smFacePanels_h
#define smFacePanels_h

#include "smFiltersNURBSModule.h"

#include "smBezierPatch.h"
#include "smFace.h"
#include "smOverhang.h"

#include <array>
#include <cstdint>
#include <vector>

namespace sm
{
/// Shape of a panel, as far as it decides the order of its Gauss rules.
enum class PanelShape : std::uint8_t
{
  General,
  /// Straight in s, with the normal's direction constant along s (cones): |n| and x.n are polynomial in s.
  Straight,
  /// The same, and the normal itself is constant along s (cylinders, extrusions).
  Prismatic,
  /// A parallelogram with constant normal.
  Flat
};

struct Panel
{
  std::uint32_t Patch;
  /// Trim piece: first double in FacePanels::Coefficients (u,v pairs) and degree.
  std::uint32_t Trim;
  std::uint8_t TrimDegree;
  PanelShape Shape;
  /// Sign of the coverage: -1 subtracts the part left of the piece.
  bool Negative;
  /// The outward normal is -(Ss x Sr).
  bool FlipNormal;
  /// Range of the piece's local parameter, and of xi.
  double Start, End;
  /// The piece is a covered part of the patch's right edge, between crossings of trim curves, and no trim
  /// curve itself.
  bool Covered = false;
  /// (u,v) at Start and End, in the order of the trim pieces' coordinates. Neighbours hold the same doubles.
  std::array<double, 2> From{};
  std::array<double, 2> To{};
};

struct Ribbon
{
  std::uint32_t Patch;
  std::uint32_t Trim;
  /// Edge piece: first double in Coefficients (x,y,z triples).
  std::uint32_t Edge;
  std::uint8_t TrimDegree;
  std::uint8_t EdgeDegree;
  /// The outward normal of the chain is -(X_l x X_t).
  bool FlipNormal;
  /// False for the closing strip at a loop's corner: its width says nothing about the gap to the edge.
  bool AlongEdge;
  double Start, End;
  double EdgeStart, EdgeEnd;
  /// Index of the coedge, counted through all loops of the face; -1: the strip at a loop's corner.
  int Coedge;
  /// Index of the piece of the coedge's trim curve.
  int Piece = 0;
};

/// The triangle Apex, From, To of a corner cone; the area vector of the chain is (From-Apex) x (To-Apex) / 2,
/// reversed when FlipNormal.
struct Cap
{
  std::array<double, 3> Apex, From, To;
  bool FlipNormal;
};

struct FacePanels
{
  std::vector<Patch> Patches;
  std::vector<std::array<double, 4>> Points;
  std::vector<double> Coefficients;
  std::vector<Panel> Panels;
  std::vector<Ribbon> Ribbons;
  std::vector<Cap> Caps;
  /// Cells counted more than once or negatively, over more than a sliver: a loop is wrong.
  int CoverageDefects = 0;
  /// A bound of the widest sliver that is counted so, no farther from the loops than the gaps at their
  /// corners and the tolerances of their edges (smLoopCrossings.h): a gap of the model.
  double Overlap = 0.0;
  /// Trim curves beyond the surface's domain, to which the surface is continued.
  Overhang Outside;
  /// Largest absolute values of trim pieces' coefficients, in the directions of s and r: where pieces cross
  /// knot lines is known to their rounding.
  double MaxTrim[2] = { 0.0, 0.0 };
  /// Edges that follow each other may end at different vertices: the sum of the squared ways from one by the
  /// end of the second edge's curve to the other, and the largest distance of such a point from the model's
  /// origin.
  double OpenCorners = 0.0;
  double VertexReach = 0.0;
  /// True if trim curves led where the denominator of the surface may vanish, or where, with weights that
  /// differ much, the surface would have to be continued farther than it is wide: these curves were moved to
  /// the border, and ribbons close the rest.
  bool AreTrimsMoved = false;
};

/// Cuts a face. Throws std::runtime_error naming the face when its surface or a trim curve is not valid.
SMFILTERSNURBS_EXPORT FacePanels BuildFacePanels(const Face& face);
}

#endif
