#include "smOCCTCompatibility.h"

#include <StepToGeom.hxx>
#if __has_include(<StepData_Factors.hxx>)
#include <StepData_Factors.hxx>
#else
#include <StepData_GlobalFactors.hxx>
#endif

#include <cstring>
#include <type_traits>
#include <utility>

#if !__has_include(<XSAlgo_ShapeProcessor.hxx>)
#include <BRep_Builder.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeProcess_ShapeContext.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapIteratorOfDataMapOfShapeShape.hxx>
#include <TopoDS_Shell.hxx>
#include <XSAlgo.hxx>
#include <XSAlgo_AlgoContainer.hxx>
#endif

namespace sm
{
#if __has_include(<StepVisual_TessellatedSolid.hxx>)
const bool KernelReadsTessellations = true;
#else
const bool KernelReadsTessellations = false;
#endif

#if __has_include(<StepData_Factors.hxx>)
Handle(Geom_Surface) MakeEntitySurface(const Handle(StepGeom_Surface) & entity)
{
  return StepToGeom::MakeSurface(entity, StepData_Factors());
}

namespace
{
StepData_Factors MakeFactors(double angle)
{
  StepData_Factors factors;
  factors.InitializeFactors(1.0, angle, 1.0);
  return factors;
}
}

EntityGeometry::EntityGeometry(double angle)
  : Angle(angle)
{
}

EntityGeometry::~EntityGeometry() = default;

Handle(Geom_Surface) EntityGeometry::MakeSurface(const Handle(StepGeom_Surface) & entity) const
{
  return StepToGeom::MakeSurface(entity, MakeFactors(this->Angle));
}

Handle(Geom_Curve) EntityGeometry::MakeCurve(const Handle(StepGeom_Curve) & entity) const
{
  return StepToGeom::MakeCurve(entity, MakeFactors(this->Angle));
}

Handle(Geom2d_Curve) EntityGeometry::MakePlaneCurve(const Handle(StepGeom_Curve) & entity) const
{
  return StepToGeom::MakeCurve2d(entity, MakeFactors(this->Angle));
}

STEPConstruct_UnitContext GetUnitFactors(const Handle(StepRepr_GlobalUnitAssignedContext) & context)
{
  STEPConstruct_UnitContext factors;
  factors.ComputeFactors(context, StepData_Factors());
  return factors;
}
#else
Handle(Geom_Surface) MakeEntitySurface(const Handle(StepGeom_Surface) & entity)
{
  return StepToGeom::MakeSurface(entity);
}

EntityGeometry::EntityGeometry(double angle)
{
  StepData_GlobalFactors& factors = StepData_GlobalFactors::Intance();
  this->Length = factors.LengthFactor();
  this->Angle = factors.PlaneAngleFactor();
  this->SolidAngle = factors.SolidAngleFactor();
  factors.InitializeFactors(1.0, angle, 1.0);
}

EntityGeometry::~EntityGeometry()
{
  StepData_GlobalFactors::Intance().InitializeFactors(this->Length, this->Angle, this->SolidAngle);
}

Handle(Geom_Surface) EntityGeometry::MakeSurface(const Handle(StepGeom_Surface) & entity) const
{
  return StepToGeom::MakeSurface(entity);
}

Handle(Geom_Curve) EntityGeometry::MakeCurve(const Handle(StepGeom_Curve) & entity) const
{
  return StepToGeom::MakeCurve(entity);
}

Handle(Geom2d_Curve) EntityGeometry::MakePlaneCurve(const Handle(StepGeom_Curve) & entity) const
{
  return StepToGeom::MakeCurve2d(entity);
}

STEPConstruct_UnitContext GetUnitFactors(const Handle(StepRepr_GlobalUnitAssignedContext) & context)
{
  STEPConstruct_UnitContext factors;
  factors.ComputeFactors(context);
  return factors;
}
#endif

#if __has_include(<XSAlgo_ShapeProcessor.hxx>)
TransferFilter::TransferFilter(Callback) {}

TransferFilter::~TransferFilter() = default;

TopoDS_Shape RepairTransferred(const TopoDS_Shape& shape, double, double, ShapeChanges&)
{
  return shape;
}
#else
namespace
{
/// From 7.8 on ProcessShape() has an additional parameter. The trailing parameters (`Last`) are forwarded.
template <typename... Last>
class FilteringContainer : public XSAlgo_AlgoContainer
{
public:
  explicit FilteringContainer(TransferFilter::Callback isSound)
    : IsSound(std::move(isSound))
  {
  }

