/**
 * @file smSTEPShapes.h
 * @brief Bodies of a STEP file as shapes, from their entities
 */
#ifndef smSTEPShapes_h
#define smSTEPShapes_h

#include "Shapes/smShape.h"
#include "smFirstOfSeveral.h"
#include "smSTEPAttributes.h"
#include "smSTEPBodyGeometry.h"
#include "smSTEPCensus.h"
#include "smSTEPFaceLoops.h"
#include "smSTEPLedger.h"
#include "smSTEPLoopChecks.h"
#include "smSTEPParameterCurves.h"
#include "smSTEPPerils.h"

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace sm
{
/**
 * Makes the bodies of a file. Every face, edge, vertex, curve and surface is converted, or has a row in the
 * ledger; faces that depend on a row are left out.
 *
 * Faces have the loops of the file: edges on their curves between their vertices, with the parameter curves
 * that the file has on this surface if both ends agree with the edge's within the file's accuracy, and that
 * is not a plane. Vertices closer than STEPEdges::SameVertex at the ends of one edge, or closer than the
 * file's accuracy at neighbouring edges of a loop, are one. Edges of a closed shell that one face uses each
 * and that lie on each other, or on a chain of others, are joined (smSTEPEdgeTwins.h).
 */
class STEPShapes
{
public:
  /// Keeps references to all. Contradictions of loops and vertices become problems of the census.
  STEPShapes(const STEPAttributes& entities, STEPCensus& census, STEPLedger& ledger);
  ~STEPShapes();

  /// Makes the edges and surfaces of bodies on all threads, so that MakeBody() finds them. Returns false if
  /// `shouldContinue` did.
  bool MakeGeometry(const std::vector<const CensusBody*>& bodies, const ContinueCallback& shouldContinue);
  /// Returns a solid, or the shells of a surface model; nothing if no face of it is made.
  ShapeGroup MakeBody(const CensusBody& body);
  /// Numbers of the faces whose surface has the opposite normal (STEPSurface::IsReversed()).
  const std::vector<std::uint64_t>& GetReversedFaces() const { return this->ReversedFaces; }
  /// Reports contradictions within the file that the shapes made so far do not show.
  void Report(std::vector<std::string>& messages, std::vector<std::string>& defects) const;
  /// Returns the accuracy of coordinates that the file states for a body, in millimetres.
  double GetPrecision(const CensusBody& body) const;
  /// The same; 0 if it states none.
  double GetUncertainty(const CensusBody& body) const;

private:
  class BodyShaper;
  using Index = Part21File::Index;

  STEPBodyGeometry& GetGeometry(int context);
  Index GetSurfaceEntity(Index face) const;
  /// Extends the box of the file's edges.
  void Extend(const Vector3& point);

  const STEPAttributes& Entities;
  STEPCensus& Census;
  STEPLedger& Ledger;
  STEPPerils Perils;
  STEPFaceLoops Loops;
  STEPLoopChecks Checks;
  std::unordered_map<int, std::unique_ptr<STEPBodyGeometry>> Geometries;
  Vector3 Low{ 1e300, 1e300, 1e300 };
  Vector3 High{ -1e300, -1e300, -1e300 };
  /// Parameter curves that are farther from their edges than the file is accurate.
  std::vector<STEPParameterCurve> ParameterCurves;
  FirstOfSeveral ShortArcs;
  FirstOfSeveral JoinedEdges;
  FirstOfSeveral LostFaces;
  std::vector<std::string> Defects;
  std::vector<std::uint64_t> ReversedFaces;
};
}

#endif
