/**
 * @file smOCCTCompatibility.h
 * @brief Differences between versions of OpenCASCADE (7.6 to 8.0), found by the headers that exist and by the
 * compiler
 */
#ifndef smOCCTCompatibility_h
#define smOCCTCompatibility_h

#include "smReadersSTEPModule.h"

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <Standard_Transient.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_Surface.hxx>
#include <StepRepr_GlobalUnitAssignedContext.hxx>
#include <TopoDS_Shape.hxx>

#include <functional>
#include <vector>

namespace sm
{
/// True from OpenCASCADE 7.7 on, which reads the entities of tessellated shapes. Earlier versions do not know
/// their types, and take time quadratic in their number.
extern const bool KernelReadsTessellations;

/// Returns the surface of an entity; its lengths are converted as in the running transfer before 7.8, and not
/// at all from then on.
Handle(Geom_Surface) MakeEntitySurface(const Handle(StepGeom_Surface) & entity);

/// Makes geometry of entities in their own unit of length, during the lifetime of this object, which changes
/// global settings of OpenCASCADE. `angle` is the file's unit of angles in radians.
class SMREADERSSTEP_EXPORT EntityGeometry
{
public:
  explicit EntityGeometry(double angle);
  ~EntityGeometry();
  EntityGeometry(const EntityGeometry&) = delete;
  void operator=(const EntityGeometry&) = delete;

  Handle(Geom_Surface) MakeSurface(const Handle(StepGeom_Surface) & entity) const;
  Handle(Geom_Curve) MakeCurve(const Handle(StepGeom_Curve) & entity) const;
  /// Makes a curve in the plane; its coordinates are those of the file.
  Handle(Geom2d_Curve) MakePlaneCurve(const Handle(StepGeom_Curve) & entity) const;

private:
  double Length = 1.0;
  double Angle = 1.0;
  double SolidAngle = 1.0;
};

/// Returns the units, in millimetres and radians, that OpenCASCADE takes for a context.
STEPConstruct_UnitContext GetUnitFactors(const Handle(StepRepr_GlobalUnitAssignedContext) & context);

/// Repairs some faces of a shape as OpenCASCADE's repair of the whole shape would, and returns the shape with
/// them; `repaired` gets what became of these faces. The shape given is not changed, apart from what
/// OpenCASCADE adds to edges and vertices of these faces.
using FaceRepair = std::function<TopoDS_Shape(
  const TopoDS_Shape& shape, const std::vector<TopoDS_Shape>& faces, std::vector<TopoDS_Shape>& repaired)>;

/**
 * During the lifetime of this object `isSound` is called for each shape of a STEP transfer before OpenCASCADE
 * repairs it. If it returns true, the shape, which it may exchange or repair in part, is not repaired. The
 * hook is global: hold a KernelSession. From OpenCASCADE 7.9 on it is never called and all shapes are
 * repaired, because the repair is not a virtual function any more.
 */
class TransferFilter
{
public:
  using Callback = std::function<bool(TopoDS_Shape&, const FaceRepair&)>;

  explicit TransferFilter(Callback isSound);
  ~TransferFilter();
  TransferFilter(const TransferFilter&) = delete;
  void operator=(const TransferFilter&) = delete;

private:
  Handle(Standard_Transient) Previous;
};

/// Calls visit(from, to) for each shape that a repair replaced.
using ShapeChanges =
  std::function<void(const std::function<void(const TopoDS_Shape&, const TopoDS_Shape&)>&)>;

/// Repairs a shape as the transfer of a STEP file would; the conditions of TransferFilter apply. `precision`
/// and the largest tolerance are in millimetres. From OpenCASCADE 7.9 on the shape is returned as it is.
TopoDS_Shape RepairTransferred(
  const TopoDS_Shape& shape, double precision, double maximum, ShapeChanges& changes);
}

#endif
