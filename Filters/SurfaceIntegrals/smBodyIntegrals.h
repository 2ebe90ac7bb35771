/**
 * @file smBodyIntegrals.h
 * @brief The bodies of an input and their integrals
 */
#ifndef smBodyIntegrals_h
#define smBodyIntegrals_h

#include "Engine/smFaceIntegrals.h"
#include "smClosingSpread.h"
#include "smEdgeGaps.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smIntegrand.h"
#include "smStatus.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTrimmedNURBSModel.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkDataObject;

namespace sm
{
/// Faces that together make their body suspect.
struct FaceDefect
{
  std::vector<std::size_t> Faces;
  std::string Reason;
  /// True if the whole faces count wrongly. Otherwise the area and volume that are in doubt are those below,
  /// NaN where not known.
  bool IsWhole = false;
  double Area = std::numeric_limits<double>::quiet_NaN();
  double Volume = std::numeric_limits<double>::quiet_NaN();
};

/// One instance of a solid or of a free shell.
struct SMFILTERSSURFACEINTEGRALS_EXPORT BodyIntegrals
{
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  /// Input dataset of the body: the display mesh of this instance.
  vtkSmartPointer<vtkPolyData> Mesh;
  std::array<double, 16> Placement{};
  /// Name of the solid in the file, which several instances may have.
  std::string Name;
  /// Name of its block in the input.
  std::string Block;
  /// Name of the instance that no other one has, with its place in the product structure: "rod-assembly/nut
  /// (2)".
  std::string Path;
  /// Number of the instance, 1, 2, … in the order of the input.
  std::string Id;

  /// Results for each face of the model; instances of a model may share them. Null if not computed.
  std::shared_ptr<const std::vector<FaceIntegrals>> Faces;

  /// Gaps for each edge, the widest first; shared among the instances.
  std::shared_ptr<const std::vector<EdgeGap>> Edges;

  /// What other closings of its gaps may change, in coordinates of the model; null if it was not measured.
  std::shared_ptr<const ClosingSpread> Spread;

  /// Sums per integrand: over faces, ribbons and caps; over the faces alone; and the bound.
  std::vector<double> Value;
  std::vector<double> FaceValue;
  std::vector<double> Bound;
  /// The part of Bound that is estimated: the rounding of samples, whose constants were measured and are not
  /// proved (Bounds.md, 2), and measured residuals (3).
  std::vector<double> MeasuredBound;
  double GapSquared = 0.0;
  double GapArea = 0.0;
  double MaxGap = 0.0;
  /// Largest distance of an edge from the domain of a surface that is continued to it; included in MaxGap.
  double MaxOverhang = 0.0;
  /// The widest overlap of a face's loops next to gaps at their corners.
  double MaxOverlap = 0.0;
  /// Entity numbers of the faces whose bounds are estimated, and of those that were left out; the number of
  /// faces that were skipped.
  std::vector<std::int64_t> EstimatedFaces;
  std::vector<std::int64_t> LeftOutFaces;
  int SkippedFaces = 0;
  /// Defects of faces that make the body suspect. Edges do so if they are open or their gap is wider than
  /// ExcusedGap.
  std::vector<FaceDefect> FaceDefects;
  double ExcusedGap = std::numeric_limits<double>::infinity();

  /// Number of edges whose signed uses do not cancel.
  int OpenEdges = 0;
  /// True if the normals of all faces point inwards: the volume was negative and was reversed.
  bool InsideOut = false;
  /// Number of shells whose normals pointed inwards, which is all of them for an inside-out solid. If only
  /// some did, Sides has the factor 1 or -1 for each face.
  int FlippedShells = 0;
  std::vector<signed char> Sides;
  sm::Status Status = sm::Status::None;
  std::vector<std::string> Messages;
  /// The message that determined the status; empty if the status is Ok.
  std::string Reason;

