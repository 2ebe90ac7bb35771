#include "smEntityGeometry.h"

#include <StepToGeom.hxx>
#if __has_include(<StepData_Factors.hxx>)
#include <StepData_Factors.hxx>
#else
#include <StepData_GlobalFactors.hxx>
#endif

namespace sm
{
#if __has_include(<StepData_Factors.hxx>)
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
#else
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
#endif
}
