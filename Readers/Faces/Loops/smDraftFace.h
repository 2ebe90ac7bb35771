/**
 * @file smDraftFace.h
 * @brief The loops of a face of a file: ordered, continuous in native (u,v), before the conversion
 */
#ifndef smDraftFace_h
#define smDraftFace_h

#include "Shapes/smShape.h"
#include "Trims/smTrimConversion.h"

#include <string>
#include <vector>

namespace sm
{
struct DraftCoedge
{
  /// The edge of the file; null for an added pole or seam.
  const EdgeShape* Edge = nullptr;
  /// Index of the edge in the body, from 0; below 0 for an added pole or seam: -1 - its number in the face.
  /// The curve of such an edge is the image of its trim curve.
  int EdgeIndex = -1;
  bool Reversed = false;
  bool Degenerate = false;
  /// True for a coedge without a pcurve on a plane: its trim curve is the projection of the edge's curve.
  bool Projected = false;
  /// True for a coedge without a pcurve on another surface: its trim curve will be computed from foot points
  /// of the edge's curve.
  bool NeedsFeet = false;
  /// Largest distance between samples of the edge and of the surface along the trim curve; 0 if not measured.
  double EdgeDistance = 0.0;
  /// Largest distance of these samples beyond the border of the surface's domain.
  double Overhang = 0.0;
  NativeTrim Trim;
  /// Vertices at start and end in loop direction; null if the file has none.
  const VertexShape* Start = nullptr;
  const VertexShape* End = nullptr;

  std::array<double, 2> GetStartPoint() const
  {
    return this->Reversed ? this->Trim.GetEnd() : this->Trim.GetStart();
  }
  std::array<double, 2> GetEndPoint() const
  {
    return this->Reversed ? this->Trim.GetStart() : this->Trim.GetEnd();
  }
};
using DraftLoop = std::vector<DraftCoedge>;

struct DraftFace
{
  /// The face, which lives longer.
  const FaceShape* Source = nullptr;
  /// True if the face's orientation in its body is reversed.
  bool Reversed = false;
  /// True if its loops are those of the file, to be completed by CompleteLoops().
  bool AsInFile = false;
  /// The surface on which the face lies: that of the file, or the part of it that FindFaceDomain() takes.
  /// CompleteLoops() may replace a sphere by the same one with other poles.
  SurfacePointer Surface;
  Placement Location;
  /// Periods in u and v; 0: not periodic.
  double Period[2] = { 0.0, 0.0 };
  /// Periods of the surface's formula in directions in which the surface is not periodic (FindFaceDomain());
  /// 0: none.
  double FormulaPeriod[2] = { 0.0, 0.0 };
  /// Domain in directions with a FormulaPeriod.
  double Low[2] = { 0.0, 0.0 };
  double High[2] = { 0.0, 0.0 };
  /// True if the surface has a pole at the low or high end of the domain in v.
  bool EndsAtPole[2] = { false, false };
  /// True if Surface is a part of the file's surface of revolution, which reaches its axis.
  bool IsPart = false;
  /// The other part with the same points and opposite normals, if the file does not state which one is meant:
  /// every point of a symmetric profile that crosses the axis has two parameters.
  SurfacePointer OtherSurface;
  /// True if both parts make a solid (OtherSurface).
  bool IsEitherPart = false;
  /// True if nothing says which one of several different parts of its surface of revolution the face is.
  bool HasSeveralParts = false;
  std::vector<DraftLoop> Loops;
  /// Number of poles and seams that were added to the loops.
  int AddedEdges = 0;
  /// True if its outer loop was added by AddNaturalBoundary().
  bool HasNaturalBoundary = false;
  /// True if all its loops are holes between the poles that the file gives its sphere; CompleteLoops() has
  /// chosen others.
  bool HasReversedSphere = false;
  /// Returns true if it is the part of a closed surface outside its loops.
  bool IsOutside() const { return this->HasNaturalBoundary || this->HasReversedSphere; }
  /// Number of coedges whose direction in the file contradicts their loop, and was reversed (ReverseEdges()).
  int ReversedEdges = 0;
  std::vector<std::string> Messages;
  /// Number of defects: edges that were left out, and loops that do not bound a part of the surface.
  int Defects = 0;
};

/// What a coedge without a pcurve gets on a surface that is not a plane.
enum class MissingTrim
{
  /// Nothing: it is left out.
  None,
  /// Foot points of its edge's curve, computed by CompleteLoops().
  Feet
};

/**
 * Collects surface, loops and pcurves of one face and adds its edges to `edges`. Throws std::runtime_error if
 * the face has no surface, or if none of its loops can be used.
 */
SMREADERSFACES_EXPORT DraftFace CollectFace(
  const FaceShape& face, bool isReversed, EdgeIndex& edges, MissingTrim missing = MissingTrim::None);

/// Makes a trim curve the straight line between two points.
void SetStraight(const Point2& from, const Point2& to, NativeTrim& trim);

/// Returns true if the next coedge begins at the vertex at which this one ends.
bool Meet(const DraftCoedge& from, const DraftCoedge& to);

/// Orders coedges so that each ends where the next one starts, and separates disconnected chains into loops.
void OrderLoops(DraftFace& face);

/// Moves pcurves by whole periods so that every loop is continuous and all loops lie side by side.
void ShiftLoops(DraftFace& face);

/// Moves loops by whole periods so that they lie side by side.
void AlignLoops(DraftFace& face);
}

#endif
