/**
 * @file smModelEdit.h
 * @brief Edits of a model: each gives a new model with new faces and shares everything else
 *
 * Pure functions: the model that is given stays as it is, so undo is to use it again. Faces and edges that change get new
 * ids, and data kept for the others (cuts, plans, integrals, GPU memory) stays valid. Coordinates are those of the stored
 * faces: lengths in the model's unit, relative to its Origin. Control points are addressed by their indices in u and v.
 *
 * Setting a control point back gives the bits from before, of faces, edges and vertices (ids are new): an edge that moved along
 * with its faces remembers where it was before the first move, and is a function of that and of the row of control points as it
 * is now. Where the rows of two faces agree to rounding but not bit for bit, the neighbour's comes back to rounding only, and
 * so does a vertex at the end of a row that other edges had moved without it;
 * ModelEdit::Replaced holds the faces from before in any case.
 *
 * Thread safe as long as nobody changes the model.
 */
#ifndef smModelEdit_h
#define smModelEdit_h

#include "smFace.h"
#include "smFiltersNURBSEditModule.h"

#include "vtkSmartPointer.h" // for the new model
#include "vtkTrimmedNURBSModel.h"

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace sm
{
enum class EditStatus
{
  Ok,
  NoModel,
  NoSuchFace,
  NoSuchControlPoint,
  NotFinite,
  WeightNotPositive,
  InvalidFace
};

/// "ok", "no-model", "no-such-face" ….
SMFILTERSNURBSEDIT_EXPORT const char* GetName(EditStatus status);

/// The faces that an edit of control points moves.
enum class EditRule
{
  /// The face alone, its edges stay: where a boundary row moved, the solid opens.
  OneFace,
  /// Where a control point lies on a boundary row that coincides with those of all faces at the edge (the same control points
  /// and knots, in either direction, to 1e-9 of the body's size), these move alike, with the edge's curve and vertices.
  MoveSharedBoundary
};

struct ControlPointIndex
{
  int U = 0;
  int V = 0;
};

/// A face's boundary that an edit moved away from its edge, or an edge that lost a face.
struct OpenedEdge
{
  std::shared_ptr<const Edge> Source;
  /// Indices of the face in the new model, and of the coedge in it. Face is -1 for an edge whose uses do not cancel any more.
  int Face = -1;
  int Loop = 0;
  int Coedge = 0;
  /// Largest distance of the face's boundary from the edge's curve, before the edit and after it, lengths, sampled at 32 or more
  /// parameters. Infinite where uses do not cancel.
  double GapBefore = 0.0;
  double Gap = 0.0;
};

struct ModelEdit
{
  EditStatus Status = EditStatus::Ok;
  /// The mistake and its remedy; empty when Status is Ok.
  std::string Message;
  /// The edited model; null when Status is not Ok.
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  /// Indices of the faces that are new, increasing, and the faces that were there: ReplaceFaces() with them undoes the edit.
  std::vector<std::pair<int, FacePointer>> Replaced;
  /// The edges that the edit opened, by more than 1e-12 of the body's size, the widest first; empty for a solid that is as
  /// closed as before.
  std::vector<OpenedEdge> Opened;
};

/// Homogeneous (w x, w y, w z, w), exactly as stored. False when the face or the control point does not exist.
SMFILTERSNURBSEDIT_EXPORT bool GetControlPoint(
  vtkTrimmedNURBSModel* model, int face, ControlPointIndex index, std::array<double, 4>& point);

/// Sets homogeneous control points (w x, w y, w z, w): finite, with a weight above 0. Of one that is named twice the last counts.
SMFILTERSNURBSEDIT_EXPORT ModelEdit SetControlPoints(vtkTrimmedNURBSModel* model, int face,
  const std::vector<std::pair<ControlPointIndex, std::array<double, 4>>>& points, EditRule rule);

/// Moves control points by a displacement, their weights stay.
SMFILTERSNURBSEDIT_EXPORT ModelEdit MoveControlPoints(vtkTrimmedNURBSModel* model, int face,
  const std::vector<ControlPointIndex>& indices, const std::array<double, 3>& displacement, EditRule rule);

/// Sets the weight of control points, which stay where they are.
SMFILTERSNURBSEDIT_EXPORT ModelEdit SetWeights(vtkTrimmedNURBSModel* model, int face,
  const std::vector<ControlPointIndex>& indices, double weight, EditRule rule);

/**
 * Exchanges a whole face. It keeps its id, which must not be 0, nor that of another face of the model. With
 * MoveSharedBoundary, and the degrees and knots of the face before, its neighbours' boundary rows and its edges follow; it
 * then gets a new id.
 */
SMFILTERSNURBSEDIT_EXPORT ModelEdit ReplaceFace(
  vtkTrimmedNURBSModel* model, int face, FacePointer replacement, EditRule rule = EditRule::OneFace);

/// Exchanges several faces as they are; an undo, see ModelEdit::Replaced.
SMFILTERSNURBSEDIT_EXPORT ModelEdit ReplaceFaces(
  vtkTrimmedNURBSModel* model, const std::vector<std::pair<int, FacePointer>>& replacements);

/// A map of points, in the coordinates of the stored faces.
using PointMap = std::function<std::array<double, 3>(const std::array<double, 3>&)>;

/**
 * Maps the control points of the faces (all when `faces` is empty), weights stay. An edge whose faces are all among them follows:
 * its vertices are mapped, and its curve goes with the boundary rows where they coincide, exactly; elsewhere the coefficients of
 * its curve are mapped, and since mapping control points is not mapping points a gap arises, in the order of the map's
 * second derivatives times the squared distance of the control points, which ribbons close. It is in Opened. The other
 * faces at an edge follow as `rule` says.
 */
SMFILTERSNURBSEDIT_EXPORT ModelEdit MapControlPoints(
  vtkTrimmedNURBSModel* model, const std::vector<int>& faces, const PointMap& map, EditRule rule);

/// Compares the faces of `after` that are not those of `before` with their edges, see ModelEdit::Opened.
SMFILTERSNURBSEDIT_EXPORT std::vector<OpenedEdge> FindOpenedEdges(
  vtkTrimmedNURBSModel* before, vtkTrimmedNURBSModel* after);
}

#endif
