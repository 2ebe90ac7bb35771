/**
 * @file smBodyCheck.h
 * @brief Finds contradictions between the faces of a body, which no check of a single face sees
 *
 * A loop on a closed surface bounds two finite faces, one on either side. If one flag of the file is
 * reversed, the other one is again a consistent face, with its normal on the other side. Only the rest of the
 * body shows which one is meant, or a seam, which the other part lacks, if an adjacent face confirms it.
 *
 * | kind of fault | found by | case that proves it (TestBodyCheck) |
 * |---|---|---|
 * | a bound, or the edges, reversed; a repair reversed the face | Reversed | "a reversed cap" |
 * | the same, with a seam, next to a sound face | nothing, by intent | "a reversed cap with a seam" |
 * | the same, next to such faces alone | Reversed | "a ring of two parts" |
 * | the same, and the face was read by the letter | SameDirection | "a cap by the letter" |
 * | same_sense reversed: the other part, inside out | InsideOut | "a rest that is inside out" |
 * | arcs that run backwards, so that all their faces are reversed | Backwards | "arcs that run backwards" |
 * | a bound of a plane reversed: one side is infinite | nothing, by intent | "a reversed plane next to a cap"
 * | | same_sense of a zone reversed: two caps | InPieces | "two caps as one face" | | same_sense on a torus
 * reversed that crosses itself | CrossesItself | "both parts of a torus" | | a whole closed surface too many
 * | TooLarge | "more than the whole sphere" | | a face that the mesh lacks | NotInMesh | "a face without
 * triangles" | | same_sense of a dimple reversed: a knob | nothing | a sound part, too |
 */
#ifndef smBodyCheck_h
#define smBodyCheck_h

#include "smFaceCheck.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace sm
{
/// A face of the file in a body.
struct CheckedFace
{
  const FaceStatement* Statement = nullptr;
  FaceFinding Finding;
  /// True if both sides of a loop on its surface are known to be finite.
  bool IsClosed = false;
  /// Number of pieces of the face (smFacePieces.h), and whether it has points of both parts of a surface that
  /// crosses itself.
  int Pieces = 1;
  bool IsOnBothParts = false;
  /// Area by a mesh, in the units of the statement; NaN if not known.
  double Area = std::numeric_limits<double>::quiet_NaN();
};

struct BodyContradiction
{
  enum class Type
  {
    /// The face is on a closed surface, and has the other side of its bounds than the file states.
    Reversed,
    /// The face is on a closed surface, and an edge has the same direction in it and in another face.
    SameDirection,
    /// The body is inside out, and the face is a part of a closed surface.
    InsideOut,
    /// The face has several pieces within its bounds, on a closed surface.
    InPieces,
    /// The face crosses itself.
    CrossesItself,
    /// The area of the face exceeds that of its whole surface.
    TooLarge,
    /// The mesh lacks the face, whose edges bound an area.
    NotInMesh,
    /// All faces at an arc of a closed curve have the other side of their bounds than the file states: the
    /// other part of the curve may be meant.
    Backwards
  };
  Type Kind = Type::Reversed;
  /// Index of the face, and of another one, or the same.
  std::size_t Face = 0;
  std::size_t Other = 0;
  /// Entity number of the edge; 0: none.
  std::uint64_t Edge = 0;
};

/// Returns true if both sides of a loop on the surface of a face are finite.
using ClosedTest = std::function<bool(std::size_t)>;

/// Finds the contradictions of a body, at most one for each face. `isInsideOut`: its outer shell is inside
/// out in the file. `isClosed` is called, at most once a face, where it matters and CheckedFace::IsClosed is
/// false.
SMREADERSFACES_EXPORT std::vector<BodyContradiction> FindContradictions(
  const std::vector<CheckedFace>& faces, bool isInsideOut, const ClosedTest& isClosed = {});
}

#endif
