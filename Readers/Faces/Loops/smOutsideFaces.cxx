#include "smOutsideFaces.h"

#include "Shapes/smShapeBounds.h"
#include "smCatchFailure.h"
#include "smFaceInspection.h"
#include "smNaturalBoundary.h"

#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Loops with larger gaps, and narrower ones, relative to the size of the body, have no certain direction.
constexpr double Tolerance = 1e-5;

bool IsOutside(const FaceUse& use, double size)
{
  bool isOutside = false;
  CatchFailure(
    [&]
    {
      EdgeIndex edges;
      DraftFace face = CollectFace(*use.Face, false, edges, MissingTrim::Feet);
      isOutside = IsOnClosedSurface(face) && !HasSeam(face) &&
        (InspectFace(face, Vector3{}, Tolerance * size, std::numeric_limits<double>::infinity()).Outside ||
          face.IsOutside());
    });
  return isOutside;
}
}

std::vector<const FaceShape*> FindOutsideFaces(const BodyShape& body)
{
  std::vector<const FaceShape*> faces;
  double bounds[6];
  const bool hasBox = GetShapeBounds(body, bounds);
  const double size =
    hasBox ? std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]) : 0.0;
  body.VisitFaces(
    [&](const FaceUse& use)
    {
      if (IsOutside(use, size))
      {
        faces.push_back(use.Face.get());
      }
    });
  return faces;
}
}
