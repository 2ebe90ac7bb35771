/**
 * @file smSTEPTrims.h
 * @brief Parameter curves of a STEP file on the edges of OpenCASCADE's faces
 */
#ifndef smSTEPTrims_h
#define smSTEPTrims_h

#include "smSTEPKernelGeometry.h"
#include "smSTEPParameterCurves.h"

#include <BRep_Builder.hxx>
#include <Geom2d_Curve.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <vector>

namespace sm
{
/// A parameter curve of an edge on a surface.
struct STEPTrim
{
  Handle(Geom2d_Curve) Curve;
  double Range[2];
  /// Largest distance from the edge's curve at some points.
  double Distance = 0.0;
};

/// Adds the parameter curves that a file has of edges on surfaces, where they agree with the edges' curves as
/// far as the file is accurate, and the surface is no plane.
class STEPTrims
{
public:
  using Index = Part21File::Index;

  /// Keeps references. `precision` is the file's accuracy in millimetres. Curves that do not agree are
  /// appended to `others`.
  STEPTrims(const STEPAttributes& entities, STEPKernelGeometry& geometry, double precision,
    std::vector<STEPParameterCurve>& others)
    : Entities(entities)
    , Shared(geometry)
    , Precision(precision)
    , Others(others)
  {
  }

  /// Adds those of an edge on the surface of a face. An edge that its loop uses twice, `count`, needs two.
  void Add(Index entity, int count, Index surfaceEntity, const TopoDS_Edge& edge, const TopoDS_Face& face);

private:
  bool Read(Index pcurve, Index entity, Index surfaceEntity, const TopoDS_Edge& edge, STEPTrim& trim);
  Index FindSpaceCurve(Index curve) const;

  const STEPAttributes& Entities;
  STEPKernelGeometry& Shared;
  double Precision;
  std::vector<STEPParameterCurve>& Others;
  BRep_Builder Builder;
};
}

#endif
