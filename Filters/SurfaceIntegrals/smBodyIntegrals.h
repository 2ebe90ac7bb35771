/**
 * @file smBodyIntegrals.h
 * @brief The bodies of an input and what was integrated over each
 */
#ifndef smBodyIntegrals_h
#define smBodyIntegrals_h

#include "smEdgeGaps.h"
#include "smFaceIntegrals.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smIntegrand.h"
#include "smStatus.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTrimmedNURBSModel.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkBoundingBox;
class vtkDataObject;

namespace sm
{
/// One instance of a solid or of a free shell.
struct SMFILTERSSURFACEINTEGRALS_EXPORT BodyIntegrals
{
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  /// The leaf it came in: the display mesh of this instance.
  vtkSmartPointer<vtkPolyData> Mesh;
  std::array<double, 16> Placement{};
  std::string Name;
  /// 1, 2, … in the order of the input.
  std::string Id;

  /// Results by face of the model; instances of one model may share them. Null: not computed.
  std::shared_ptr<const std::vector<FaceIntegrals>> Faces;

  /// The gaps by edge, the widest first; shared among the instances.
  std::shared_ptr<const std::vector<EdgeGap>> Edges;

  /// Sums over the faces, per integrand: over faces, ribbons and caps; over the faces alone; and the bound.
  std::vector<double> Value;
  std::vector<double> FaceValue;
  std::vector<double> Bound;
  double GapSquared = 0.0;
  double GapArea = 0.0;
  double MaxGap = 0.0;
  /// Entity numbers of the faces whose bounds are estimated, and how many faces were skipped.
  std::vector<int> EstimatedFaces;
  int SkippedFaces = 0;

  /// Edges whose signed uses do not cancel.
  int OpenEdges = 0;
  /// The faces' normals point inwards: the volume came out negative and was turned.
  bool InsideOut = false;
  /// Shells that were inside out, all of them when the solid is; and 1 or -1 by face when only some were.
  int FlippedShells = 0;
  std::vector<signed char> Sides;
  sm::Status Status = sm::Status::None;
  std::vector<std::string> Messages;
  /// That of the messages which gave it its status; empty when the status is Ok.
  std::string Reason;

  bool IsSolid() const { return this->Model->GetBody() == vtkTrimmedNURBSModel::SOLID; }
  /// A solid, or a free shell that is closed: it has a volume.
  bool HasVolume() const { return this->IsSolid() || this->OpenEdges == 0; }
  /// The factor of a face's fluxes in the sums, apart from InsideOut.
  double GetSide(std::size_t face) const { return this->Sides.empty() ? 1.0 : this->Sides[face]; }
  /// Some bound is no theorem.
  bool IsEstimated() const { return !this->EstimatedFaces.empty(); }
  /// Makes the status `status` if that is worse.
  void Degrade(sm::Status status);
  /// The same, and says why.
  void Flag(sm::Status status, const std::string& message);
};

/// Meshes found in the input that have no exact geometry: none was there, or it was dropped.
struct RejectedInput
{
  int Plain = 0;
  int Withheld = 0;
};

/// Finds every vtkNURBSDataSet with a model in a data object, in depth-first order.
SMFILTERSSURFACEINTEGRALS_EXPORT std::vector<BodyIntegrals> CollectBodies(
  vtkDataObject* input, RejectedInput& rejected);

/// Sets the status from the reader's findings and the signed uses of the edges, before anything is integrated.
SMFILTERSSURFACEINTEGRALS_EXPORT void CheckTopology(BodyIntegrals& body);

/// Checks the topology, collects what the faces say, and sums their results.
SMFILTERSSURFACEINTEGRALS_EXPORT void SumFaces(BodyIntegrals& body, const std::vector<Integrand>& integrands);

/// Sums the faces' results in face order, with compensated sums, the fluxes of a shell that was turned with the other
/// sign. A face that could not be integrated makes every bound infinite.
SMFILTERSSURFACEINTEGRALS_EXPORT void SumValues(
  BodyIntegrals& body, const std::vector<Integrand>& integrands);

/// Collects the gaps of every body's edges (smEdgeGaps.h) and names the widest where it matters.
SMFILTERSSURFACEINTEGRALS_EXPORT void MeasureEdges(std::vector<BodyIntegrals>& bodies);

/// Turns the shells that are inside out (smShellOrientation.h), given which integrand is the volume, and sums again; then
/// marks the whole body as inside out when its volume is negative. Says so. The shells of a body that is not closed stay
/// as they are.
SMFILTERSSURFACEINTEGRALS_EXPORT void TurnShells(
  BodyIntegrals& body, const std::vector<Integrand>& integrands, int volume);

/// Gives a body for which nothing was computed as many values that are NaN, and says so.
SMFILTERSSURFACEINTEGRALS_EXPORT void SetUnknown(BodyIntegrals& body, std::size_t integrands);

/// xmin, xmax, ymin … about the model's origin; from the control points where the model does not say.
SMFILTERSSURFACEINTEGRALS_EXPORT std::array<double, 6> GetBox(vtkTrimmedNURBSModel& model);
/// Adds the eight corners of a body's box where the body is placed.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddPlacedBox(const BodyIntegrals& body, vtkBoundingBox& box);
/// Half the diagonal of that box.
SMFILTERSSURFACEINTEGRALS_EXPORT double GetRadius(vtkTrimmedNURBSModel& model);
/// The largest distance of a placed body from the world origin, about.
SMFILTERSSURFACEINTEGRALS_EXPORT double GetReach(const BodyIntegrals& body);
/// Scales that tolerances are relative to; from the bounding box where the reader knows none.
SMFILTERSSURFACEINTEGRALS_EXPORT double GetVolumeScale(vtkTrimmedNURBSModel& model);
SMFILTERSSURFACEINTEGRALS_EXPORT double GetAreaScale(vtkTrimmedNURBSModel& model);
}

#endif
