#include "smSTEPKernelGeometry.h"

#include "smOCCTFailure.h"
#include "smOCCTMakeGeometry.h"
#include "smSTEPRevolvedConics.h"

#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <ShapeAlgo.hxx>
#include <ShapeAlgo_AlgoContainer.hxx>

#include <stdexcept>

namespace sm
{
namespace
{
/// Makes a part of a closed spline over its seam (STEPEdges) on the periodic spline.
Handle(Geom_Curve) MakePeriodic(const CompositeCurve<3>& parts, double range[2])
{
  const bool isOne = parts.Segments.size() == 2 && parts.Segments[0].Curve == parts.Segments[1].Curve;
  const auto spline = isOne ? Handle(Geom_BSplineCurve)::DownCast(MakeKernelCurve(*parts.Segments[0].Curve))
                            : Handle(Geom_BSplineCurve)();
  if (spline.IsNull() || !spline->IsClosed())
  {
    throw std::runtime_error("its curve has several parts");
  }
  spline->SetPeriodic();
  range[0] = parts.Segments[0].First;
  range[1] = parts.Segments[0].Last + parts.Segments[1].Last - parts.Segments[1].First;
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

void STEPKernelGeometry::MakeKernel(Index entity, Surface& surface)
{
  const STEPSurface& value = *surface.Value;
  if (value.IsReversed())
  {
    throw std::runtime_error("one of its parameters runs backwards");
  }
  const auto* torus = value.Value->GetIf<ElementarySurface>();
  surface.IsFlipped = torus && torus->Radii[0] < 0.0;
  if (surface.IsFlipped)
  {
    ElementarySurface positive = *torus;
    positive.Radii[0] = -positive.Radii[0];
    std::string problem;
    surface.Kernel = MakeKernelSurface(*GeometricSurface::Make(positive, problem));
    return;
  }
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
      Handle(Geom_BSplineSurface)::DownCast(ShapeAlgo::AlgoContainer()->ConvertToPeriodic(spline));
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