  /// Returns the name, or "solid 3" by the Id.
  std::string GetLabel() const { return this->Name.empty() ? "solid " + this->Id : this->Name; }
  bool IsSolid() const { return this->Model->GetBody() == vtkTrimmedNURBSModel::SOLID; }
  /// Returns true for a solid and for a closed free shell.
  bool HasVolume() const { return this->IsSolid() || this->OpenEdges == 0; }
  /// Returns the factor of a face's fluxes in the sums, without the effect of InsideOut.
  double GetSide(std::size_t face) const { return this->Sides.empty() ? 1.0 : this->Sides[face]; }
  /// Returns true if the bound of some face is estimated and not proved.
  bool IsEstimated() const { return !this->EstimatedFaces.empty(); }
  /// Sets the status to `status` if that is worse.
  void Degrade(sm::Status status);
  /// Calls Degrade() and adds a message.
  void Flag(sm::Status status, const std::string& message);
};

/// Numbers of meshes in the input without exact geometry: those that never had it, and those that lost it.
struct RejectedInput
{
  int Plain = 0;
  int Withheld = 0;
  /// Those of them that have points, with the names of their blocks.
  std::vector<std::pair<vtkDataObject*, std::string>> Meshes;
};

/// Returns a body for every vtkNURBSDataSet with a model in a data object, in depth-first order.
SMFILTERSSURFACEINTEGRALS_EXPORT std::vector<BodyIntegrals> CollectBodies(
  vtkDataObject* input, RejectedInput& rejected);

/// Removes the bodies for whose names `leavesOut` is true. Returns a message that names them; empty if there
/// are none.
SMFILTERSSURFACEINTEGRALS_EXPORT std::string LeaveOut(
  const std::function<bool(const std::string& name)>& leavesOut, std::vector<BodyIntegrals>& bodies);

/// Sets the status from the reader's findings and the signed uses of the edges, before anything is
/// integrated.
SMFILTERSSURFACEINTEGRALS_EXPORT void CheckTopology(BodyIntegrals& body);

/// Checks the topology, collects the messages of the faces, and sums their results.
SMFILTERSSURFACEINTEGRALS_EXPORT void SumFaces(BodyIntegrals& body, const std::vector<Integrand>& integrands);

/// Adds up the faces' results in face order with compensated sums. The fluxes of reversed shells have the
/// opposite sign. A face that could not be integrated makes every bound infinite.
SMFILTERSSURFACEINTEGRALS_EXPORT void SumValues(
  BodyIntegrals& body, const std::vector<Integrand>& integrands);

/// Collects the gaps of every body's edges (smEdgeGaps.h), and adds a message about the widest gap if it is
/// significant and `reportSmall`. The body is suspect if that gap, MaxOverhang or MaxOverlap is wider than
/// `limit` times its diagonal and than the file excuses.
SMFILTERSSURFACEINTEGRALS_EXPORT void MeasureEdges(
  std::vector<BodyIntegrals>& bodies, double limit, bool reportSmall);

/// Measures what other closings of the bodies' gaps may change, and adds it to the gaps of their edges.
SMFILTERSSURFACEINTEGRALS_EXPORT void MeasureSpreads(
  ClosingSpreads& spreads, std::vector<BodyIntegrals>& bodies);

/// Returns the largest gap or change that does not make a body suspect: `limit` times `size`, or `excuse`,
/// which follows from the uncertainty of the file, if that is larger, but at most ten times `limit` times
/// `size`; infinity if `limit` is 1.
SMFILTERSSURFACEINTEGRALS_EXPORT double GetExcused(double limit, double size, double excuse);

/// Reverses the shells whose normals point inwards (smShellOrientation.h), where `volume` is the index of the
/// volume's integrand, and sums again. It then marks the whole body as inside out if its volume is negative.
/// Both add a message. The shells of a body that is not closed remain unchanged.
SMFILTERSSURFACEINTEGRALS_EXPORT void ReverseShells(
  BodyIntegrals& body, const std::vector<Integrand>& integrands, int volume);

/// Flags a closed body as suspect if its shells are not nested, or not oriented, as a solid's are, by the
/// volumes of its display mesh: needed for integrals over a part of the body, whose values do not show it.
SMFILTERSSURFACEINTEGRALS_EXPORT void CheckShells(BodyIntegrals& body);

/// Returns how much closing the gaps of the bodies changed the sum of an integrand, each body's change
/// without its sign; NaN if unknown.
SMFILTERSSURFACEINTEGRALS_EXPORT double SumClosing(
  const std::vector<BodyIntegrals>& bodies, std::size_t integrand);

/// Sets the values of a body for which nothing was computed to NaN, one per integrand, and adds a message.
SMFILTERSSURFACEINTEGRALS_EXPORT void SetUnknown(BodyIntegrals& body, std::size_t integrands);
}

#endif
