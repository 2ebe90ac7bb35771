/**
 * @file smModelEdit.h
 * @brief Edits of a model: each gives a new model with new faces and shares everything else
 *
 * Pure functions: the model that is given stays as it is, so undo is to use it again. Faces and edges that
 * change get new ids, and data kept for the others (cuts, plans, integrals, GPU memory) stays valid.
 * Coordinates are those of the stored faces: lengths in the model's unit, relative to its Origin. Control
 * points are addressed by their indices in u and v.
 *
 * Setting a control point back gives the bits from before, of faces, edges and vertices (ids are new): an
 * edge that moved along with its faces remembers where it was before the first move, and is a function of
 * that and of the row of control points as it is now. Where the rows of two faces agree to rounding but not
 * bit for bit, the neighbour's row is restored to rounding only, and so is a vertex at the end of a row that
 * was moved by other edges; ModelEdit::Replaced holds the previous faces in any case.
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
  /// Only the face is changed, its edges are not: where a boundary row moved, the solid opens.
  OneFace,
  /// Where a control point lies on a boundary row that coincides with those of all faces at the edge (the
  /// same control points and knots, in either direction, to 1e-9 of the body's size), these move alike, with
  /// the edge's curve and vertices.
  MoveSharedBoundary
};

struct ControlPointIndex
{
  int U = 0;
  int V = 0;
};

/// A boundary of a face that an edit moved away from its edge, or an edge that lost a face.
struct OpenedEdge
{
  std::shared_ptr<const Edge> Source;
  /// Index of the face in the new model, and indices of loop and coedge in it. Face is -1 for an edge whose
  /// signed uses do not cancel any more.
  int Face = -1;
  int Loop = 0;
  int Coedge = 0;
  /// Largest distance of the face's boundary from the edge's curve, before the edit and after it, lengths,
  /// sampled at 32 or more parameters. Infinite where uses do not cancel.
  double GapBefore = 0.0;
  double Gap = 0.0;
};

struct ModelEdit
{
  EditStatus Status = EditStatus::Ok;
  /// The reason of the failure and a remedy; empty when Status is Ok.
  std::string Message;
  /// The edited model; null when Status is not Ok.
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  /// Indices of the faces that are new, increasing, and the faces that were there: ReplaceFaces() with them
  /// undoes the edit.
  std::vector<std::pair<int, FacePointer>> Replaced;
  /// The edges that the edit opened, by more than 1e-12 of the body's size, the widest first; empty for a
  /// solid that is as closed as before.
  std::vector<OpenedEdge> Opened;
};

/// Returns a homogeneous control point (w x, w y, w z, w), exactly as stored. Returns false if the face or
/// the control point does not exist.
SMFILTERSNURBSEDIT_EXPORT bool GetControlPoint(
  vtkTrimmedNURBSModel* model, int face, ControlPointIndex index, std::array<double, 4>& point);

/// Returns the control points that MoveSharedBoundary moves together: for each face, in the order of its
/// ControlPoints, the number of the group that a point belongs to. Points of equal numbers follow each other;
/// their weights keep their ratios. Empty without a model.
SMFILTERSNURBSEDIT_EXPORT std::vector<std::vector<int>> FindTiedPoints(vtkTrimmedNURBSModel* model);

/// Sets homogeneous control points (w x, w y, w z, w): finite, with a weight above 0. If a control point
/// occurs twice, the last value counts.
SMFILTERSNURBSEDIT_EXPORT ModelEdit SetControlPoints(vtkTrimmedNURBSModel* model, int face,
  const std::vector<std::pair<ControlPointIndex, std::array<double, 4>>>& points, EditRule rule);

/// Moves control points by a displacement, their weights stay.
SMFILTERSNURBSEDIT_EXPORT ModelEdit MoveControlPoints(vtkTrimmedNURBSModel* model, int face,
  const std::vector<ControlPointIndex>& indices, const std::array<double, 3>& displacement, EditRule rule);

/// Sets the weight of control points, which stay where they are.
SMFILTERSNURBSEDIT_EXPORT ModelEdit SetWeights(vtkTrimmedNURBSModel* model, int face,
  const std::vector<ControlPointIndex>& indices, double weight, EditRule rule);

/**
 * Exchanges a whole face. The replacement keeps its id, which must be neither 0 nor that of another face of
 * the model. With MoveSharedBoundary, and if it has the degrees and knots of the previous face, boundary rows
 * of neighbours and edges follow; the replacement then gets a new id.
 */
SMFILTERSNURBSEDIT_EXPORT ModelEdit ReplaceFace(
  vtkTrimmedNURBSModel* model, int face, FacePointer replacement, EditRule rule = EditRule::OneFace);

/// Exchanges several faces as they are; an undo, see ModelEdit::Replaced.
SMFILTERSNURBSEDIT_EXPORT ModelEdit ReplaceFaces(
  vtkTrimmedNURBSModel* model, const std::vector<std::pair<int, FacePointer>>& replacements);

/// A map of points, in the coordinates of the stored faces.
using PointMap = std::function<std::array<double, 3>(const std::array<double, 3>&)>;

/**
 * Maps the control points of the faces (all when `faces` is empty), weights stay. An edge whose faces are all
 * among them follows. Its vertices are mapped. Where the boundary rows of its faces coincide, its curve
 * follows them exactly; elsewhere the coefficients of its curve are mapped. Mapping control points differs
 * from mapping points by the order of the map's second derivatives times the squared distance of the control
 * points, which is the width of the gap that arises there. Ribbons close this gap, and Opened lists it. The
 * other faces at an edge follow as `rule` says.
 */
SMFILTERSNURBSEDIT_EXPORT ModelEdit MapControlPoints(
  vtkTrimmedNURBSModel* model, const std::vector<int>& faces, const PointMap& map, EditRule rule);

/// Compares the faces of `after` that are not those of `before` with their edges, see ModelEdit::Opened.
SMFILTERSNURBSEDIT_EXPORT std::vector<OpenedEdge> FindOpenedEdges(
  vtkTrimmedNURBSModel* before, vtkTrimmedNURBSModel* after);
}

#endif
