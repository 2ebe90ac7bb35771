#include "smOCCTModel.h"

#include "smFormat.h"
#include "smLengthUnits.h"
#include "smOCCTCompatibility.h"

#include <StepBasic_ConversionBasedUnitAndLengthUnit.hxx>
#include <StepBasic_HArray1OfNamedUnit.hxx>
#include <StepBasic_SiUnitAndLengthUnit.hxx>
#include <StepGeom_BSplineCurveWithKnots.hxx>
#include <StepGeom_BSplineCurveWithKnotsAndRationalBSplineCurve.hxx>
#include <StepGeom_BezierCurveAndRationalBSplineCurve.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <StepGeom_CartesianTransformationOperator3d.hxx>
#include <StepGeom_Direction.hxx>
#include <StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx.hxx>
#include <StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext.hxx>
#include <StepGeom_QuasiUniformCurveAndRationalBSplineCurve.hxx>
#include <StepGeom_UniformCurve.hxx>
#include <StepGeom_UniformCurveAndRationalBSplineCurve.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <StepShape_FaceSurface.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <gp_Dir.hxx>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace sm
{
namespace
{
std::string GetUnitName(const Handle(StepBasic_NamedUnit) & unit)
{
  if (const auto converted = Handle(StepBasic_ConversionBasedUnitAndLengthUnit)::DownCast(unit))
  {
    return converted->Name().IsNull() ? std::string() : converted->Name()->ToCString();
  }
  const auto si = Handle(StepBasic_SiUnitAndLengthUnit)::DownCast(unit);
  if (si.IsNull() || si->Name() != StepBasic_sunMetre)
  {
    return {};
  }
  if (!si->HasPrefix())
  {
    return "metre";
  }
  switch (si->Prefix())
  {
    case StepBasic_spKilo:
      return "kilometre";
    case StepBasic_spDeci:
      return "decimetre";
    case StepBasic_spCenti:
      return "centimetre";
    case StepBasic_spMilli:
      return "millimetre";
    case StepBasic_spMicro:
      return "micrometre";
    default:
      return {};
  }
}

using CertainUnits = StepGeom_GeomRepContextAndGlobUnitAssCtxAndGlobUncertaintyAssCtx;
using PlainUnits = StepGeom_GeometricRepresentationContextAndGlobalUnitAssignedContext;

/// Returns the positions of the contexts that assign units.
std::vector<int> FindContexts(const ModelEntities& entities)
{
  return entities.Find({ STANDARD_TYPE(CertainUnits), STANDARD_TYPE(PlainUnits) });
}

/// Returns the part of such a context that assigns units.
Handle(StepRepr_GlobalUnitAssignedContext) GetUnits(const Handle(Standard_Transient) & entity)
{
  const auto certain = Handle(CertainUnits)::DownCast(entity);
  const auto plain = Handle(PlainUnits)::DownCast(entity);
  return !certain.IsNull() ? certain->GlobalUnitAssignedContext()
    : !plain.IsNull()      ? plain->GlobalUnitAssignedContext()
                           : nullptr;
}

/// Returns the length unit of the first context that has one. OpenCASCADE only considers contexts that belong
/// to products.
std::string FindUnitInContexts(const ModelEntities& entities)
{
  for (const int i : FindContexts(entities))
  {
    const Handle(StepRepr_GlobalUnitAssignedContext) context = GetUnits(entities.GetModel()->Value(i));
    for (int k = 1; !context.IsNull() && !context->Units().IsNull() && k <= context->NbUnits(); ++k)
    {
      const std::string name = GetUnitName(context->UnitsValue(k));
      if (!name.empty())
      {
        return name;
      }
    }
  }
  return {};
}

bool GetDirection(const Handle(StepGeom_Direction) & entity, gp_XYZ& direction)
{
  if (entity.IsNull() || entity->NbDirectionRatios() != 3)
  {
    return false;
  }
  direction =
    gp_XYZ(entity->DirectionRatiosValue(1), entity->DirectionRatiosValue(2), entity->DirectionRatiosValue(3));
  return true;
}

/// Returns the weights of a rational spline, or null.
Handle(TColStd_HArray1OfReal) GetWeights(const Handle(StepGeom_BSplineCurve) & curve)
{
  if (const auto a = Handle(StepGeom_BSplineCurveWithKnotsAndRationalBSplineCurve)::DownCast(curve))
  {
    return a->WeightsData();
  }
  if (const auto b = Handle(StepGeom_QuasiUniformCurveAndRationalBSplineCurve)::DownCast(curve))
  {
    return b->WeightsData();
  }
  if (const auto c = Handle(StepGeom_UniformCurveAndRationalBSplineCurve)::DownCast(curve))
  {
    return c->WeightsData();
  }
  const auto bezier = Handle(StepGeom_BezierCurveAndRationalBSplineCurve)::DownCast(curve);
  return bezier.IsNull() ? nullptr : bezier->WeightsData();
}

/// Returns the multiplicity of the knot at the start of the spline's domain, at most its degree.
int GetStartMultiplicity(const Handle(StepGeom_BSplineCurve) & curve)
{
  auto knots = Handle(StepGeom_BSplineCurveWithKnots)::DownCast(curve);
  if (const auto rational = Handle(StepGeom_BSplineCurveWithKnotsAndRationalBSplineCurve)::DownCast(curve))
  {
    knots = rational->BSplineCurveWithKnots();
  }
  if (knots.IsNull() || knots->KnotMultiplicities().IsNull())
  {
    const bool isUniform = curve->IsKind(STANDARD_TYPE(StepGeom_UniformCurve)) ||
      curve->IsKind(STANDARD_TYPE(StepGeom_UniformCurveAndRationalBSplineCurve));
    return isUniform ? 1 : curve->Degree();
  }
  int sum = 0;
  for (int i = 1; i <= knots->NbKnotMultiplicities(); ++i)
  {
    sum += knots->KnotMultiplicitiesValue(i);
    if (sum > curve->Degree())
    {
      return std::min(knots->KnotMultiplicitiesValue(i), curve->Degree());
    }
  }
  return 1;
}

/// Returns true if the control points and weights at the end are those at the start: one for each degree of
/// continuity, and one more.
bool IsClosedByRows(const Handle(StepGeom_BSplineCurve) & curve)
{
  const int count = curve->ControlPointsList().IsNull() ? 0 : curve->NbControlPointsList();
  const int rows = curve->Degree() + 1 - GetStartMultiplicity(curve);
  const Handle(TColStd_HArray1OfReal) weights = GetWeights(curve);
  if (rows < 1 || count <= rows || (!weights.IsNull() && weights->Length() != count))
  {
    return false;
  }
  for (int i = 1; i <= rows; ++i)
  {
    const Handle(StepGeom_CartesianPoint) first = curve->ControlPointsListValue(i);
    const Handle(StepGeom_CartesianPoint) last = curve->ControlPointsListValue(count - rows + i);
    if (first.IsNull() || last.IsNull() || first->NbCoordinates() != last->NbCoordinates())
    {
      return false;
    }
    bool isSame = weights.IsNull() || weights->Value(i) == weights->Value(count - rows + i);
    for (int c = 1; c <= first->NbCoordinates(); ++c)
    {
      isSame = isSame && first->CoordinatesValue(c) == last->CoordinatesValue(c);
    }
    if (!isSame)
    {
      return false;
    }
  }
  return true;
}
}

std::string ReadLengthUnit(
  STEPControl_Reader& reader, const ModelEntities& entities, std::vector<std::string>& messages)
{
  TColStd_SequenceOfAsciiString lengths;
  TColStd_SequenceOfAsciiString angles;
  TColStd_SequenceOfAsciiString solidAngles;
  reader.FileUnits(lengths, angles, solidAngles);
  std::string unit = lengths.IsEmpty() ? std::string() : lengths.First().ToCString();
  for (const TCollection_AsciiString& name : lengths)
  {
    if (GetUnitInMillimetres(name.ToCString()) != GetUnitInMillimetres(unit))
    {
      messages.push_back("The file mixes length units (" + unit + ", " + name.ToCString() +
        "); each part was read in its own.");
      break;
    }
  }
  return unit.empty() ? FindUnitInContexts(entities) : unit;
}

void CompareUnits(const ModelEntities& entities, const std::vector<CensusContext>& contexts,
  std::vector<std::string>& defects)
{
  // Products of factors in another order.
  constexpr double rounding = 1e-14;
  std::unordered_map<std::uint64_t, const CensusContext*> known;
  for (const CensusContext& context : contexts)
  {
    known.emplace(context.Id, &context);
  }
  const Handle(StepData_StepModel)& model = entities.GetModel();
  for (const int i : FindContexts(entities))
  {
    const Handle(StepRepr_GlobalUnitAssignedContext) units = GetUnits(model->Value(i));
    const auto found = units.IsNull() || units->Units().IsNull()
      ? known.end()
      : known.find(static_cast<std::uint64_t>(model->IdentLabel(model->Value(i))));
    if (found == known.end())
    {
      continue;
    }
    const CensusContext* stated = found->second;
    const STEPConstruct_UnitContext taken = GetUnitFactors(units);
    const std::pair<const CensusUnit*, double> kinds[] = { { &stated->Length, taken.LengthFactor() },
      { &stated->Angle, taken.PlaneAngleFactor() } };
    for (const auto& [unit, factor] : kinds)
    {
      if (unit->Status == CensusUnit::State::Stated &&
        std::abs(factor - unit->Factor) > rounding * unit->Factor)
      {
        const std::string si = unit == &stated->Length ? " mm" : " radians";
        defects.push_back("Unit #" + std::to_string(unit->Id) + " of the file (" + unit->Name + ") is " +
          FormatDigits(unit->Factor, 10) + si + ", but OpenCASCADE takes " + FormatDigits(factor, 10) + si +
          " for it: sizes and places are wrong. Export the file in " +
          (unit == &stated->Length ? "millimetres." : "radians."));
      }
    }
  }
}

std::vector<Handle(Standard_Transient)> CheckOperators(
  const ModelEntities& entities, std::vector<std::string>& messages)
{
  std::vector<Handle(Standard_Transient)> dropped;
  int first = 0;
  const auto check = [&](const Handle(StepGeom_CartesianTransformationOperator3d) & item)
  {
    if (item->LocalOrigin().IsNull())
    {
      const Handle(StepGeom_CartesianPoint) origin = new StepGeom_CartesianPoint();
      origin->Init3D(new TCollection_HAsciiString(""), 0.0, 0.0, 0.0);
      item->SetLocalOrigin(origin);
    }
    gp_XYZ x;
    gp_XYZ y;
    gp_XYZ z;
    const bool mirrored = GetDirection(item->Axis1(), x) && GetDirection(item->Axis2(), y) &&
      GetDirection(item->Axis3(), z) && x.Crossed(y).Dot(z) < 0.0;
    if (mirrored || (item->HasScale() && std::abs(item->Scale() - 1.0) > 1e-12))
    {
      dropped.push_back(item);
      first = first > 0 ? first : entities.GetModel()->IdentLabel(item);
    }
  };
  entities.ForEach<StepGeom_CartesianTransformationOperator3d>(check);
  if (!dropped.empty())
  {
    messages.push_back(std::to_string(dropped.size()) +
      " instances are scaled or mirrored by a transformation operator (first: #" + std::to_string(first) +
      "), which OpenCASCADE ignores: they are placed but neither scaled nor mirrored. Export the assembly "
      "flattened.");
  }
  return dropped;
}

void ClearClosedFlags(const ModelEntities& entities)
{
  entities.ForEach<StepGeom_BSplineCurve>(
    [](const Handle(StepGeom_BSplineCurve) & curve)
    {
      if (curve->ClosedCurve() != StepData_LFalse && !IsClosedByRows(curve))
      {
        curve->SetClosedCurve(StepData_LFalse);
      }
    });
}

bool HasGeometry(const ModelEntities& entities)
{
  return !entities.Find({ STANDARD_TYPE(StepShape_FaceSurface) }).empty();
}
}
