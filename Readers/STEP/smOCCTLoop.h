/**
 * @file smOCCTLoop.h
 * @brief The loops of a face as OpenCASCADE has them: ordered, continuous in native (u,v), not yet converted
 */
#ifndef smOCCTLoop_h
#define smOCCTLoop_h

#include "smOCCTTrim.h"

#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <string>
#include <vector>

namespace sm
{
struct DraftCoedge
{
  TopoDS_Edge Edge;
  /// Index of the edge in the body, from 0; below 0 for a pole or a seam that the file leaves out: -1 - number in its face. Its
  /// curve is what its trim draws.
  int EdgeIndex = -1;
  bool Reversed = false;
  bool Degenerate = false;
  /// On a plane and without a pcurve of its own: the edge's curve projected.
  bool Projected = false;
  /// Without a pcurve of its own: to get the feet of the edge's curve.
  bool NeedsFeet = false;
  /// Largest distance of samples of the edge from the points of the surface that its trim gives, where that was looked at.
  double EdgeDistance = 0.0;
  /// Largest distance of these points from the border of the surface's domain.
  double Overhang = 0.0;
  NativeTrim Trim;
  /// In loop direction; null when the file gives none.
  TopoDS_Vertex Start;
  TopoDS_Vertex End;

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
  /// The face with forward orientation.
  TopoDS_Face Face;
  /// The face's orientation in its body is reversed.
  bool Reversed = false;
  /// Its loops are those of the file, for CompleteLoops.
  bool AsInFile = false;
  /// The surface without rectangular trims; a sphere of CompleteLoops may have other poles.
  Handle(Geom_Surface) Surface;
  /// The surface as the face stores it; its domain is used for a face without loops.
  Handle(Geom_Surface) Stored;
  gp_Trsf Location;
  /// 0: not periodic.
  double Period[2] = { 0.0, 0.0 };
  std::vector<DraftLoop> Loops;
  /// Poles and seams that were added to the loops.
  int AddedEdges = 0;
  std::vector<std::string> Messages;
  /// Edges left out and loops that are not bounded: the face is not what the file says.
  int Defects = 0;
};

/// The trim curve that a coedge without a pcurve gets on a surface that is no plane.
enum class MissingTrim
{
  /// OpenCASCADE's approximation, at once.
  Approximated,
  /// The feet of its edge's curve, by CompleteLoops.
  Feet
};

/**
 * Collects surface, loops and pcurves of one face and adds its edges (forward) to `edges`. Serial: a missing
 * pcurve is added to the shape here. Throws std::runtime_error when the face has no surface, or when nothing is
 * left of the loops it came with.
 */
DraftFace CollectFace(const TopoDS_Face& face, TopTools_IndexedMapOfShape& edges,
  MissingTrim missing = MissingTrim::Approximated);

/// Puts coedges into an order in which each ends where the next one starts; splits separate chains.
void OrderLoops(DraftFace& face);

/// Moves pcurves by whole periods so that every loop is continuous and all loops lie side by side.
void ShiftLoops(DraftFace& face);

/// Moves loops by whole periods so that they lie side by side.
void AlignLoops(DraftFace& face);
}

#endif
