#include "smBodyBox.h"

#include "smBodyIntegrals.h"
#include "smBodyScales.h"
#include "smGroundContact.h"
#include "smSupportedBody.h"

#include "vtkBoundingBox.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Returns the enclosure of the largest coordinate of a body along an axis of the world, or against it.
HeightRange FindSide(const BodyIntegrals& body, const std::vector<CutFacePointer>& faces,
  const Vector3& origin, int axis, double sign)
{
  // Heights grow against the direction of the side: the minimum height is the side.
  GroundDirections ground;
  ground.Normal = ground.A = ground.B = { 0.0, 0.0, 0.0 };
  ground.Normal[axis] = -sign;
  ground.A[(axis + 1) % 3] = 1.0;
  ground.B[(axis + 2) % 3] = -sign;
  ground.Up = ground.Normal;
  const GroundFrame frame = MakeGroundFrame(ground, origin, body);
  ContactSearch search;
  for (const CutFacePointer& face : faces)
  {
    search.AddFace(face, frame);
  }
  const HeightRange minimum = search.FindLowest();
  return { -minimum.High, -minimum.Low };
}

BodyBox ComputeBodyBox(const BodyIntegrals& body, FacePanelsCache& cache)
{
  BodyBox result;
  result.Bounds.fill(vtkMath::Nan());
  result.Bound = vtkMath::Nan();
  vtkBoundingBox box;
  AddPlacedBox(body, box);
  std::vector<CutFacePointer> faces;
  cache.Acquire(body.Model->GetFaces(), faces, {});
  if (!box.IsValid() || faces.empty() ||
    std::any_of(
      faces.begin(), faces.end(), [](const CutFacePointer& face) { return !face || !face->Error.empty(); }))
  {
    return result;
  }
  Vector3 origin;
  box.GetCenter(origin.data());
  double bound = 0.0;
  for (int side = 0; side < 6; ++side)
  {
    const double sign = side % 2 == 0 ? -1.0 : 1.0;
    const HeightRange range = FindSide(body, faces, origin, side / 2, sign);
    const double middle = 0.5 * (range.Low + range.High);
    result.Bounds[side] = origin[side / 2] + sign * middle;
    bound = std::max(
      bound, 0.5 * (range.High - range.Low) + 4e-16 * (std::abs(result.Bounds[side]) + std::abs(middle)));
  }
  double residual = 0.0;
  for (const FacePointer& face : body.Model->GetFaces())
  {
    residual = std::max(residual, face->Surface.Residual);
  }
  result.Bound = bound + residual;
  return result;
}
}

std::vector<BodyBox> ComputeBodyBoxes(vtkDataObject* input)
{
  RejectedInput rejected;
  FacePanelsCache cache;
  std::vector<BodyBox> boxes;
  for (const BodyIntegrals& body : CollectBodies(input, rejected))
  {
    boxes.push_back(ComputeBodyBox(body, cache));
  }
  return boxes;
}
}
