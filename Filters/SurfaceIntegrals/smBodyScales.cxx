#include "smBodyScales.h"

#include "smBodyIntegrals.h"

#include "vtkBoundingBox.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Rounds a scale down to a power of two, so that small differences of the display mesh do not change the
/// tolerances of faces.
double RoundDown(double scale)
{
  return scale > 0.0 ? std::exp2(std::floor(std::log2(scale))) : 0.0;
}
}

bool HaveOneUnit(const std::vector<BodyIntegrals>& bodies)
{
  return std::all_of(bodies.begin(), bodies.end(),
    [&bodies](const BodyIntegrals& body)
    { return body.Model->GetLengthUnit() == bodies.front().Model->GetLengthUnit(); });
}

std::array<double, 6> GetBox(vtkTrimmedNURBSModel& model)
{
  std::array<double, 6> box;
  std::copy_n(model.GetLocalBounds(), 6, box.begin());
  if (box[0] < box[1] || box[2] < box[3] || box[4] < box[5] || model.GetFaces().empty())
  {
    return box;
  }
  for (int d = 0; d < 3; ++d)
  {
    box[2 * d] = std::numeric_limits<double>::max();
    box[2 * d + 1] = -box[2 * d];
  }
  for (const FacePointer& face : model.GetFaces())
  {
    for (const std::array<double, 4>& p : face->Surface.ControlPoints)
    {
      for (int d = 0; d < 3; ++d)
      {
        box[2 * d] = std::min(box[2 * d], p[d] / p[3]);
        box[2 * d + 1] = std::max(box[2 * d + 1], p[d] / p[3]);
      }
    }
  }
  return box;
}

void AddPlacedBox(const BodyIntegrals& body, vtkBoundingBox& box)
{
  const std::array<double, 6> b = GetBox(*body.Model);
  const double* origin = body.Model->GetOrigin();
  const std::array<double, 16>& m = body.Placement;
  for (int corner = 0; corner < 8; ++corner)
  {
    double p[3];
    for (int r = 0; r < 3; ++r)
    {
      p[r] = m[4 * r + 3];
      for (int c = 0; c < 3; ++c)
      {
        p[r] += m[4 * r + c] * (origin[c] + b[2 * c + ((corner >> c) & 1)]);
      }
    }
    box.AddPoint(p);
  }
}

double GetRadius(vtkTrimmedNURBSModel& model)
{
  const std::array<double, 6> b = GetBox(model);
  return 0.5 * std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
}

double GetReach(const BodyIntegrals& body)
{
  const double* origin = body.Model->GetOrigin();
  double squared = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    double x = body.Placement[4 * i + 3];
    for (int j = 0; j < 3; ++j)
    {
      x += body.Placement[4 * i + j] * origin[j];
    }
    squared += x * x;
  }
  return std::sqrt(squared) + GetRadius(*body.Model);
}

double GetVolumeScale(vtkTrimmedNURBSModel& model)
{
  const double radius = GetRadius(model);
  const double box = radius * radius * radius;
  const double known = model.GetVolumeScale();
  // A known scale that is not possible for the box, nor for the surface of a wire or a sheet in it, comes
  // from a faulty mesh.
  const double minimum = std::min(1e-9 * box, 1e-12 * radius * GetAreaScale(model));
  return RoundDown(known > minimum && known < 8.0 * box ? known : box);
}

double GetAreaScale(vtkTrimmedNURBSModel& model)
{
  const double radius = GetRadius(model);
  const double known = model.GetAreaScale();
  return RoundDown(known > 1e-9 * radius * radius ? known : radius * radius);
}
}
