#include "smSTEPGeometryReading.h"

#include "smSTEPFrames.h"
#include "smSTEPPropertyAttributes.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr STEPAttribute ReferenceInPlane = { "AXIS2_PLACEMENT_2D", 0, 2, "reference direction" };

/// The parameters of an operator behind its names: two axes, origin, scale, and in space the third axis.
constexpr std::size_t ParametersInPlane = 4;
constexpr std::size_t ParametersInSpace = 5;

constexpr double MinSine = 1e-12;

template <int Dimension>
bool ReadCoordinates(const Part21Value& list, std::array<double, Dimension>& numbers)
{
  Part21Values values(list.Text);
  Part21Value value;
  for (double& number : numbers)
  {
    if (!list.IsList() || !values.Next(value) || !value.GetNumber(number))
    {
      return false;
    }
  }
  return !values.Next(value) && !values.IsMalformed();
}

/// Returns the values of a record, or of a simple instance.
std::vector<Part21Value> GetValues(std::string_view text)
{
  std::vector<Part21Value> result;
  Part21Values values(text);
  for (Part21Value value; values.Next(value);)
  {
    result.push_back(value);
  }
  return result;
}

/// The x axis of a placement: the reference direction, made normal to the axis; the default where they are
/// parallel, which FindSTEPDoubts() reports if it matters.
Vector3 MakeFirstAxis(const Vector3& z, const Vector3& reference)
{
  Vector3 x = Cross(z, Cross(reference, z));
  const double length = Norm(x);
  if (!(length > MinSine))
  {
    ProjectFirstAxis(z, nullptr, x);
    return x;
  }
  return { x[0] / length, x[1] / length, x[2] / length };
}

/// Returns the values of an operator from its first axis on; parts of a complex instance are joined.
std::vector<Part21Value> GetOperatorValues(
  const STEPAttributes& entities, Part21File::Index entity, std::size_t count)
{
  std::string_view common;
  std::vector<Part21Value> values;
  if (!entities.File.IsComplex(entity))
  {
    values = GetValues(entities.File.GetParameters(entity));
  }
  else if (entities.FindRecord(entity, "CARTESIAN_TRANSFORMATION_OPERATOR", common))
  {
    values = GetValues(common);
    std::string_view own;
    if (entities.FindRecord(entity, "CARTESIAN_TRANSFORMATION_OPERATOR_3D", own))
    {
      values.push_back(GetPart21Value(own, 0));
    }
  }
  if (values.size() < count)
  {
    throw STEPGeometryFailure{ "its transformation has too few parameters" };
  }
  return { values.end() - count, values.end() };
}

Part21File::Index RequireReference(const STEPAttributes& entities, const Part21Value& value, const char* name)
{
  const Part21File::Index found = entities.Follow(value);
  if (found == Part21File::None)
  {
    throw STEPGeometryFailure{ std::string("its ") + name + " is missing" };
  }
  return found;
}
}

void RequireGeometry(const std::string& problem)
{
  if (!problem.empty())
  {
    throw STEPGeometryFailure{ problem };
  }
}

double RequireNumber(const Part21Value& value, const char* name)
{
  double number = 0.0;
  const Part21Value inner = value.Kind == Part21Kind::Typed ? GetPart21Value(value.Text, 0) : value;
  if (!inner.GetNumber(number))
  {
    throw STEPGeometryFailure{ std::string("its ") + name + " is not a number" };
  }
  return number;
}

bool RequireLogical(const Part21Value& value, const char* name)
{
  if (value.Kind != Part21Kind::Enumeration || (value.Text != "T" && value.Text != "F"))
  {
    throw STEPGeometryFailure{ std::string("its ") + name + " is neither .T. nor .F." };
  }
  return value.Text == "T";
}

template <int Dimension>
std::array<double, Dimension> ReadGeometryPoint(
  const STEPAttributes& entities, Part21File::Index point, double unit)
{
  std::array<double, Dimension> result{};
  std::string_view record;
  if (!entities.FindRecord(point, CoordinatesOfPoint.Record, record) || entities.File.IsDamaged(point) ||
    !ReadCoordinates<Dimension>(entities.Get(point, CoordinatesOfPoint), result))
  {
    throw STEPGeometryFailure{ "one of its points is not a CARTESIAN_POINT with " +
      std::to_string(Dimension) + " coordinates" };
  }
  for (double& x : result)
  {
    x *= unit;
  }
  return result;
}

template <int Dimension>
std::array<double, Dimension> ReadGeometryDirection(
  const STEPAttributes& entities, Part21File::Index direction)
{
  std::array<double, Dimension> result{};
  if (!entities.Has(direction, STEPRole::Direction) || entities.File.IsDamaged(direction) ||
    !ReadCoordinates<Dimension>(entities.Get(direction, RatiosOfDirection), result))
  {
    throw STEPGeometryFailure{ "one of its directions is damaged" };
  }
  double square = 0.0;
  for (const double x : result)
  {
    square += x * x;
  }
  const double length = std::sqrt(square);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    throw STEPGeometryFailure{ "one of its directions has no length" };
  }
  for (double& x : result)
  {
    x /= length;
  }
  return result;
}

