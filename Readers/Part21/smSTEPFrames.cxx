#include "smSTEPFrames.h"

#include "smSTEPPropertyAttributes.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Sine of an angle below which OpenCASCADE takes directions for parallel.
constexpr double ParallelSine = 1e-12;
/// The same for the default of a direction, for which a file's rounding errors must not decide.
constexpr double DefaultSine = 1e-9;
bool ReadThreeNumbers(std::string_view list, Vector3& numbers)
{
  Part21Values values(list);
  Part21Value value;
  for (double& number : numbers)
  {
    if (!values.Next(value) || !value.GetNumber(number))
    {
      return false;
    }
  }
  return !values.Next(value) && !values.IsMalformed();
}

/// Subtracts the part along the unit vector `axis` and makes the rest a unit vector, which the second time
/// removes what rounding left of a nearly parallel vector. Returns the length of the rest.
double Project(const Vector3& axis, Vector3& vector)
{
  double rest = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    const double along = vtkMath::Dot(axis, vector);
    for (std::size_t k = 0; k < 3; ++k)
    {
      vector[k] -= along * axis[k];
    }
    const double length = vtkMath::Normalize(vector.data());
    rest = i == 0 ? length : rest;
  }
  return rest;
}
}

bool ReadSTEPDirection(const STEPAttributes& entities, Part21File::Index direction, Vector3& unit)
{
  if (!entities.Has(direction, STEPRole::Direction) || entities.File.IsDamaged(direction) ||
    !ReadThreeNumbers(entities.Get(direction, RatiosOfDirection).Text, unit))
  {
    return false;
  }
  const double length = vtkMath::Normalize(unit.data());
  return length > 0.0 && std::isfinite(length);
}

bool ProjectFirstAxis(const Vector3& z, const Vector3* reference, Vector3& x)
{
  if (reference)
  {
    x = *reference;
    return Project(z, x) > ParallelSine;
  }
  x = { 1.0, 0.0, 0.0 };
  if (Project(z, x) <= DefaultSine)
  {
    x = { 0.0, 1.0, 0.0 };
    Project(z, x);
  }
  return true;
}

bool MakeBaseAxes(const std::array<const Vector3*, 3>& given, std::array<Vector3, 3>& axes)
{
  Vector3& x = axes[0];
  Vector3& y = axes[1];
  Vector3& z = axes[2];
  z = given[2] ? *given[2] : Vector3{ 0.0, 0.0, 1.0 };
  if (!ProjectFirstAxis(z, given[0], x))
  {
    return false;
  }
  y = given[1] ? *given[1] : Vector3{ 0.0, 1.0, 0.0 };
  Project(z, y);
  return Project(x, y) > ParallelSine;
}

bool ReadSTEPFrame(const STEPAttributes& entities, Part21File::Index placement, STEPFrame& frame)
{
  std::string_view record;
  if (!entities.FindRecord(placement, AxisOfPlacement.Record, record) || entities.File.IsDamaged(placement) ||
    entities.File.IsComplex(placement))
  {
    return false;
  }
  const Part21File::Index location = entities.Follow(entities.Get(placement, LocationOfPlacement));
  const Part21Value axis = entities.Get(placement, AxisOfPlacement);
  const Part21Value reference = entities.Get(placement, ReferenceOfPlacement);
  Vector3& z = frame.Axes[2];
  z = { 0.0, 0.0, 1.0 };
  Vector3 near{};
  if (!entities.Has(location, STEPRole::Point) || entities.File.IsDamaged(location) ||
    !ReadThreeNumbers(entities.Get(location, CoordinatesOfPoint).Text, frame.Origin) ||
    (axis.Kind != Part21Kind::Omitted && !ReadSTEPDirection(entities, entities.Follow(axis), z)) ||
    (reference.Kind != Part21Kind::Omitted && !ReadSTEPDirection(entities, entities.Follow(reference), near)))
  {
    return false;
  }
  if (!ProjectFirstAxis(z, reference.Kind == Part21Kind::Omitted ? nullptr : &near, frame.Axes[0]))
  {
    return false;
  }
  vtkMath::Cross(z.data(), frame.Axes[0].data(), frame.Axes[1].data());
  return true;
}
}
