#include "smSTEPGeometryMakers.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr STEPAttribute PositionOfSurface = { "ELEMENTARY_SURFACE", 0, 1, "position" };
constexpr STEPAttribute CurveOfSwept = { "SWEPT_SURFACE", 0, 1, "swept curve" };
constexpr STEPAttribute AxisOfExtrusion = { "SURFACE_OF_LINEAR_EXTRUSION", 0, 2, "axis" };
constexpr STEPAttribute AxisOfRevolution = { "SURFACE_OF_REVOLUTION", 0, 2, "axis" };
constexpr STEPAttribute DirectionOfVector = { "VECTOR", 0, 1, "orientation" };
constexpr STEPAttribute MagnitudeOfVector = { "VECTOR", 1, 2, "magnitude" };
constexpr STEPAttribute LocationOfAxis = { "PLACEMENT", 0, 1, "location" };
constexpr STEPAttribute DirectionOfAxis = { "AXIS1_PLACEMENT", 0, 2, "axis" };
constexpr STEPAttribute PolesOfSurface = { "B_SPLINE_SURFACE", 2, 3, "control points" };
constexpr STEPAttribute BasisOfBounded = { "CURVE_BOUNDED_SURFACE", 0, 1, "basis surface" };
constexpr STEPAttribute BasisOfOffset = { "OFFSET_SURFACE", 0, 1, "basis surface" };
constexpr STEPAttribute DistanceOfOffset = { "OFFSET_SURFACE", 1, 2, "distance" };
constexpr STEPAttribute ParentOfSurface = { "SURFACE_REPLICA", 0, 1, "parent" };
constexpr STEPAttribute OperatorOfSurface = { "SURFACE_REPLICA", 1, 2, "transformation" };
constexpr const char* Rectangular = "RECTANGULAR_TRIMMED_SURFACE";
constexpr std::size_t ElementaryParameter = 2;

/// Ends of a trimmed periodic direction that differ by less than this, relative to the period, are the same.
constexpr double SameBorder = 1e-12;
}

STEPSurfaceMaker::STEPSurfaceMaker(STEPGeometry& geometry)
  : Geometry(geometry)
  , Entities(geometry.Entities)
  , Units(geometry.Units)
{
}

STEPSurface STEPSurfaceMaker::Make(Index entity)
{
  static constexpr struct
  {
    const char* Record;
    Method Make;
  } kinds[] = { { "PLANE", &STEPSurfaceMaker::MakeElementary },
    { "CYLINDRICAL_SURFACE", &STEPSurfaceMaker::MakeElementary },
    { "CONICAL_SURFACE", &STEPSurfaceMaker::MakeElementary },
    { "SPHERICAL_SURFACE", &STEPSurfaceMaker::MakeElementary },
    { "TOROIDAL_SURFACE", &STEPSurfaceMaker::MakeElementary },
    { "DEGENERATE_TOROIDAL_SURFACE", &STEPSurfaceMaker::MakeElementary },
    { "SURFACE_OF_LINEAR_EXTRUSION", &STEPSurfaceMaker::MakeExtruded },
    { "SURFACE_OF_REVOLUTION", &STEPSurfaceMaker::MakeRevolved },
    { Rectangular, &STEPSurfaceMaker::MakeTrimmed },
    { "CURVE_BOUNDED_SURFACE", &STEPSurfaceMaker::MakeBounded },
    { "OFFSET_SURFACE", &STEPSurfaceMaker::MakeOffset },
    { "SURFACE_REPLICA", &STEPSurfaceMaker::MakeReplica } };
  std::string_view record;
  for (const auto& kind : kinds)
  {
    if (this->Entities.FindRecord(entity, kind.Record, record))
    {
      return (this->*kind.Make)(entity);
    }
  }
  if (this->Entities.Has(entity, STEPRole::SplineSurface))
  {
    return this->MakeSpline(entity);
  }
  throw STEPGeometryFailure{ this->Entities.FindRecord(entity, "RECTANGULAR_COMPOSITE_SURFACE", record)
      ? "surfaces of several patches are not read"
      : "it is not a surface of a kind that can be read" };
}

STEPSurface STEPSurfaceMaker::Finish(GeometricSurface::Variant value) const
{
  STEPSurface result;
  std::string problem;
  result.Value = GeometricSurface::Make(std::move(value), problem);
  RequireGeometry(problem);
  result.Range[0] = result.Value->GetDomain(0);
  result.Range[1] = result.Value->GetDomain(1);
  return result;
}

const STEPCurve<3>& STEPSurfaceMaker::RequireCurve(const Part21Value& value)
{
  const STEPCurve<3>* curve = this->Geometry.GetCurve(this->Entities.Follow(value));
  if (!curve)
  {
    throw STEPGeometryFailure{ "the curve that it is made of is missing or left out" };
  }
  return *curve;
}

const STEPSurface& STEPSurfaceMaker::RequireSurface(const Part21Value& value)
{
  const STEPSurface* surface = this->Geometry.GetSurface(this->Entities.Follow(value));
  if (!surface)
  {
    throw STEPGeometryFailure{ "the surface that it is made of is missing or left out" };
  }
  return *surface;
}