GeometricFrame ReadGeometryFrame(const STEPAttributes& entities, Part21File::Index placement, double unit)
{
  std::string_view record;
  if (!entities.FindRecord(placement, AxisOfPlacement.Record, record) || entities.File.IsDamaged(placement))
  {
    throw STEPGeometryFailure{ "its placement is not an AXIS2_PLACEMENT_3D" };
  }
  GeometricFrame frame;
  frame.Origin =
    ReadGeometryPoint<3>(entities, entities.Follow(entities.Get(placement, LocationOfPlacement)), unit);
  const Part21Value axis = entities.Get(placement, AxisOfPlacement);
  const Part21Value reference = entities.Get(placement, ReferenceOfPlacement);
  Vector3& z = frame.Axes[2];
  if (axis.Kind != Part21Kind::Omitted)
  {
    z = ReadGeometryDirection<3>(entities, entities.Follow(axis));
  }
  if (reference.Kind == Part21Kind::Omitted)
  {
    ProjectFirstAxis(z, nullptr, frame.Axes[0]);
  }
  else
  {
    frame.Axes[0] = MakeFirstAxis(z, ReadGeometryDirection<3>(entities, entities.Follow(reference)));
  }
  frame.Axes[1] = Cross(z, frame.Axes[0]);
  return frame;
}

template <>
std::array<Vector3, 3> ReadGeometryAxes<3>(
  const STEPAttributes& entities, Part21File::Index placement, double unit)
{
  const GeometricFrame frame = ReadGeometryFrame(entities, placement, unit);
  return { frame.Origin, frame.Axes[0], frame.Axes[1] };
}

template <>
std::array<std::array<double, 2>, 3> ReadGeometryAxes<2>(
  const STEPAttributes& entities, Part21File::Index placement, double unit)
{
  std::string_view record;
  if (!entities.FindRecord(placement, ReferenceInPlane.Record, record) || entities.File.IsDamaged(placement))
  {
    throw STEPGeometryFailure{ "its placement is not an AXIS2_PLACEMENT_2D" };
  }
  const Part21Value reference = entities.Get(placement, ReferenceInPlane);
  std::array<std::array<double, 2>, 3> axes{};
  axes[0] =
    ReadGeometryPoint<2>(entities, entities.Follow(entities.Get(placement, LocationOfPlacement)), unit);
  axes[1] = reference.Kind == Part21Kind::Omitted
    ? std::array<double, 2>{ 1.0, 0.0 }
    : ReadGeometryDirection<2>(entities, entities.Follow(reference));
  axes[2] = { -axes[1][1], axes[1][0] };
  return axes;
}

template <int Dimension>
AffineTransform<Dimension> ReadGeometryOperator(
  const STEPAttributes& entities, Part21File::Index entity, double unit)
{
  if (!entities.Has(entity, STEPRole::Transformation) || entities.File.IsDamaged(entity))
  {
    throw STEPGeometryFailure{ "its transformation is damaged or missing" };
  }
  const std::vector<Part21Value> values =
    GetOperatorValues(entities, entity, Dimension == 3 ? ParametersInSpace : ParametersInPlane);
  const double scale = values[3].Kind == Part21Kind::Omitted ? 1.0 : RequireNumber(values[3], "scale");
  if (!(scale > 0.0) || !std::isfinite(scale))
  {
    throw STEPGeometryFailure{ "the scale of its transformation is not positive" };
  }
  std::array<std::array<double, Dimension>, Dimension> axes{};
  std::array<std::array<double, Dimension>, Dimension> read{};
  std::array<bool, Dimension> isGiven{};
  for (int k = 0; k < Dimension; ++k)
  {
    const Part21Value& value = values[k < 2 ? k : 4];
    isGiven[k] = value.Kind != Part21Kind::Omitted;
    if (isGiven[k])
    {
      read[k] =
        ReadGeometryDirection<Dimension>(entities, RequireReference(entities, value, "axis of the operator"));
    }
  }
  if constexpr (Dimension == 3)
  {
    const auto get = [&](int k) { return isGiven[k] ? &read[k] : nullptr; };
    if (!MakeBaseAxes({ get(0), get(1), get(2) }, axes))
    {
      // FindSTEPDoubts() sees simple instances only.
      if (entities.File.IsComplex(entity))
      {
        throw STEPGeometryFailure{ "two axes of its transformation are parallel" };
      }
      // Two are parallel, which FindSTEPDoubts() reports: the last axis counts first.
      axes[2] = isGiven[2] ? read[2] : Vector3{ 0.0, 0.0, 1.0 };
      if (!isGiven[0] || !ProjectFirstAxis(axes[2], &read[0], axes[0]))
      {
        ProjectFirstAxis(axes[2], nullptr, axes[0]);
      }
      axes[1] = Cross(axes[2], axes[0]);
    }
  }
  else
  {
    // base_axis in the plane: the first axis decides; without one the second axis does.
    const std::array<double, 2> x = isGiven[0] ? read[0]
      : isGiven[1]                             ? std::array<double, 2>{ read[1][1], -read[1][0] }
                                               : std::array<double, 2>{ 1.0, 0.0 };
    const bool isMirrored = isGiven[0] && isGiven[1] && -x[1] * read[1][0] + x[0] * read[1][1] < 0.0;
    axes[0] = x;
    axes[1] = { isMirrored ? x[1] : -x[1], isMirrored ? -x[0] : x[0] };
  }
  AffineTransform<Dimension> result;
  result.Translation = ReadGeometryPoint<Dimension>(
    entities, RequireReference(entities, values[2], "origin of the operator"), unit);
  for (int i = 0; i < Dimension; ++i)
  {
    for (int j = 0; j < Dimension; ++j)
    {
      result.Linear[i][j] = scale * axes[j][i];
    }
  }
  return result;
}

