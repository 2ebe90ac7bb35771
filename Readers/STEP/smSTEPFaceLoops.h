/**
 * @file smSTEPFaceLoops.h
 * @brief Loops of the faces of a STEP file
 */
#ifndef smSTEPFaceLoops_h
#define smSTEPFaceLoops_h

#include "smSTEPAttributes.h"
#include "smSTEPCensus.h"

#include <cstdint>
#include <vector>

namespace sm
{
/// A bound of a face.
struct STEPFaceLoop
{
  using Index = Part21File::Index;

  enum class Type
  {
    Other, ///< of a kind that is not read, or with an edge that is missing
    Edges,
    Vertex,
    Polygon
  };
  struct Use
  {
    Index Edge;
    bool IsForward;
  };

  Type Kind = Type::Other;
  /// EDGE_LOOP, VERTEX_LOOP or POLY_LOOP.
  Index Entity = Part21File::None;
  /// Orientation of the bound.
  bool IsForward = true;
  /// Oriented edges of an EDGE_LOOP.
  std::vector<Use> Uses;
};

/// All bounds of the faces of a census, read once, on all threads. Const methods may be called by several
/// threads.
class STEPFaceLoops
{
public:
  STEPFaceLoops(const STEPAttributes& entities, const STEPCensus& census);

  /// Returns the bounds of a face, in the order of the file.
  Part21Range<STEPFaceLoop> operator[](const CensusFace& face) const
  {
    const STEPFaceLoop* first = this->Loops.data() + face.FirstBound;
    return { first, first + face.NumberOfBounds };
  }

private:
  std::vector<STEPFaceLoop> Loops;
};
}

#endif
