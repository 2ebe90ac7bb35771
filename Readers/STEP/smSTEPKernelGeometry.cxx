#include "smSTEPKernelGeometry.h"

#include "smOCCTAxialProfile.h"
#include "smOCCTFailure.h"
#include "smOCCTMakeGeometry.h"
#include "smSTEPRevolvedConics.h"

#include <GeomConvert.hxx>
#include <GeomConvert_CompCurveToBSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <ShapeCustom_Surface.hxx>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sm
{
namespace
{
/// A trim that is closer to an end of its domain than this, relative to the domain, is there.
constexpr double EndRounding = 1e-12;

/// Parts of a curve meet if their ends are closer than this, in millimetres.
constexpr double JoinTolerance = 1e-6;

/// Makes a part of a closed spline over its seam (STEPEdges) on the periodic spline; null for other curves.
Handle(Geom_Curve) MakePeriodic(const CompositeCurve<3>& parts, double range[2])
{
  const bool isOne = parts.Segments.size() == 2 && parts.Segments[0].Curve == parts.Segments[1].Curve;
  const auto spline = isOne ? Handle(Geom_BSplineCurve)::DownCast(MakeKernelCurve(*parts.Segments[0].Curve))
                            : Handle(Geom_BSplineCurve)();
  if (spline.IsNull() || !spline->IsClosed())
  {
    return {};
  }
  spline->SetPeriodic();
  range[0] = parts.Segments[0].First;
  range[1] = parts.Segments[0].Last + parts.Segments[1].Last - parts.Segments[1].First;
  return Handle(Geom_Curve)(spline);
}

/// Joins the parts of a curve between two of its parameters to one spline with the same points.
Handle(Geom_Curve) Join(const CompositeCurve<3>& parts, double range[2])
{
  GeomConvert_CompCurveToBSplineCurve joined;
  double start = 0.0;
  bool hasParts = false;
  for (const CurveSegment<3>& segment : parts.Segments)
  {
    // A segment runs from First to Last while the parameter of the whole curve grows by its length.
    const double from = std::clamp((range[0] - start) / segment.Length, 0.0, 1.0);
    const double to = std::clamp((range[1] - start) / segment.Length, 0.0, 1.0);
    start += segment.Length;
    if (to - from <= EndRounding)
    {
      continue;
    }
    const double first = segment.First + from * (segment.Last - segment.First);
    const double last = segment.First + to * (segment.Last - segment.First);
    const Handle(Geom_TrimmedCurve) part = new Geom_TrimmedCurve(
      MakeKernelCurve(*segment.Curve), std::min(first, last), std::max(first, last), true, false);
    if (first > last)
    {
      part->Reverse();
    }
    hasParts = true;
    if (!joined.Add(GeomConvert::CurveToBSplineCurve(part), JoinTolerance, true))
    {
      throw std::runtime_error("the parts of its curve do not meet");
    }
  }
  if (!hasParts)
  {
    throw std::runtime_error("its curve has no part between its vertices");
  }
  const Handle(Geom_BSplineCurve) spline = joined.BSplineCurve();
  range[0] = spline->FirstParameter();
  range[1] = spline->LastParameter();
  return Handle(Geom_Curve)(spline);
}
}

STEPKernelGeometry::STEPKernelGeometry(
  const STEPAttributes& entities, const STEPUnitSizes& units, STEPLedger& ledger)
  : Values(entities, units, ledger)
  , Edges(entities, units, this->Values, ledger)
  , Units(units)
  , Entities(entities)
  , Ledger(ledger)
{
}

const STEPKernelGeometry::Surface& STEPKernelGeometry::GetSurface(Index entity)
{
  const auto [found, isNew] = this->Surfaces.try_emplace(entity);
  Surface& surface = found->second;
  surface.Value = isNew ? this->Values.GetSurface(entity) : surface.Value;
  if (isNew && surface.Value)
  {
    const std::string failure = CatchFailure([&] { this->MakeKernel(entity, surface); });
    if (!failure.empty())
    {
      surface.Kernel.Nullify();
      this->AddRow(entity, failure, "faces on it are missing");
    }
  }
  return surface;
}

Handle(Geom_Curve) STEPKernelGeometry::MakeCurve(Index entity, const STEPEdge& edge, double range[2])
{
  range[0] = edge.First;
  range[1] = edge.Last;
  Handle(Geom_Curve) curve;
  const std::string failure = CatchFailure(
    [&]
    {
      const auto* parts = edge.Curve->GetIf<CompositeCurve<3>>();
      curve = parts ? MakePeriodic(*parts, range) : this->GetCurve(edge.Curve);
      curve = curve.IsNull() ? Join(*parts, range) : curve;
    });
  if (!failure.empty())
  {
    this->AddRow(entity, failure, "faces that it bounds are missing");
    return {};
  }
  return curve;
}

std::shared_ptr<const FootPointFinder> STEPKernelGeometry::GetFinder(Index entity)
{
  Surface& surface = this->Surfaces[entity];
  if (!surface.Finder)
  {
    CatchFailure([&] { surface.Finder = FootPointFinder::Make(GetBasisSurface(surface.Kernel)); });
  }
  return surface.Finder;
}

void STEPKernelGeometry::AddRow(Index entity, const std::string& reason, const char* consequence)
{
  const Part21File& file = this->Entities.File;
  this->Ledger.Rows.push_back(
    { file.GetId(entity), file.GetTypeNames()[file.GetType(entity)], reason, consequence });
}

Handle(Geom_Surface) STEPKernelGeometry::TakeSelectedPart(
  const STEPSurface& value, const Handle(Geom_Surface) & kernel)
{
  const auto torus = Handle(Geom_ToroidalSurface)::DownCast(kernel);
  const auto* elementary = value.Value->GetIf<ElementarySurface>();
  if (torus.IsNull() || !elementary || elementary->Selected == ElementarySurface::Part::Whole ||
    !(torus->MinorRadius() > torus->MajorRadius()))
  {
    return kernel;
  }
  const auto whole = RevolveTorus(torus);
  const ParameterRange& part = value.Value->GetDomain(1);
  return new Geom_SurfaceOfRevolution(
    new Geom_TrimmedCurve(whole->BasisCurve(), part.Low, part.High, true, false), whole->Axis());
}

void STEPKernelGeometry::MakeKernel(Index entity, Surface& surface)
{
  const STEPSurface& value = *surface.Value;
  const auto* torus = value.Value->GetIf<ElementarySurface>();
  if (torus && torus->Radii[0] < 0.0)
  {
    ElementarySurface positive = *torus;
    positive.Radii[0] = -positive.Radii[0];
    std::string problem;
    surface.IsFlipped = true;
    surface.Kernel = MakeKernelSurface(*GeometricSurface::Make(positive, problem));
    return;
  }
  surface.IsFlipped = value.IsReversed();
  surface.Kernel = MakeKernelSurface(*value.Value);
  ParameterRange turn;
  if (FindRevolvedRange(this->Entities, this->Values, entity, value, turn))
  {
    const auto revolved = Handle(Geom_SurfaceOfRevolution)::DownCast(surface.Kernel);
    const Handle(Geom_Curve) profile = MakeKernelCurve(*value.Value->GetIf<RevolvedSurface>()->Profile);
    surface.Kernel = new Geom_SurfaceOfRevolution(
      new Geom_TrimmedCurve(profile, turn.Low, turn.High, true, false), revolved->Axis());
    return;
  }
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface.Kernel))
  {
    // OpenCASCADE may change the surface that it is given.
    const auto own = Handle(Geom_BSplineSurface)::DownCast(spline->Copy());
    const auto periodic =
      Handle(Geom_BSplineSurface)::DownCast(ShapeCustom_Surface(spline).ConvertToPeriodic(false));
    if (!periodic.IsNull())
    {
      surface.Own = CompareSurfaces(own, periodic);
      surface.Kernel = periodic;
    }
  }
  ParameterRange trims[2];
  bool isTrimmed = false;
  for (int d = 0; d < 2; ++d)
  {
    const ParameterRange& domain = value.Value->GetDomain(d);
    trims[d] = value.Range[d];
    // The numbers of the file may lie beyond the ends by their rounding.
    const double width = domain.High - domain.Low;
    const double slack = std::isfinite(width) ? EndRounding * width : 0.0;
    trims[d].Low = std::abs(trims[d].Low - domain.Low) <= slack ? domain.Low : trims[d].Low;
    trims[d].High = std::abs(trims[d].High - domain.High) <= slack ? domain.High : trims[d].High;
    isTrimmed = isTrimmed || trims[d].Low != domain.Low || trims[d].High != domain.High;
  }
  if (isTrimmed)
  {
    surface.Kernel = new Geom_RectangularTrimmedSurface(
      surface.Kernel, trims[0].Low, trims[0].High, trims[1].Low, trims[1].High);
  }
}

Handle(Geom_Curve) STEPKernelGeometry::GetCurve(const CurvePointer<3>& value)
{
  Handle(Geom_Curve)& curve = this->Curves[value.get()];
  if (curve.IsNull())
  {
    curve = MakeKernelCurve(*value);
  }
  return curve;
}
}
