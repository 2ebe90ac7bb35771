/**
 * @file smEntityGeometry.h
 * @brief OpenCASCADE's conversion of STEP entities, the oracle of ours, for all its versions (7.6 to 8.0)
 */
#ifndef smEntityGeometry_h
#define smEntityGeometry_h

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <StepGeom_Curve.hxx>
#include <StepGeom_Surface.hxx>

namespace sm
{
/// Makes geometry of entities in their own unit of length, during the lifetime of this object, which changes
/// global settings of OpenCASCADE. `angle` is the file's unit of angles in radians.
class EntityGeometry
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
}

#endif
