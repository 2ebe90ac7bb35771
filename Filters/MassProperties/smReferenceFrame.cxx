#include "Detail/smReferenceFrame.h"

#include "smUnitRoundoff.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
constexpr double MinAngle = 1e-6;

/// Scales a direction to length 1, first by its largest component so that no square overflows. Returns false
/// if it has no direction.
bool Normalize(std::array<double, 3>& direction)
{
  double largest = 0.0;
  for (const double x : direction)
  {
    largest = std::isfinite(x) ? std::max(largest, std::abs(x)) : std::numeric_limits<double>::infinity();
  }
  if (!(largest > 0.0) || !std::isfinite(largest))
  {
    return false;
  }
  for (double& x : direction)
  {
    x /= largest;
  }
  vtkMath::Normalize(direction.data());
  return true;
}

/// Rows are the axes. Returns the sine of the angle between the two directions, 0 if there is no frame.
double MakeAxes(const ReferenceFrame& frame, std::array<double, 3> (&rows)[3])
{
  rows[2] = frame.ZAxis;
  rows[0] = frame.XAxis;
  if (!Normalize(rows[2]) || !Normalize(rows[0]))
  {
    return 0.0;
  }
  const double along = vtkMath::Dot(rows[0].data(), rows[2].data());
  for (int i = 0; i < 3; ++i)
  {
    rows[0][i] -= along * rows[2][i];
  }
  const double sine = vtkMath::Norm(rows[0].data());
  if (!Normalize(rows[0]))
  {
    return 0.0;
  }
  vtkMath::Cross(rows[2].data(), rows[0].data(), rows[1].data());
  return sine;
}
}

bool ReferenceFrame::IsValid() const
{
  std::array<double, 3> rows[3];
  return MakeAxes(*this, rows) >= MinAngle &&
    std::all_of(this->Origin.begin(), this->Origin.end(), [](double x) { return std::isfinite(x); });
}

FrameProperties::FrameProperties()
  : CenterBound(vtkMath::Nan())
  , InertiaBound(vtkMath::Nan())
  , CentralInertiaBound(vtkMath::Nan())
{
  this->Center.fill(vtkMath::Nan());
  this->Inertia.fill(vtkMath::Nan());
  this->CentralInertia.fill(vtkMath::Nan());
}

FrameProperties ComputeInFrame(Moments moments, const ReferenceFrame& frame)
{
  FrameProperties result;
  std::array<double, 3> rows[3];
  const double sine = MakeAxes(frame, rows);
  if (!std::isfinite(moments.Volume) || !(sine >= MinAngle))
  {
    return result;
  }
  moments.MoveReference(frame.Origin);
  double placement[16] = {};
  for (int i = 0; i < 3; ++i)
  {
    std::copy_n(rows[i].begin(), 3, placement + 4 * i);
  }
  double first = 0.0;
  double second = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    first += std::abs(moments.First[i]) + moments.FirstBound[i];
  }
  for (int i = 0; i < 6; ++i)
  {
    second += (i < 3 ? 1.0 : 2.0) * (std::abs(moments.Second[i]) + moments.SecondBound[i]);
  }
  moments.Reference = { 0.0, 0.0, 0.0 };
  moments.Place(placement);
  // No entry of the axes is off by more than e: about ten roundings, of which those of the perpendicular part
  // grow by its division by the sine. So an entry of R C R^T is off by no more than (2 e + e^2) sum |C_kl|,
  // and one of R m by e sum |m_k|.
  const double e = 32.0 * UnitRoundoff / sine;
  for (double& bound : moments.FirstBound)
  {
    bound += e * first;
  }
  for (double& bound : moments.SecondBound)
  {
    bound += (2.0 * e + e * e) * second;
  }
  // The moments are about the origin of the frame, so that these are the properties "at origin".
  const MassProperties properties = ComputeMassProperties(moments);
  result.Center = properties.Center;
  result.CenterBound = properties.CenterBound;
  result.Inertia = properties.InertiaAtOrigin;
  result.InertiaBound = properties.InertiaAtOriginBound;
  result.CentralInertia = properties.Inertia;
  result.CentralInertiaBound = properties.InertiaBound;
  return result;
}
}
