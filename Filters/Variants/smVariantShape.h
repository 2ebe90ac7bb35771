/**
 * @file smVariantShape.h
 * @brief A solid whose control points move along given directions: x = x_0 + sum c_k d_k
 *
 * The base model has the control points P_0 with weights w, trim curves in the parameters of the faces, and
 * the curves C_0 of edges. Direction k displaces control points by D_k and edges by E_k. The variant of the
 * numbers c_1 ... c_K has P_0 + sum c_k D_k and C_0 + sum c_k E_k; weights, knots and trim curves are those
 * of the base. Therefore every point, and the whole closed chain (faces, ribbons, caps), is affine in c.
 *
 * A direction is a model that was moved: by sm::MoveControlPoints(), vtkNURBSDeform, or by hand. It needs the
 * faces of the base in their order with the same degrees, knots, weights, loops and trim curves. Edges may
 * have other pieces; they are divided to common ones. Where a face moves away from its edge, ribbons close
 * the chain, and GetGaps() says how far. A face without loops has no edges and no ribbons: it may move only
 * where it closes on itself or ends in a pole, and its control points that coincide have to move alike,
 * within 1e-12 of the largest displacement, which no bound includes.
 */
#ifndef smVariantShape_h
#define smVariantShape_h

#include "smFiltersVariantsModule.h"

#include "smFace.h"

#include "vtkSmartPointer.h" // for the models
#include "vtkTrimmedNURBSModel.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace sm
{
/// A model after a move, and the number that the move belongs to: the direction is the difference from the
/// base divided by it. For example a handle that was moved by 2 mm with Amount 2 gives a direction for c in
/// mm.
struct MovedModel
{
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  double Amount = 1.0;
};

/**
 * Moves a face along its outward normal by 1, as far as its control points can: their displacements
 * interpolate the unit normal at as many points, so that planes, cylinders, cones, spheres and tori move
 * exactly. Edges stay, and ribbons lead to them. Returns null with the reason for a face that does not exist,
 * has more than 400 control points, or no normal at a point.
 */
SMFILTERSVARIANTS_EXPORT vtkSmartPointer<vtkTrimmedNURBSModel> MakeNormalOffset(
  vtkTrimmedNURBSModel* base, int face, std::string& error);

/// An edge of the base in pieces that suit all directions, and its displacements.
struct VariantEdge
{
  std::shared_ptr<const Edge> Source;
  EdgeCurve Curve;
  /// By the index of the direction, for those that move the edge: one vector for each coefficient of Curve.
  std::map<int, std::vector<std::array<double, 3>>> Displacements;
  /// Displacements of start and end vertex.
  std::map<int, std::array<std::array<double, 3>, 2>> Vertices;
};

/// A face of the base, and the displacements of its control points, w dx, w dy, w dz.
struct VariantFace
{
  FacePointer Source;
  std::map<int, std::vector<std::array<double, 3>>> Displacements;
};

/// Immutable after Make(). Thread safe.
class SMFILTERSVARIANTS_EXPORT VariantShape
{
public:
  /// Returns the shape, or null with the reason: a model without faces, one that is open or whose status is
  /// not ok (CheckTopology()), several shells that are not a solid and its voids; an Amount that is 0 or not
  /// finite, a moved model that differs from the base in more than control points and edges, or opens a face
  /// without loops. More than 10,000 directions are refused.
  static std::shared_ptr<const VariantShape> Make(
    vtkTrimmedNURBSModel* base, const std::vector<MovedModel>& directions, std::string& error);

  int GetNumberOfDirections() const { return this->NumberOfDirections; }
  vtkTrimmedNURBSModel* GetBase() const { return this->Base; }
  const std::vector<VariantFace>& GetFaces() const { return this->Faces; }
  /// The edge of the shape for one of the base; null for a foreign one.
  const VariantEdge* FindEdge(const Edge* edge) const;

  /**
   * Makes the model of a variant, `c` has GetNumberOfDirections() values: what any filter computes for it is
   * what the variant has. Its control points are rounded to doubles, which the faces' Rounding states.
   */
  vtkSmartPointer<vtkTrimmedNURBSModel> MakeModel(const double* c) const;

private:
  VariantShape() = default;
  std::string AddDirection(const MovedModel& moved);
  std::string AddFace(std::size_t index, const Face& moved, double factor, int direction);
  void DivideEdges();

  vtkSmartPointer<vtkTrimmedNURBSModel> Base;
  int NumberOfDirections = 0;
  std::vector<VariantFace> Faces;
  std::map<const Edge*, VariantEdge> Edges;
  /// While the shape is made: the edges as the directions have them, with the factor of the difference.
  std::map<const Edge*, std::map<int, std::pair<std::shared_ptr<const Edge>, double>>> MovedEdges;
};
}

#endif