STEPSurface STEPSurfaceMaker::MakeElementary(Index entity)
{
  using Type = ElementarySurface::Type;
  const auto has = [&](const char* name)
  {
    std::string_view record;
    return this->Entities.FindRecord(entity, name, record);
  };
  const auto get = [&](const char* name, std::size_t k) {
    return this->Entities.Get(entity, { name, k, ElementaryParameter + k, "" });
  };
  const double length = this->Units.Length;
  const double angle = this->Units.Angle;
  ElementarySurface value;
  value.Frame = ReadGeometryFrame(
    this->Entities, this->Entities.Follow(this->Entities.Get(entity, PositionOfSurface)), length);
  double scales[2] = { angle, length };
  if (has("PLANE"))
  {
    scales[0] = length;
  }
  else if (has("CYLINDRICAL_SURFACE"))
  {
    value.Kind = Type::Cylinder;
    value.Radii[0] = length * RequireNumber(get("CYLINDRICAL_SURFACE", 0), "radius");
  }
  else if (has("CONICAL_SURFACE"))
  {
    value.Kind = Type::Cone;
    value.Radii[0] = length * RequireNumber(get("CONICAL_SURFACE", 0), "radius");
    value.Angle = angle * RequireNumber(get("CONICAL_SURFACE", 1), "angle");
    scales[1] = length / std::cos(value.Angle);
    // A cone without an angle is a cylinder.
    value.Kind = value.Angle == 0.0 && value.Radii[0] > 0.0 ? Type::Cylinder : Type::Cone;
  }
  else if (has("SPHERICAL_SURFACE"))
  {
    value.Kind = Type::Sphere;
    value.Radii[0] = length * RequireNumber(get("SPHERICAL_SURFACE", 0), "radius");
    scales[1] = angle;
  }
  else
  {
    value.Kind = Type::Torus;
    const char* const degenerate = "DEGENERATE_TOROIDAL_SURFACE";
    for (std::size_t k = 0; k < 2; ++k)
    {
      value.Radii[k] = length * RequireNumber(get("TOROIDAL_SURFACE", k), "radius");
    }
    if (has(degenerate))
    {
      const bool isOuter =
        RequireLogical(this->Entities.Get(entity, { degenerate, 0, 4, "" }), "selection of a part");
      value.Selected = isOuter ? ElementarySurface::Part::Outer : ElementarySurface::Part::Inner;
    }
    scales[1] = angle;
  }
  STEPSurface result = this->Finish(value);
  result.Parameters[0].Scale = scales[0];
  result.Parameters[1].Scale = scales[1];
  return result;
}

STEPSurface STEPSurfaceMaker::MakeExtruded(Index entity)
{
  const STEPCurve<3>& profile = this->RequireCurve(this->Entities.Get(entity, CurveOfSwept));
  const Index vector = this->Entities.Follow(this->Entities.Get(entity, AxisOfExtrusion));
  ExtrudedSurface value;
  value.Profile = profile.Value;
  value.Range = profile.Range;
  value.Direction = ReadGeometryDirection<3>(
    this->Entities, this->Entities.Follow(this->Entities.Get(vector, DirectionOfVector)));
  const double length = RequireNumber(this->Entities.Get(vector, MagnitudeOfVector), MagnitudeOfVector.Name);
  STEPSurface result = this->Finish(std::move(value));
  result.Parameters[0] = profile.Parameter;
  result.Parameters[1].Scale = length > 0.0 ? length * this->Units.Length : this->Units.Length;
  return result;
}

STEPSurface STEPSurfaceMaker::MakeRevolved(Index entity)
{
  const STEPCurve<3>& profile = this->RequireCurve(this->Entities.Get(entity, CurveOfSwept));
  const Index axis = this->Entities.Follow(this->Entities.Get(entity, AxisOfRevolution));
  RevolvedSurface value;
  value.Profile = profile.Value;
  value.Range = profile.Range;
  value.Origin = ReadGeometryPoint<3>(
    this->Entities, this->Entities.Follow(this->Entities.Get(axis, LocationOfAxis)), this->Units.Length);
  const Part21Value direction = this->Entities.Get(axis, DirectionOfAxis);
  value.Axis = direction.Kind == Part21Kind::Omitted
    ? Vector3{ 0.0, 0.0, 1.0 }
    : ReadGeometryDirection<3>(this->Entities, this->Entities.Follow(direction));
  STEPSurface result = this->Finish(std::move(value));
  result.Parameters[0].Scale = this->Units.Angle;
  result.Parameters[1] = profile.Parameter;
  return result;
}

