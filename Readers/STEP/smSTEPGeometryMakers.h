/**
 * @file smSTEPGeometryMakers.h
 * @brief Makes native values of single entities of a STEP file
 */
#ifndef smSTEPGeometryMakers_h
#define smSTEPGeometryMakers_h

#include "smSTEPGeometry.h"
#include "smSTEPGeometryReading.h"

namespace sm
{
/// Makes curves in space or in the parameters of a surface. Make() throws STEPGeometryFailure.
template <int Dimension>
class STEPCurveMaker
{
public:
  using Index = Part21File::Index;
  using Point = std::array<double, Dimension>;

  explicit STEPCurveMaker(STEPGeometry& geometry);

  STEPCurve<Dimension> Make(Index entity);

private:
  using Method = STEPCurve<Dimension> (STEPCurveMaker::*)(Index);

  STEPCurve<Dimension> MakeLine(Index entity);
  STEPCurve<Dimension> MakeConic(Index entity);
  STEPCurve<Dimension> MakePolyline(Index entity);
  STEPCurve<Dimension> MakeSpline(Index entity);
  STEPCurve<Dimension> MakeTrimmed(Index entity);
  STEPCurve<Dimension> MakeComposite(Index entity);
  STEPCurve<Dimension> MakeOffset(Index entity);
  STEPCurve<Dimension> MakeReplica(Index entity);
  STEPCurve<Dimension> MakeSurfaceCurve(Index entity);
  STEPCurve<Dimension> MakePcurve(Index entity);

  STEPCurve<Dimension> Finish(typename GeometricCurve<Dimension>::Variant value, double scale) const;
  std::vector<Point> ReadPoints(const Part21Value& list) const;
  /// Finds one end of a TRIMMED_CURVE as a natural parameter of its basis.
  double ReadTrim(Index entity, const STEPAttribute& trim, const STEPCurve<Dimension>& basis) const;
  CurveSegment<Dimension> MakeSegment(Index entity);
  const STEPCurve<Dimension>& Require(const Part21Value& value);

  STEPGeometry& Geometry;
  const STEPAttributes& Entities;
  /// Factor of lengths: 1 in the parameters of a surface.
  double Length;
};

/// The same for surfaces.
class STEPSurfaceMaker
{
public:
  using Index = Part21File::Index;

  explicit STEPSurfaceMaker(STEPGeometry& geometry);

  STEPSurface Make(Index entity);

private:
  using Method = STEPSurface (STEPSurfaceMaker::*)(Index);

  STEPSurface MakeElementary(Index entity);
  STEPSurface MakeExtruded(Index entity);
  STEPSurface MakeRevolved(Index entity);
  STEPSurface MakeSpline(Index entity);
  STEPSurface MakeTrimmed(Index entity);
  STEPSurface MakeBounded(Index entity);
  STEPSurface MakeOffset(Index entity);
  STEPSurface MakeReplica(Index entity);

  STEPSurface Finish(GeometricSurface::Variant value) const;
  const STEPCurve<3>& RequireCurve(const Part21Value& value);
  const STEPSurface& RequireSurface(const Part21Value& value);

  STEPGeometry& Geometry;
  const STEPAttributes& Entities;
  const STEPUnitSizes& Units;
};
}

#endif
