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
/// Unit vectors; Normal.Up > 0.
struct GroundDirections
{
  Vector3 Up;
  Vector3 Normal;
  /// Two unit vectors in the ground, A x B = Normal.
  Vector3 A;
  Vector3 B;

  /// False when the ground stands upright (cosine below 1e-6). `normal` of length 0: up; neither needs to have length 1.
  static bool Make(const double gravity[3], const double normal[3], GroundDirections& directions);
};

/// One or several solids that rest on the ground as one rigid body, and the results for it.
struct SupportedBody
{
  std::string Name;
  std::string Id;
  std::string Status;
  std::vector<const BodyIntegrals*> Parts;
  /// World coordinates; a bound that is not finite: there is no centre.
  Vector3 Center{};
  double CenterBound = 0.0;
  /// kg and metres per length unit; NaN: not known.
  double Mass;
  double Metres;

  /// Diagonal of the box of all parts, and its middle, the origin of the ground's frame.
  double Size = 0.0;
  Vector3 Origin{};
  HeightRange Clearance{ 0.0, 0.0 };
  int ContactFaces = 0;
  int ContactEdges = 0;
  bool Coarse = false;
  StabilityResult Result;
  /// Height of the ground in the frame.
  double GroundHeight = 0.0;

  SupportedBody();
  /// From the ground's frame to the world.
  Vector3 ToWorld(const GroundDirections& ground, const Point2D& ab, double h) const;
};

/// Returns the frame of the ground for the stored coordinates of a part; `origin` is a point of the world that the frame begins at.
GroundFrame MakeGroundFrame(const GroundDirections& ground, const Vector3& origin, const BodyIntegrals& part);

/// `groundOrigin` null: resting. `tolerance` relative to the size. Fills everything after Metres.
void EvaluateStability(SupportedBody& body, const GroundDirections& ground, const double* groundOrigin,
  double tolerance, FacePanelsCache& cache);

/// Support polygon, centre of mass, its projection onto the ground and the line between them, in the verdict's colour (cell data
/// StabilityColor).
void DrawSupportedBodies(
  const std::vector<SupportedBody>& bodies, const GroundDirections& ground, vtkPolyData* drawing);
}

#endif