std::vector<Part21File::Index> ReadGeometryList(const STEPAttributes& entities, const Part21Value& list)
{
  std::vector<Part21File::Index> result;
  Part21Values values(list.Text);
  for (Part21Value value; list.IsList() && values.Next(value);)
  {
    result.push_back(entities.Follow(value));
  }
  if (result.empty() || values.IsMalformed())
  {
    throw STEPGeometryFailure{ "one of its lists is empty or damaged" };
  }
  return result;
}

std::vector<double> ReadGeometryNumbers(const Part21Value& list)
{
  std::vector<double> result;
  Part21Values values(list.Text);
  for (Part21Value value; list.IsList() && values.Next(value);)
  {
    result.push_back(RequireNumber(value, "knot, multiplicity or weight"));
  }
  if (values.IsMalformed())
  {
    throw STEPGeometryFailure{ "one of its lists is damaged" };
  }
  return result;
}

SplineBasis ReadGeometryBasis(const STEPAttributes& entities, Part21File::Index entity, bool isSurface,
  int direction, int degree, int count)
{
  const std::string kind = isSurface ? "SURFACE" : "CURVE";
  const std::string withKnots = "B_SPLINE_" + kind + "_WITH_KNOTS";
  const auto has = [&](const std::string& name)
  {
    std::string_view record;
    return entities.FindRecord(entity, name, record);
  };
  SplineBasis basis;
  basis.Degree = degree;
  if (has(withKnots))
  {
    const std::size_t lists = isSurface ? 2 : 1;
    const std::size_t before = isSurface ? 8 : 6;
    const auto get = [&](std::size_t index) {
      return ReadGeometryNumbers(entities.Get(entity, { withKnots.c_str(), index, before + index, "" }));
    };
    basis.Knots = get(lists + direction);
    for (const double multiplicity : get(direction))
    {
      // A larger one is refused by SplineBasis, which knows the degree.
      basis.Multiplicities.push_back(static_cast<int>(std::clamp(multiplicity, 0.0, 1e6)));
    }
    return basis;
  }
  // ISO 10303-42: Bézier pieces join at knots of multiplicity `degree`; uniform knots are -degree, 1 -
  // degree, ...; quasi-uniform ones are 0 and the integers, with the ends repeated.
  const bool isBezier = has("BEZIER_" + kind);
  const int spans = isBezier ? (count - 1) / degree : count - degree;
  if (spans < 1 || (isBezier && spans * degree + 1 != count))
  {
    throw STEPGeometryFailure{ "its number of control points does not fit its degree" };
  }
  const bool isUniform = has("UNIFORM_" + kind);
  if (!isBezier && !isUniform && !has("QUASI_UNIFORM_" + kind))
  {
    throw STEPGeometryFailure{ "it states no knots" };
  }
  for (int k = isUniform ? -degree : 0; k <= (isUniform ? count : spans); ++k)
  {
    const bool isEnd = !isUniform && (k == 0 || k == spans);
    basis.Knots.push_back(k);
    basis.Multiplicities.push_back(isEnd ? degree + 1 : isBezier ? degree : 1);
  }
  return basis;
}

template std::array<double, 2> ReadGeometryPoint<2>(const STEPAttributes&, Part21File::Index, double);
template std::array<double, 3> ReadGeometryPoint<3>(const STEPAttributes&, Part21File::Index, double);
template std::array<double, 2> ReadGeometryDirection<2>(const STEPAttributes&, Part21File::Index);
template std::array<double, 3> ReadGeometryDirection<3>(const STEPAttributes&, Part21File::Index);
template AffineTransform<2> ReadGeometryOperator<2>(const STEPAttributes&, Part21File::Index, double);
template AffineTransform<3> ReadGeometryOperator<3>(const STEPAttributes&, Part21File::Index, double);
}