  TopoDS_Shape ProcessShape(const TopoDS_Shape& original, Standard_Real precision, Standard_Real maximum,
    Standard_CString resource, Standard_CString sequence, Handle(Standard_Transient) & info,
    const Message_ProgressRange& progress, Standard_Boolean nonManifold, Last... last) const override
  {
    Handle(Standard_Transient) changes;
    const FaceRepair repair = [&](const TopoDS_Shape& whole, const std::vector<TopoDS_Shape>& faces,
                                std::vector<TopoDS_Shape>& repaired)
    {
      const Handle(ShapeBuild_ReShape) substitution = new ShapeBuild_ReShape();
      for (const TopoDS_Shape& face : faces)
      {
        // By itself a face would be repaired with other settings than in a shell.
        TopoDS_Shell shell;
        BRep_Builder().MakeShell(shell);
        BRep_Builder().Add(shell, substitution->Apply(face));
        // A context made there would not record vertices.
        const Handle(ShapeProcess_ShapeContext) context = new ShapeProcess_ShapeContext(shell, resource);
        context->SetDetalisation(TopAbs_VERTEX);
        Handle(Standard_Transient) own(context);
        this->XSAlgo_AlgoContainer::ProcessShape(
          shell, precision, maximum, resource, sequence, own, Message_ProgressRange(), false, last...);
        for (TopTools_DataMapIteratorOfDataMapOfShapeShape it(context->Map()); it.More(); it.Next())
        {
          if (it.Key().ShapeType() > TopAbs_SHELL && !it.Value().IsNull())
          {
            substitution->Replace(it.Key(), it.Value());
          }
        }
      }
      const TopoDS_Shape result = substitution->Apply(whole);
      for (const TopoDS_Shape& face : faces)
      {
        for (TopExp_Explorer it(substitution->Apply(face), TopAbs_FACE); it.More(); it.Next())
        {
          repaired.push_back(it.Current());
        }
      }
      const Handle(ShapeProcess_ShapeContext) context = new ShapeProcess_ShapeContext(whole, resource);
      context->SetDetalisation(TopAbs_EDGE);
      context->RecordModification(substitution);
      changes = context;
      return result;
    };
    TopoDS_Shape shape = original;
    if (!nonManifold && std::strncmp(sequence, "read.", 5) == 0 && this->IsSound(shape, repair))
    {
      info = changes;
      return shape;
    }
    return this->XSAlgo_AlgoContainer::ProcessShape(
      original, precision, maximum, resource, sequence, info, progress, nonManifold, last...);
  }

private:
  TransferFilter::Callback IsSound;
};

/// Makes a container whose ProcessShape() has the parameters of the given method.
template <typename... Last>
Handle(XSAlgo_AlgoContainer)
  MakeContainer(TopoDS_Shape (XSAlgo_AlgoContainer::*)(const TopoDS_Shape&, Standard_Real, Standard_Real,
                  Standard_CString, Standard_CString, Handle(Standard_Transient) &,
                  const Message_ProgressRange&, Standard_Boolean, Last...) const,
    TransferFilter::Callback isSound)
{
  return new FilteringContainer<Last...>(std::move(isSound));
}
}

TransferFilter::TransferFilter(Callback isSound)
  : Previous(XSAlgo::AlgoContainer())
{
  XSAlgo::SetAlgoContainer(MakeContainer(&XSAlgo_AlgoContainer::ProcessShape, std::move(isSound)));
}

TransferFilter::~TransferFilter()
{
  XSAlgo::SetAlgoContainer(Handle(XSAlgo_AlgoContainer)::DownCast(this->Previous));
}

namespace
{
constexpr const char* RepairResource = "read.step.resource.name";
constexpr const char* RepairSequence = "read.step.sequence";

template <typename... Last>
TopoDS_Shape Process(TopoDS_Shape (XSAlgo_AlgoContainer::*method)(const TopoDS_Shape&, Standard_Real,
                       Standard_Real, Standard_CString, Standard_CString, Handle(Standard_Transient) &,
                       const Message_ProgressRange&, Standard_Boolean, Last...) const,
  const TopoDS_Shape& shape, double precision, double maximum, Handle(Standard_Transient) & info)
{
  return ((*XSAlgo::AlgoContainer()).*method)(shape, precision, maximum, RepairResource, RepairSequence, info,
    Message_ProgressRange(), false, std::decay_t<Last>()...);
}
}

TopoDS_Shape RepairTransferred(
  const TopoDS_Shape& shape, double precision, double maximum, ShapeChanges& changes)
{
  Handle(Standard_Transient) info;
  const TopoDS_Shape result = Process(&XSAlgo_AlgoContainer::ProcessShape, shape, precision, maximum, info);
  changes = [info](const std::function<void(const TopoDS_Shape&, const TopoDS_Shape&)>& visit)
  {
    const auto context = Handle(ShapeProcess_ShapeContext)::DownCast(info);
    if (context.IsNull())
    {
      return;
    }
    for (TopTools_DataMapIteratorOfDataMapOfShapeShape it(context->Map()); it.More(); it.Next())
    {
      visit(it.Key(), it.Value());
    }
  };
  return result;
}
#endif
}
