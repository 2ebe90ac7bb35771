/**
 * @file smFlaggedPlaces.h
 * @brief The faces and edges that make results suspect or open: where they are, and what they may cost
 */
#ifndef smFlaggedPlaces_h
#define smFlaggedPlaces_h

#include "smBodyIntegrals.h"
#include "smFiltersSurfaceIntegralsModule.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

class vtkPolyData;

namespace sm
{
/// Flagged faces, an edge with a wide gap, or the open edges around one opening of a body.
struct FlaggedPlace
{
  /// Index of the body.
  std::size_t Body = 0;
  /// Either edges, or indices of faces in the model.
  std::vector<const EdgeGap*> Edges;
  std::vector<std::size_t> Faces;
  /// The defect in words, without the figures in doubt.
  std::string Reason;
  /**
   * Estimates, not bounds, of the errors that the place may cause in the area and volume of its body; NaN
   * where they are not known.
   * - A gap: its area, and what other ways of closing it may change (the edge's spread), or the integral of
   * its square where that is not known. A face in a wrong place may cost more.
   * - An opening of a solid: the length of the vector area of its edges, which is the smallest area of a
   * surface that closes it, and that times a third of the largest distance of the body's box from the origin
   * of the model: the flux about that origin through a plane cover, which the volume lacks, is no larger.
   * - Faces that count wrongly: the area of their display mesh, and its flux about that origin.
   */
  double AreaInDoubt = std::numeric_limits<double>::quiet_NaN();
  double VolumeInDoubt = std::numeric_limits<double>::quiet_NaN();
};

/// Returns the places of all bodies whose status is suspect or worse, by the volume in doubt, the largest
/// first. Gaps are flagged above BodyIntegrals::ExcusedGap. The places refer to the bodies.
SMFILTERSSURFACEINTEGRALS_EXPORT std::vector<FlaggedPlace> FindFlaggedPlaces(
  const std::vector<BodyIntegrals>& bodies);

/// Returns the first `maximum` places with their numbers, in lines of at most 64 characters.
SMFILTERSSURFACEINTEGRALS_EXPORT std::string ListFlaggedPlaces(
  const std::vector<FlaggedPlace>& places, const std::vector<BodyIntegrals>& bodies, std::size_t maximum);

/// Fills `output` with a polyline for every edge and with the triangles of all flagged faces, in world
/// coordinates, with the cell data of port 6 of vtkSurfaceIntegralBase. Curves are drawn by chords.
SMFILTERSSURFACEINTEGRALS_EXPORT void DrawFlaggedPlaces(
  const std::vector<FlaggedPlace>& places, const std::vector<BodyIntegrals>& bodies, vtkPolyData* output);
}

#endif