STEPSurface STEPSurfaceMaker::MakeSpline(Index entity)
{
  SplineSurface value;
  std::int64_t degrees[2] = { 0, 0 };
  for (std::size_t d = 0; d < 2; ++d)
  {
    if (!this->Entities.Get(entity, { "B_SPLINE_SURFACE", d, 1 + d, "" }).GetInteger(degrees[d]) ||
      degrees[d] < 1 || degrees[d] > MaximumDegree)
    {
      throw STEPGeometryFailure{ "its degree is not between 1 and " + std::to_string(MaximumDegree) };
    }
  }
  // The file lists all poles of a value of u one after another.
  std::vector<std::vector<Vector3>> columns;
  Part21Values lists(this->Entities.Get(entity, PolesOfSurface).Text);
  for (Part21Value list; lists.Next(list);)
  {
    columns.emplace_back();
    for (const Index point : ReadGeometryList(this->Entities, list))
    {
      columns.back().push_back(ReadGeometryPoint<3>(this->Entities, point, this->Units.Length));
    }
  }
  std::vector<std::vector<double>> weights;
  std::string_view record;
  if (this->Entities.FindRecord(entity, "RATIONAL_B_SPLINE_SURFACE", record))
  {
    Part21Values rows(GetPart21Value(record, 0).Text);
    for (Part21Value row; rows.Next(row);)
    {
      weights.push_back(ReadGeometryNumbers(row));
    }
    if (weights.size() != columns.size())
    {
      throw STEPGeometryFailure{ "it has not as many weights as control points" };
    }
  }
  const std::size_t count = columns.empty() ? 0 : columns[0].size();
  for (std::size_t j = 0; j < count; ++j)
  {
    for (std::size_t i = 0; i < columns.size(); ++i)
    {
      if (columns[i].size() != count || (!weights.empty() && weights[i].size() != count))
      {
        throw STEPGeometryFailure{ "the rows of its control points or weights have different lengths" };
      }
      value.Poles.push_back(columns[i][j]);
      if (!weights.empty())
      {
        value.Weights.push_back(weights[i][j]);
      }
    }
  }
  for (int d = 0; d < 2; ++d)
  {
    value.Basis[d] = ReadGeometryBasis(this->Entities, entity, true, d, static_cast<int>(degrees[d]),
      static_cast<int>(d == 0 ? columns.size() : count));
  }
  return this->Finish(std::move(value));
}

STEPSurface STEPSurfaceMaker::MakeTrimmed(Index entity)
{
  STEPSurface result = this->RequireSurface(this->Entities.Get(entity, { Rectangular, 0, 1, "" }));
  for (std::size_t d = 0; d < 2; ++d)
  {
    const ParameterScale basis = result.Parameters[d];
    const auto read = [&](std::size_t k)
    {
      const std::size_t own = 1 + 2 * d + k;
      return basis(RequireNumber(this->Entities.Get(entity, { Rectangular, own, own + 1, "" }), "border"));
    };
    const double first = read(0);
    double last = read(1);
    const bool agrees =
      RequireLogical(this->Entities.Get(entity, { Rectangular, 5 + d, 6 + d, "" }), "sense of a direction");
    // The parameter is that of the basis, counted from the first border in the sense.
    const double scale = agrees ? basis.Scale : -basis.Scale;
    const double sign = scale > 0.0 ? 1.0 : -1.0;
    const double period = result.Value->GetPeriod(static_cast<int>(d));
    if (period > 0.0 && sign * (last - first) <= SameBorder * period)
    {
      last += sign * period * std::ceil((SameBorder * period - sign * (last - first)) / period);
    }
    if (!(sign * (last - first) > 0.0))
    {
      throw STEPGeometryFailure{ "it ends before it begins, in a direction that is not periodic" };
    }
    result.Range[d] = { std::min(first, last), std::max(first, last) };
    result.Parameters[d] = { scale, first };
  }
  return result;
}

STEPSurface STEPSurfaceMaker::MakeBounded(Index entity)
{
  return this->RequireSurface(this->Entities.Get(entity, BasisOfBounded));
}

STEPSurface STEPSurfaceMaker::MakeOffset(Index entity)
{
  const STEPSurface& basis = this->RequireSurface(this->Entities.Get(entity, BasisOfOffset));
  const double distance =
    this->Units.Length * RequireNumber(this->Entities.Get(entity, DistanceOfOffset), DistanceOfOffset.Name);
  STEPSurface result = this->Finish(OffsetSurface{ basis.Value, basis.IsReversed() ? -distance : distance });
  for (int d = 0; d < 2; ++d)
  {
    result.Range[d] = basis.Range[d];
    result.Parameters[d] = basis.Parameters[d];
  }
  return result;
}

STEPSurface STEPSurfaceMaker::MakeReplica(Index entity)
{
  const STEPSurface& parent = this->RequireSurface(this->Entities.Get(entity, ParentOfSurface));
  const AffineTransform<3> transform = ReadGeometryOperator<3>(
    this->Entities, this->Entities.Follow(this->Entities.Get(entity, OperatorOfSurface)), this->Units.Length);
  ParameterScale own[2];
  std::string problem;
  STEPSurface result;
  result.Value = TransformSurface(parent.Value, transform, own, problem);
  RequireGeometry(problem);
  for (int d = 0; d < 2; ++d)
  {
    result.Range[d] = { own[d](parent.Range[d].Low), own[d](parent.Range[d].High) };
    result.Parameters[d] = { own[d].Scale * parent.Parameters[d].Scale, own[d](parent.Parameters[d].Offset) };
  }
  return result;
}
}
