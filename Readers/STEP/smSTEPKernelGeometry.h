/**
 * @file smSTEPKernelGeometry.h
 * @brief Geometry of a STEP file as native values and as the same of OpenCASCADE
 */
#ifndef smSTEPKernelGeometry_h
#define smSTEPKernelGeometry_h

#include "smOCCTFileSurface.h"
#include "smOCCTFootPoint.h"
#include "smSTEPEdges.h"

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include <memory>
#include <string>
#include <unordered_map>

namespace sm
{
/// The geometry of all bodies with the same units. Everything is made once, when it is asked for; what is not
/// made has a row in the ledger. Not thread safe.
class STEPKernelGeometry
{
public:
  using Index = Part21File::Index;

  STEPKernelGeometry(const STEPAttributes& entities, const STEPUnitSizes& units, STEPLedger& ledger);

  struct Surface
  {
    const STEPSurface* Value = nullptr;
    /// The surface as faces have it; null if it has a row.
    Handle(Geom_Surface) Kernel;
    FileSurface Own;
    /// True if Kernel has the opposite normal: for a torus with a negative major radius, of which it has the
    /// positive one, and where one parameter of the file runs backwards.
    bool IsFlipped = false;
    /// For parameter curves that do not agree with their edges.
    std::shared_ptr<const FootPointFinder> Finder;
  };
  const Surface& GetSurface(Index entity);
  /// Returns the curve of an edge, and the range of the edge on it; null if it has a row.
  Handle(Geom_Curve) MakeCurve(Index entity, const STEPEdge& edge, double range[2]);
  /// Returns a finder of closest points on a surface; null for one that is not supported.
  std::shared_ptr<const FootPointFinder> GetFinder(Index surface);
  /// Returns the part of a torus that a DEGENERATE_TOROIDAL_SURFACE selects as a surface of revolution, and
  /// any other surface as it is.
  static Handle(Geom_Surface) TakeSelectedPart(const STEPSurface& value, const Handle(Geom_Surface) & kernel);
  void AddRow(Index entity, const std::string& reason, const char* consequence);

  STEPGeometry Values;
  STEPEdges Edges;
  const STEPUnitSizes Units;

private:
  void MakeKernel(Index entity, Surface& surface);
  Handle(Geom_Curve) GetCurve(const CurvePointer<3>& value);

  const STEPAttributes& Entities;
  STEPLedger& Ledger;
  std::unordered_map<Index, Surface> Surfaces;
  std::unordered_map<const void*, Handle(Geom_Curve)> Curves;
};
}

#endif
