#include "Detail/smPlausibility.h"

#include "smFormat.h"

#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
// A bound of the volume above this fraction of the box results from an incomplete run and permits no
// conclusion about the solid.
constexpr double ResolvedVolume = 1e-9;
}

namespace
{
using Box = std::array<double, 6>;
constexpr double MaxNumber = std::numeric_limits<double>::max();
constexpr Box NoBox = { MaxNumber, -MaxNumber, MaxNumber, -MaxNumber, MaxNumber, -MaxNumber };

void AddPoint(const double* p, double weight, Box& box)
{
  for (int d = 0; d < 3; ++d)
  {
    const double x = p[d] / weight;
    box[2 * d] = std::min(box[2 * d], x);
    box[2 * d + 1] = std::max(box[2 * d + 1], x);
  }
}

bool Contains(const Box& box, const std::array<double, 3>& p)
{
  return p[0] > box[0] && p[0] < box[1] && p[1] > box[2] && p[1] < box[3] && p[2] > box[4] && p[2] < box[5];
}

/// Calls `use` with every edge, once for each of its uses.
template <typename Use>
void VisitEdges(const vtkTrimmedNURBSModel& model, const Use& use)
{
  for (const FacePointer& face : model.GetFaces())
  {
    for (const Loop& loop : face->Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        use(*coedge.Use);
      }
    }
  }
}
}

Box GetHullBox(const vtkTrimmedNURBSModel& model, const std::array<double, 3>* inside)
{
  Box box = NoBox;
  VisitEdges(model,
    [&box](const Edge& edge)
    {
      AddPoint(edge.StartVertex.data(), 1.0, box);
      AddPoint(edge.EndVertex.data(), 1.0, box);
    });
  if (inside && Contains(box, *inside))
  {
    return box;
  }
  for (const FacePointer& face : model.GetFaces())
  {
    for (const std::array<double, 4>& p : face->Surface.ControlPoints)
    {
      AddPoint(p.data(), p[3], box);
    }
  }
  VisitEdges(model,
    [&box](const Edge& edge)
    {
      for (const EdgeCurve::Point& p : edge.Curve.Coefficients)
      {
        AddPoint(p.data(), 1.0, box);
      }
    });
  return box;
}

std::vector<std::string> FindImplausibilities(const MassProperties& properties,
  const std::array<double, 3>& center, const std::array<double, 6>& box, double slack)
{
  std::vector<std::string> violations;
  const double diagonal = std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
  if (properties.Volume < -properties.VolumeBound)
  {
    violations.push_back("the volume is negative");
  }
  else if (properties.Volume <= properties.VolumeBound &&
    properties.VolumeBound <= ResolvedVolume * diagonal * diagonal * diagonal)
  {
    violations.push_back("the volume is zero within its bound");
  }
  double outside = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    outside = std::max({ outside, box[2 * d] - center[d], center[d] - box[2 * d + 1] });
  }
  // The bound holds for a component in the world; the factor accounts for its rotation into the part's frame.
  if (outside > slack + std::sqrt(3.0) * properties.CenterBound)
  {
    violations.push_back(
      "the centre of mass lies outside the box of the solid, by " + FormatDigits(outside, 3));
  }
  const std::array<double, 3>& moments = properties.Principal;
  if (moments[0] < -properties.PrincipalBound)
  {
    violations.push_back("the inertia is not positive definite: its smallest principal moment is " +
      FormatDigits(moments[0], 3));
  }
  const double excess = moments[2] - moments[1] - moments[0];
  if (excess > 3.0 * properties.PrincipalBound)
  {
    violations.push_back(
      "the principal moments are impossible: the largest exceeds the sum of the others by " +
      FormatDigits(excess, 3));
  }
  return violations;
}
}
