/**
 * @file smClosingSpread.h
 * @brief How far the integrals of a closed body move if its gaps are closed in another way
 *
 * A closing joins the faces that use an edge by ribbons to a common curve. The set of closings, the theorem
 * that bounds what they change, and its proof are in Filters/Quadrature/Bounds.md, "Closing spread". In
 * short, in every plane normal to the edge's curve C, where it meets the boundary A of each face in one
 * point:
 *
 * - the common curve passes any point of the triangle of C and both boundaries; with three and more uses, of
 *   the convex hull of C and the boundaries;
 * - the boundary of each face passes any point of the face's surface whose distance from the point next to C
 *   is at most r, the larger of |A - C| and the stated tolerance.
 *
 * The ends of all curves stay, and vertices move by at most the width of the gap at their corners. Depends on
 * the model alone, not on integrals or placements.
 */
#ifndef smClosingSpread_h
#define smClosingSpread_h

#include "smFiltersSurfaceIntegralsModule.h"

#include "smFace.h"
#include "smVector.h"

#include <cstddef>
#include <memory>
#include <vector>

class vtkTrimmedNURBSModel;

namespace sm
{
/// The volume that closings can add and remove near one point of an edge.
struct SpreadSample
{
  Vector3 Position;
  /// Signed volumes are between -Removed and Added; what is swept without its sign is at most Swept.
  double Added = 0.0;
  double Removed = 0.0;
  double Swept = 0.0;
  /// No point that is swept is farther from Position.
  double Reach = 0.0;
};

/// The closings of one edge, or of the corners at one vertex.
struct EdgeSpread
{
  /// False if the signed uses of the edge do not cancel: then nothing bounds where a closing passes.
  bool IsKnown = true;
  std::vector<SpreadSample> Samples;
  /// Largest change of the faces' area.
  double Area = 0.0;

  /// Largest change of the volume; NaN if it is not known.
  double GetVolume() const;
};

struct ClosingSpreadEntry
{
  /// Null for a vertex.
  const Edge* Source = nullptr;
  /// Indices of the faces that use it.
  std::vector<std::size_t> Faces;
  std::shared_ptr<const EdgeSpread> Spread;
};

/// The edges and vertices of a model; poles are omitted. Outward normals are those of the model's faces.
using ClosingSpread = std::vector<ClosingSpreadEntry>;

/// Measures the closings of models. Edges whose faces are those of an earlier call are not measured again.
class SMFILTERSSURFACEINTEGRALS_EXPORT ClosingSpreads
{
public:
  ClosingSpreads();
  ~ClosingSpreads();
  ClosingSpreads(const ClosingSpreads&) = delete;
  ClosingSpreads& operator=(const ClosingSpreads&) = delete;

  /// Runs on the threads of vtkSMPTools, with the same result for any number of them.
  std::shared_ptr<const ClosingSpread> Measure(vtkTrimmedNURBSModel& model);
  /// Ends a run: entries that no model of the last runs has are removed.
  void EndRun();
  void Clear();

private:
  class Internals;
  std::unique_ptr<Internals> Implementation;
};

/// The largest changes of the moments of a body about a point, and of its area, over all closings; all NaN if
/// those of some edge are not known. Second moments are XX YY ZZ XY YZ XZ.
struct SpreadSums
{
  double Volume = 0.0;
  double Area = 0.0;
  double First[3] = { 0.0, 0.0, 0.0 };
  double Second[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
};

/// Adds up the closings of a body about `center`, in coordinates of the model. `sides` has the factor 1 or -1
/// of each face's fluxes; empty: all are 1.
SMFILTERSSURFACEINTEGRALS_EXPORT SpreadSums SumSpread(
  const ClosingSpread& spread, const std::vector<signed char>& sides, const Vector3& center);
}

#endif
