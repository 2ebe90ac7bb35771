/**
 * @file smSTEPShapeChecks.h
 * @brief Contradictions between a face or an edge of a STEP file and its own surface or curve
 *
 * Texts are sentences for the user, and empty where there is nothing to report. Lengths are in mm.
 */
#ifndef smSTEPShapeChecks_h
#define smSTEPShapeChecks_h

#include "smSTEPEdges.h"
#include "smSTEPGeometry.h"

#include <cstdint>
#include <string>

namespace sm
{
/// Reports a whole torus whose minor radius exceeds the major one. `face` and `surface` are numbers.
std::string DescribeWholeTorus(
  std::uint64_t face, std::uint64_t surfaceId, const STEPSurface& surface, bool isBounded);

/// Reports the only vertex of a face on a cone that is not the apex.
std::string DescribeApex(std::uint64_t face, std::uint64_t vertex, std::uint64_t surfaceId,
  const ElementarySurface& cone, const Vector3& point);

/// Returns true if the only vertex of a face on a sphere or torus is off it.
bool IsOffSurface(const ElementarySurface& surface, const Vector3& point);

/// Reports an arc whose parameters have too few digits for its length.
std::string DescribeShortArc(const STEPEdge& edge);

///@{
/// An edge on a closed curve between two points that are closer than STEPEdges::SameVertex, and not the same:
/// the curve is taken as a whole.
bool IsNearlyClosed(const STEPEdge& edge);
std::string DescribeNearlyClosed(const STEPEdge& edge);
///@}
}

#endif
