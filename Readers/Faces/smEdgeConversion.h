/**
 * @file smEdgeConversion.h
 * @brief An edge of a file as an edge of a trimmed NURBS model
 */
#ifndef smEdgeConversion_h
#define smEdgeConversion_h

#include "smBodyConversion.h"

#include <memory>

namespace sm
{
/// The map from the coordinates of a body's shape to those of its model: `Scale`, then the factor `Unit`,
/// then minus `Origin`.
struct BodyPlace
{
  Placement Scale;
  double Unit;
  /// In model units.
  double Origin[3];

  /// Returns the map for geometry that has this location in the shape.
  AffineMap MakeMap(const Placement& location) const;
  /// Returns the largest magnitude of a coordinate of Origin.
  double GetMaxOrigin() const;
};

/**
 * Converts an edge. `face` and `coedge` are its first use. An edge without a curve in space gets the image of
 * the coedge's trim curve. Missing vertices are the ends of the curve. Throws std::runtime_error if the edge
 * has no curve at all, or one that cannot be converted.
 */
std::shared_ptr<const Edge> ConvertEdgeShape(
  const EdgeShape& edge, const BodyPlace& place, const DraftFace& face, const DraftCoedge& coedge);
}

#endif
