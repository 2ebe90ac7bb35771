#include "smSTEPGeometryMakers.h"

#include "Geometry/smCurveFoot.h"
#include "smSTEPTopologyAttributes.h"

#include <vtkMath.h>

#include <cmath>

namespace sm
{
namespace
{
constexpr STEPAttribute PointOfLine = { "LINE", 0, 1, "point" };
constexpr STEPAttribute VectorOfLine = { "LINE", 1, 2, "vector" };
constexpr STEPAttribute OrientationOfVector = { "VECTOR", 0, 1, "orientation" };
constexpr STEPAttribute LengthOfVector = { "VECTOR", 1, 2, "magnitude" };
constexpr STEPAttribute PositionOfConic = { "CONIC", 0, 1, "position" };
constexpr STEPAttribute PointsOfPolygon = { "POLYLINE", 0, 1, "points" };
constexpr STEPAttribute DegreeOfCurve = { "B_SPLINE_CURVE", 0, 1, "degree" };
constexpr STEPAttribute PolesOfCurve = { "B_SPLINE_CURVE", 1, 2, "control points" };
constexpr STEPAttribute BasisOfTrim = { "TRIMMED_CURVE", 0, 1, "basis curve" };
constexpr STEPAttribute FirstTrim = { "TRIMMED_CURVE", 1, 2, "first trim" };
constexpr STEPAttribute SecondTrim = { "TRIMMED_CURVE", 2, 3, "second trim" };
constexpr STEPAttribute SenseOfTrim = { "TRIMMED_CURVE", 3, 4, "sense" };
constexpr STEPAttribute MasterOfTrim = { "TRIMMED_CURVE", 4, 5, "master representation" };
constexpr STEPAttribute SegmentsOfComposite = { "COMPOSITE_CURVE", 0, 1, "segments" };
constexpr STEPAttribute SenseOfSegment = { "COMPOSITE_CURVE_SEGMENT", 1, 1, "sense" };
constexpr STEPAttribute CurveOfSegment = { "COMPOSITE_CURVE_SEGMENT", 2, 2, "curve" };
constexpr STEPAttribute LengthOfSegment = { "REPARAMETRISED_COMPOSITE_CURVE_SEGMENT", 0, 3, "length" };
constexpr STEPAttribute ParentOfReplica = { "CURVE_REPLICA", 0, 1, "parent" };
constexpr STEPAttribute OperatorOfReplica = { "CURVE_REPLICA", 1, 2, "transformation" };
constexpr STEPAttribute SurfaceOfPcurve = { "PCURVE", 0, 1, "surface" };
constexpr STEPAttribute CurveOfPcurve = { "PCURVE", 1, 2, "curve" };
constexpr STEPAttribute ItemsOfDefinition = { "REPRESENTATION", 1, 1, "items" };

/// Largest difference of the ends of a trimmed periodic curve, relative to the period, that is not a
/// difference.
constexpr double SameTrim = 1e-12;
}

template <int Dimension>
STEPCurveMaker<Dimension>::STEPCurveMaker(STEPGeometry& geometry)
  : Geometry(geometry)
  , Entities(geometry.Entities)
  , Length(Dimension == 3 ? geometry.Units.Length : 1.0)
{
}

template <int Dimension>
STEPCurve<Dimension> STEPCurveMaker<Dimension>::Make(Index entity)
{
  static constexpr struct
  {
    const char* Record;
    Method Make;
  } kinds[] = { { "LINE", &STEPCurveMaker::MakeLine }, { "CIRCLE", &STEPCurveMaker::MakeConic },
    { "ELLIPSE", &STEPCurveMaker::MakeConic }, { "PARABOLA", &STEPCurveMaker::MakeConic },
    { "HYPERBOLA", &STEPCurveMaker::MakeConic }, { "POLYLINE", &STEPCurveMaker::MakePolyline },
    { "TRIMMED_CURVE", &STEPCurveMaker::MakeTrimmed }, { "COMPOSITE_CURVE", &STEPCurveMaker::MakeComposite },
    { "COMPOSITE_CURVE_ON_SURFACE", &STEPCurveMaker::MakeComposite },
    { "BOUNDARY_CURVE", &STEPCurveMaker::MakeComposite },
    { "OUTER_BOUNDARY_CURVE", &STEPCurveMaker::MakeComposite },
    { Dimension == 3 ? "OFFSET_CURVE_3D" : "OFFSET_CURVE_2D", &STEPCurveMaker::MakeOffset },
    { "CURVE_REPLICA", &STEPCurveMaker::MakeReplica }, { "SURFACE_CURVE", &STEPCurveMaker::MakeSurfaceCurve },
    { "SEAM_CURVE", &STEPCurveMaker::MakeSurfaceCurve },
    { "INTERSECTION_CURVE", &STEPCurveMaker::MakeSurfaceCurve },
    { "BOUNDED_SURFACE_CURVE", &STEPCurveMaker::MakeSurfaceCurve }, { "PCURVE", &STEPCurveMaker::MakePcurve },
    { "BOUNDED_PCURVE", &STEPCurveMaker::MakePcurve } };
  std::string_view record;
  for (const auto& kind : kinds)
  {
    if (this->Entities.FindRecord(entity, kind.Record, record))
    {
      return (this->*kind.Make)(entity);
    }
  }
  if (this->Entities.Has(entity, STEPRole::SplineCurve))
  {
    return this->MakeSpline(entity);
  }
  throw STEPGeometryFailure{ "it is not a curve of a kind that can be read" };
}

template <int Dimension>
STEPCurve<Dimension> STEPCurveMaker<Dimension>::Finish(
  typename GeometricCurve<Dimension>::Variant value, double scale) const
{
  STEPCurve<Dimension> result;
  std::string problem;
  result.Value = GeometricCurve<Dimension>::Make(std::move(value), problem);
  RequireGeometry(problem);
  result.Range = result.Value->GetDomain();
  result.Parameter.Scale = scale;
  return result;
}

template <int Dimension>
auto STEPCurveMaker<Dimension>::ReadPoints(const Part21Value& list) const -> std::vector<Point>
{
  std::vector<Point> points;
  for (const Index point : ReadGeometryList(this->Entities, list))
  {
    points.push_back(ReadGeometryPoint<Dimension>(this->Entities, point, this->Length));
  }
  return points;
}

template <int Dimension>
const STEPCurve<Dimension>& STEPCurveMaker<Dimension>::Require(const Part21Value& value)
{
  const Index entity = this->Entities.Follow(value);
  const STEPCurve<Dimension>* curve = nullptr;
  if constexpr (Dimension == 3)
  {
    curve = this->Geometry.GetCurve(entity);
  }
  else
  {
    curve = this->Geometry.GetPlaneCurve(entity);
  }
  if (!curve)
  {
    throw STEPGeometryFailure{ "the curve that it is made of is missing or left out" };
  }
  return *curve;
}

template <int Dimension>
STEPCurve<Dimension> STEPCurveMaker<Dimension>::MakeLine(Index entity)
{
  const Index vector = this->Entities.Follow(this->Entities.Get(entity, VectorOfLine));
  LineCurve<Dimension> line;
  line.Origin = ReadGeometryPoint<Dimension>(
    this->Entities, this->Entities.Follow(this->Entities.Get(entity, PointOfLine)), this->Length);
  line.Direction = ReadGeometryDirection<Dimension>(
    this->Entities, this->Entities.Follow(this->Entities.Get(vector, OrientationOfVector)));
  const double length = RequireNumber(this->Entities.Get(vector, LengthOfVector), LengthOfVector.Name);
  // A vector without a length gives a line no direction; what is meant is clear all the same.
  return this->Finish(line, length > 0.0 ? length * this->Length : this->Length);
}

template <int Dimension>
STEPCurve<Dimension> STEPCurveMaker<Dimension>::MakeConic(Index entity)
{
  using Conic = ConicCurve<Dimension>;
  static constexpr struct
  {
    const char* Name;
    typename Conic::Type Kind;
    std::size_t Radii;
  } kinds[] = { { "CIRCLE", Conic::Type::Ellipse, 1 }, { "ELLIPSE", Conic::Type::Ellipse, 2 },
    { "PARABOLA", Conic::Type::Parabola, 1 }, { "HYPERBOLA", Conic::Type::Hyperbola, 2 } };
  Conic conic;
  double scale = 1.0;
  for (const auto& kind : kinds)
  {
    std::string_view record;
    if (!this->Entities.FindRecord(entity, kind.Name, record))
    {
      continue;
    }
    conic.Kind = kind.Kind;
    for (std::size_t k = 0; k < 2; ++k)
    {
      const std::size_t own = std::min(k, kind.Radii - 1);
      conic.Radii[k] =
        this->Length * RequireNumber(this->Entities.Get(entity, { kind.Name, own, own + 2, "" }), "radius");
    }
  }
  const auto axes = ReadGeometryAxes<Dimension>(
    this->Entities, this->Entities.Follow(this->Entities.Get(entity, PositionOfConic)), this->Length);
  conic.Center = axes[0];
  conic.X = axes[1];
  conic.Y = axes[2];
  if (conic.Kind == Conic::Type::Parabola && conic.Radii[0] < 0.0)
  {
    // C + f (u^2 X + 2 u Y) with f < 0 is the parabola along -X and -Y.
    conic.Radii[0] = conic.Radii[1] = -conic.Radii[0];
    for (int c = 0; c < Dimension; ++c)
    {
      conic.X[c] = -conic.X[c];
      conic.Y[c] = -conic.Y[c];
    }
  }
  // The first axis is the longer one: it is a quarter of a turn behind that of the file.
  const bool isExchanged = conic.Kind == Conic::Type::Ellipse && conic.Radii[1] > conic.Radii[0];
  if (isExchanged)
  {
    std::swap(conic.Radii[0], conic.Radii[1]);
    std::swap(conic.X, conic.Y);
    for (int c = 0; c < Dimension; ++c)
    {
      conic.Y[c] = -conic.Y[c];
    }
  }
  scale = conic.Kind == Conic::Type::Ellipse ? this->Geometry.Units.Angle
    : conic.Kind == Conic::Type::Parabola    ? 2.0 * conic.Radii[0]
                                             : 1.0;
  STEPCurve<Dimension> result = this->Finish(conic, scale);
  result.Parameter.Offset = isExchanged ? -0.5 * vtkMath::Pi() : 0.0;
  return result;
}

template <int Dimension>
STEPCurve<Dimension> STEPCurveMaker<Dimension>::MakePolyline(Index entity)
{
  SplineCurve<Dimension> spline;
  spline.Poles = this->ReadPoints(this->Entities.Get(entity, PointsOfPolygon));
  const int last = static_cast<int>(spline.Poles.size()) - 1;
  for (int k = 0; k <= last; ++k)
  {
    spline.Basis.Knots.push_back(k);
    spline.Basis.Multiplicities.push_back(k == 0 || k == last ? 2 : 1);
  }
  return this->Finish(std::move(spline), 1.0);
}

template <int Dimension>
STEPCurve<Dimension> STEPCurveMaker<Dimension>::MakeSpline(Index entity)
{
  std::int64_t degree = 0;
  if (!this->Entities.Get(entity, DegreeOfCurve).GetInteger(degree) || degree < 1 || degree > MaximumDegree)
  {
    throw STEPGeometryFailure{ "its degree is not between 1 and " + std::to_string(MaximumDegree) };
  }
  SplineCurve<Dimension> spline;
  spline.Poles = this->ReadPoints(this->Entities.Get(entity, PolesOfCurve));
  spline.Basis = ReadGeometryBasis(
    this->Entities, entity, false, 0, static_cast<int>(degree), static_cast<int>(spline.Poles.size()));
  std::string_view record;
  if (this->Entities.FindRecord(entity, "RATIONAL_B_SPLINE_CURVE", record))
  {
    spline.Weights = ReadGeometryNumbers(GetPart21Value(record, 0));
    if (spline.Weights.empty())
    {
      throw STEPGeometryFailure{ "its weights are missing" };
    }
  }
  return this->Finish(std::move(spline), 1.0);
}

template <int Dimension>
double STEPCurveMaker<Dimension>::ReadTrim(
  Index entity, const STEPAttribute& trim, const STEPCurve<Dimension>& basis) const
{
  const bool prefersPoint = this->Entities.Get(entity, MasterOfTrim).Text == "CARTESIAN";
  double parameter = std::nan("");
  double foot = std::nan("");
  Part21Values values(this->Entities.Get(entity, trim).Text);
  for (Part21Value value; values.Next(value);)
  {
    if (value.IsReference())
    {
      foot = FindCurveParameter<Dimension>(*basis.Value,
        ReadGeometryPoint<Dimension>(this->Entities, this->Entities.Follow(value), this->Length));
    }
    else
    {
      parameter = basis.Parameter(RequireNumber(value, trim.Name));
    }
  }
  const double result = std::isnan(parameter) || (prefersPoint && !std::isnan(foot)) ? foot : parameter;
  if (!std::isfinite(result))
  {
    throw STEPGeometryFailure{ std::string("its ") + trim.Name +
      " is neither a point nor a parameter of its curve" };
  }
  return result;
}

template <int Dimension>
STEPCurve<Dimension> STEPCurveMaker<Dimension>::MakeTrimmed(Index entity)
{
  const STEPCurve<Dimension>& basis = this->Require(this->Entities.Get(entity, BasisOfTrim));
  const bool agrees = RequireLogical(this->Entities.Get(entity, SenseOfTrim), SenseOfTrim.Name);
  const double first = this->ReadTrim(entity, FirstTrim, basis);
  double last = this->ReadTrim(entity, SecondTrim, basis);
  const double scale = agrees ? basis.Parameter.Scale : -basis.Parameter.Scale;
  const double sign = scale > 0.0 ? 1.0 : -1.0;
  const double period = basis.Value->GetPeriod();
  if (period > 0.0 && sign * (last - first) <= SameTrim * period)
  {
    last += sign * period * std::ceil((SameTrim * period - sign * (last - first)) / period);
  }
  if (!(sign * (last - first) > 0.0))
  {
    throw STEPGeometryFailure{ "it ends before it begins, on a curve that is not periodic" };
  }
  STEPCurve<Dimension> result;
  result.Value = basis.Value;
  result.Range = { std::min(first, last), std::max(first, last) };
  result.Parameter = { scale, first };
  return result;
}

template <int Dimension>
CurveSegment<Dimension> STEPCurveMaker<Dimension>::MakeSegment(Index entity)
{
  const STEPCurve<Dimension>& curve = this->Require(this->Entities.Get(entity, CurveOfSegment));
  const bool agrees = RequireLogical(this->Entities.Get(entity, SenseOfSegment), SenseOfSegment.Name);
  const bool isForward = agrees == (curve.Parameter.Scale > 0.0);
  CurveSegment<Dimension> segment;
  segment.Curve = curve.Value;
  segment.First = isForward ? curve.Range.Low : curve.Range.High;
  segment.Last = isForward ? curve.Range.High : curve.Range.Low;
  std::string_view record;
  segment.Length = this->Entities.FindRecord(entity, LengthOfSegment.Record, record)
    ? RequireNumber(this->Entities.Get(entity, LengthOfSegment), "length")
    : (curve.Range.High - curve.Range.Low) / std::abs(curve.Parameter.Scale);
  return segment;
}

template <int Dimension>
STEPCurve<Dimension> STEPCurveMaker<Dimension>::MakeComposite(Index entity)
{
  CompositeCurve<Dimension> composite;
  for (const Index segment :
    ReadGeometryList(this->Entities, this->Entities.Get(entity, SegmentsOfComposite)))
  {
    composite.Segments.push_back(this->MakeSegment(segment));
  }
  return this->Finish(std::move(composite), 1.0);
}

template <int Dimension>
STEPCurve<Dimension> STEPCurveMaker<Dimension>::MakeOffset(Index entity)
{
  const char* const record = Dimension == 3 ? "OFFSET_CURVE_3D" : "OFFSET_CURVE_2D";
  const STEPCurve<Dimension>& basis = this->Require(this->Entities.Get(entity, { record, 0, 1, "" }));
  OffsetCurve<Dimension> offset;
  offset.Basis = basis.Value;
  offset.Distance =
    this->Length * RequireNumber(this->Entities.Get(entity, { record, 1, 2, "" }), "distance");
  if (basis.Parameter.Scale < 0.0)
  {
    // The tangent is against that of the value.
    offset.Distance = -offset.Distance;
  }
  if (Dimension == 3)
  {
    offset.Reference = ReadGeometryDirection<Dimension>(
      this->Entities, this->Entities.Follow(this->Entities.Get(entity, { record, 3, 4, "" })));
  }
  STEPCurve<Dimension> result = this->Finish(std::move(offset), 1.0);
  result.Range = basis.Range;
  result.Parameter = basis.Parameter;
  return result;
}

template <int Dimension>
STEPCurve<Dimension> STEPCurveMaker<Dimension>::MakeReplica(Index entity)
{
  const STEPCurve<Dimension>& parent = this->Require(this->Entities.Get(entity, ParentOfReplica));
  const AffineTransform<Dimension> transform = ReadGeometryOperator<Dimension>(
    this->Entities, this->Entities.Follow(this->Entities.Get(entity, OperatorOfReplica)), this->Length);
  ParameterScale own;
  std::string problem;
  STEPCurve<Dimension> result;
  result.Value = TransformCurve<Dimension>(parent.Value, transform, own, problem);
  RequireGeometry(problem);
  result.Range = { own(parent.Range.Low), own(parent.Range.High) };
  result.Parameter = { own.Scale * parent.Parameter.Scale, own(parent.Parameter.Offset) };
  return result;
}

template <int Dimension>
STEPCurve<Dimension> STEPCurveMaker<Dimension>::MakeSurfaceCurve(Index entity)
{
  return this->Require(this->Entities.Get(entity, CurveInSpace));
}

template <>
STEPCurve<2> STEPCurveMaker<2>::MakePcurve(Index)
{
  throw STEPGeometryFailure{ "it is a curve on a surface, not in the parameters of one" };
}

template <>
STEPCurve<3> STEPCurveMaker<3>::MakePcurve(Index entity)
{
  const STEPSurface* surface =
    this->Geometry.GetSurface(this->Entities.Follow(this->Entities.Get(entity, SurfaceOfPcurve)));
  const Index definition = this->Entities.Follow(this->Entities.Get(entity, CurveOfPcurve));
  if (!surface || !this->Entities.Has(definition, STEPRole::Representation))
  {
    throw STEPGeometryFailure{ "its surface or its curve is missing or left out" };
  }
  const Part21Value items = definition == Part21File::None ? Part21Value()
    : this->Entities.File.IsComplex(definition)
    ? this->Entities.Get(definition, ItemsOfDefinition)
    : GetPart21Value(this->Entities.File.GetParameters(definition), ItemsOfDefinition.Simple);
  const STEPCurve<2>* curve = this->Geometry.GetPlaneCurve(ReadGeometryList(this->Entities, items).front());
  if (!curve)
  {
    throw STEPGeometryFailure{ "its curve in the parameters is left out" };
  }
  std::string problem;
  const STEPCurve<2> natural = this->Geometry.MapToNatural(*curve, *surface, problem);
  RequireGeometry(problem);
  STEPCurve<3> result = this->Finish(CurveOnSurface{ surface->Value, natural.Value }, 1.0);
  result.Range = natural.Range;
  result.Parameter = natural.Parameter;
  return result;
}

template class STEPCurveMaker<2>;
template class STEPCurveMaker<3>;
}
