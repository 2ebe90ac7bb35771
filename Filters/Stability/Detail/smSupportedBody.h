/**
 * @file smSupportedBody.h
 * @brief Evaluates bodies on the ground: frames, contacts and stability, and draws the results
 */
#ifndef smSupportedBody_h
#define smSupportedBody_h

#include "smBodyIntegrals.h"
#include "smFacePanelsCache.h"
#include "smGroundNet.h"
#include "smStability.h"
#include "smVector.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace sm
{
/// Unit vectors against gravity and normal to the ground; Normal.Up > 0.
struct GroundDirections
{
  Vector3 Up;
  Vector3 Normal;
  /// Two unit vectors in the ground, A x B = Normal.
  Vector3 A;
  Vector3 B;

  /// Returns false if the ground is vertical (cosine below 1e-6). A `normal` of length 0 stands for the
  /// upward direction. Both vectors may have any length.
  static bool Make(const double gravity[3], const double normal[3], GroundDirections& directions);
};

/// One or several solids that rest on the ground as one rigid body, and the results for it.
struct SupportedBody
{
  std::string Name;
  std::string Id;
  std::string Status;
  std::vector<const BodyIntegrals*> Parts;
  /// Centre of mass in world coordinates; there is none if its bound is not finite.
  Vector3 Center{};
  double CenterBound = 0.0;
  /// Mass in kg, and metres per length unit; NaN: not known.
  double Mass;
  double Metres;

  /// Diagonal of the box of all parts, and its middle, the origin of the ground's frame.
  double Size = 0.0;
  Vector3 Origin{};
  HeightRange Clearance{ 0.0, 0.0 };
  int ContactFaces = 0;
  int ContactEdges = 0;
  /// True if the search of contacts was stopped at a limit of work, see GroundContacts::Coarse; bounds hold,
  /// but are wider.
  bool Coarse = false;
  StabilityResult Result;
  /// Height of the ground in the frame.
  double GroundHeight = 0.0;

  SupportedBody();
  /// Returns the world coordinates of a point in the ground's frame.
  Vector3 ToWorld(const GroundDirections& ground, const Point2& ab, double h) const;
};

/// Returns the frame of the ground for the stored coordinates of a part; `origin` is the world position of
/// the frame's origin.
GroundFrame MakeGroundFrame(const GroundDirections& ground, const Vector3& origin, const BodyIntegrals& part);

/// Computes all members after Metres. `groundOrigin`: a point of the ground; null: the ground is under the
/// lowest point. `tolerance`: distance up to which points are contacts, relative to Size.
void EvaluateStability(SupportedBody& body, const GroundDirections& ground, const double* groundOrigin,
  double tolerance, FacePanelsCache& cache);

/// Draws the support polygon, the centre of mass, its projection onto the ground and the line between them,
/// in the colour of the verdict (cell data StabilityColor).
void DrawSupportedBodies(
  const std::vector<SupportedBody>& bodies, const GroundDirections& ground, vtkPolyData* drawing);
}

#endif
