/**
 * @file smOCCTEdge.h
 * @brief An edge of an OpenCASCADE shape as an edge of a trimmed NURBS model
 */
#ifndef smOCCTEdge_h
#define smOCCTEdge_h

#include "smOCCTBody.h"

#include <TopoDS_Edge.hxx>

#include <memory>

namespace sm
{
/// The map from the coordinates of a body's shape to those of its model: `Trsf`, then the factor `Unit`, then
/// minus `Origin`.
struct BodyPlace
{
  gp_Trsf Trsf;
  double Unit;
  /// In model units.
  double Origin[3];

  /// Returns the map for geometry that has this location in the shape.
  AffineMap MakeMap(const gp_Trsf& location) const;
  /// Returns the largest magnitude of a coordinate of Origin.
  double GetLargestOrigin() const;
};

/**
 * Converts an edge with forward orientation. `face` and `coedge` are its first use. An edge without a curve
 * in space gets the image of the coedge's trim curve. Missing vertices are the ends of the curve. Throws
 * std::runtime_error if the edge has no curve at all, and what OpenCASCADE throws.
 */
std::shared_ptr<const Edge> ConvertEdgeShape(const TopoDS_Edge& edge, const ShapeInfo& info,
  const BodyPlace& place, const DraftFace& face, const DraftCoedge& coedge);
}

#endif
