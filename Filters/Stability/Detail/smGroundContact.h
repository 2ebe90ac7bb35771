/**
 * @file smGroundContact.h
 * @brief Contacts of trimmed faces with the ground: enclosure of their minimum height, and contacts within a
 * tolerance of the ground
 *
 * **Minimum height.** Branch and bound over control nets. On a trimmed face the minimum height is reached on
 * a trim curve, on a crease (an interior knot line where the surface is only continuous), or at a stationary
 * point inside the loops. Trim curves are composed with their patch, exactly, so a trim is nowhere
 * approximated by a box. A net is discarded when it lies above the minimum height known so far, when its
 * height has a slope of one sign (then it is lower elsewhere), or when it lies outside the loops. The heights
 * at ends of trim curves and at points inside the loops bound the minimum height from above; the remaining
 * nets bound it from below.
 *
 * **Contacts** with a height limit, the ground plus the tolerance:
 *   - corners of loops not above the limit, and kinks of trim curves that are lowest locally;
 *   - pieces of trim curves (one Bézier piece on one patch) that lie below the limit as a whole; of others
 * the stationary points below it;
 *   - patches that lie below the limit as a whole, with all their parts inside the loops; of others the
 * stationary points below the limit inside the loops. So a flat face is a contact when all of it is within
 * the tolerance. A dome touches in one point for any tolerance, not in the disc of all points that are low
 * enough.
 *
 * Every contact is stored as a piece with points that certainly are contacts (Inner) and points whose convex
 * hull encloses the contact (Outer).
 */
#ifndef smGroundContact_h
#define smGroundContact_h

#include "smFacePanelsCache.h"
#include "smFiltersStabilityModule.h"
#include "smGroundNet.h"
#include "smSupportPolygon.h"
#include "smTrimClassifier.h"

#include <cstdint>
#include <memory>
#include <set>
#include <vector>

namespace sm
{
struct ContactPiece
{
  std::vector<Point2> Inner;
  std::vector<Point2> Outer;
  /// The curve of the contact, which can be halved until Inner and Outer are close together; without points
  /// when there is none.
  GroundCurve Curve;
};

/// Curvature of the body at a contact, for rolling.
struct ContactSample
{
  Point2 Position;
  /// Smallest radius of curvature of a surface that is tangent to the ground here; infinite where it is flat;
  /// 0 for corners and edges.
  double Radius;
  /// Estimate of the error of the radius, not a bound.
  double RadiusError;
  /// Largest radius of curvature at the point; infinite where the surface is flat in some direction.
  double Widest;
  /// Bit k is set if the surface continues in direction k (see GetContactDirection). Where it ends, the body
  /// tips over the border.
  std::uint32_t GoesOn = ~0u;
};

constexpr int ContactDirections = 32;
/// Returns unit vector k in the ground's plane, counter-clockwise from the axis a.
SMFILTERSSTABILITY_EXPORT Point2 GetContactDirection(int k);

struct GroundContacts
{
  std::vector<ContactPiece> Pieces;
  std::vector<ContactSample> Samples;
  /// Entity numbers of the faces that touch with a whole patch, and of the edges that touch with a whole
  /// piece.
  std::set<std::int64_t> FaceIds;
  std::set<std::int64_t> EdgeIds;
  /// Accuracy of stationary points, a length: rounding leaves the sign of slopes open in a region of this
  /// size. Inner points may be so far from true contacts, and true contacts so far outside the hull of all
  /// Outer points.
  double Spread = 0.0;
  /// True if the search was stopped at a limit of work somewhere: contacts there are enclosed by their
  /// control nets only.
  bool Coarse = false;
};

class SMFILTERSSTABILITY_EXPORT ContactSearch
{
public:
  ContactSearch();
  ~ContactSearch();
  ContactSearch(const ContactSearch&) = delete;
  ContactSearch& operator=(const ContactSearch&) = delete;

  /// The face must outlive the search; one that could not be cut is left out.
  void AddFace(const CutFacePointer& face, const GroundFrame& frame);

  /// Largest coordinate, in the ground's frame, of all control points; 0 without faces.
  double GetSize() const;
  /// Bound of the rounding error of a coordinate.
  double GetRounding() const;
  /// Returns the distance below which two corners count as one.
  double GetResolution() const;

  /// Encloses the minimum height of all faces. NaN without faces.
  HeightRange FindLowest();

  GroundContacts FindContacts(double limit);

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};
}

#endif
