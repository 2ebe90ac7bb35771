/**
 * @file smSTEPBodyGeometry.h
 * @brief Surfaces of a STEP file as its faces need them
 */
#ifndef smSTEPBodyGeometry_h
#define smSTEPBodyGeometry_h

#include "Geometry/smPeriodicSurface.h"
#include "Trims/smFootPoint.h"
#include "smProgressCallback.h"
#include "smSTEPEdges.h"

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace sm
{
/// The geometry of all bodies with the same units. Everything is made once, by Make() or when it is asked
/// for; what is not made has a row in the ledger. Not thread safe.
class STEPBodyGeometry
{
public:
  using Index = Part21File::Index;

  STEPBodyGeometry(const STEPAttributes& entities, const STEPUnitSizes& units, STEPLedger& ledger);

  /// Makes edges and surfaces on all threads; those on the same curve or surface on the same thread. Results
  /// and rows do not depend on the number of threads. Returns false if `shouldContinue` did.
  bool Make(const std::vector<Index>& edges, const std::vector<Index>& surfaces,
    const ContinueCallback& shouldContinue);
  struct Surface
  {
    const STEPSurface* Value = nullptr;
    /// The surface as faces have it; null if it has a row.
    SurfacePointer Native;
    /// Part of it that the file names.
    ParameterRange Range[2];
    FileSurface Own;
    /// True if Native has the opposite normal: for a torus with a negative major radius, of which it has the
    /// positive one, and where one parameter of the file runs backwards.
    bool IsFlipped = false;
    /// For parameter curves that do not agree with their edges.
    std::shared_ptr<const FootPointFinder> Finder;
  };
  const Surface& GetSurface(Index entity);
  /// Returns a finder of closest points on a surface; null for one that is not supported.
  std::shared_ptr<const FootPointFinder> GetFinder(Index surface);
  /// Returns the part of a torus that a DEGENERATE_TOROIDAL_SURFACE selects as a surface of revolution, and
  /// any other surface as it is.
  static SurfacePointer TakeSelectedPart(const Surface& surface);
  void AddRow(Index entity, const std::string& reason, const char* consequence);

  STEPGeometry Values;
  STEPEdges Edges;
  const STEPUnitSizes Units;

private:
  /// What is made: an edge or a surface.
  struct Item
  {
    Index Entity;
    bool IsEdge;
  };
  Index FindBasis(Index entity) const;
  std::vector<std::vector<Item>> Divide(
    const std::vector<Index>& edges, const std::vector<Index>& surfaces) const;
  void MakeNative(Index entity, Surface& surface);
  /// Takes over what the other one has made and this one has not.
  void Take(STEPBodyGeometry& other);

  const STEPAttributes& Entities;
  STEPLedger& Ledger;
  std::unordered_map<Index, Surface> Surfaces;
};
}

#endif
