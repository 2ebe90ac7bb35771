/**
 * @file smSTEPTrims.h
 * @brief Parameter curves of a STEP file on the edges of its faces
 */
#ifndef smSTEPTrims_h
#define smSTEPTrims_h

#include "Shapes/smShape.h"
#include "smSTEPBodyGeometry.h"
#include "smSTEPParameterCurves.h"

#include <vector>

namespace sm
{
/// A parameter curve of an edge on a surface.
struct STEPTrim
{
  CurvePointer<2> Curve;
  double Range[2] = { 0.0, 0.0 };
  /// Largest distance from the edge's curve at some points.
  double Distance = 0.0;
};

/// Adds the parameter curves that a file has of edges on surfaces, where they agree with the edges' curves as
/// far as the file is accurate, and the surface is not a plane.
class STEPTrims
{
public:
  using Index = Part21File::Index;

  /// Keeps references. `precision` is the file's accuracy in millimetres. Curves that do not agree are
  /// appended to `others`.
  STEPTrims(const STEPAttributes& entities, STEPBodyGeometry& geometry, double precision,
    std::vector<STEPParameterCurve>& others)
    : Entities(entities)
    , Shared(geometry)
    , Precision(precision)
    , Others(others)
  {
  }

  /// Adds that of the edge of `use` on the surface of its face. An edge that its loop uses twice, `count`,
  /// needs two.
  void Add(Index entity, int count, Index surfaceEntity, CoedgeShape& use);

private:
  bool Read(Index pcurve, Index entity, Index surfaceEntity, const EdgeShape& edge, STEPTrim& trim);
  Index FindSpaceCurve(Index curve) const;

  const STEPAttributes& Entities;
  STEPBodyGeometry& Shared;
  double Precision;
  std::vector<STEPParameterCurve>& Others;
};
}

#endif
