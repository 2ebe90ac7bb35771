/**
 * @file smFaceCheck.h
 * @brief Checks faces against what their file states about them in space
 *
 * A face is integrated within loops in the parameters of its surface. If one of these is wrong (a piece is
 * lost, it is a period too long, it takes the other side), the integrals of something else are right to
 * 1e-13. So the boundary is compared with the file's own edges in space, in their own directions, of which no
 * parameter, no loop and no mesh knows.
 *
 * By Stokes' theorem the vector area and the traceless moments of the region within loops, with the
 * multiplicities that it is integrated with, are line integrals along the images of the loops
 * (smLineIntegrals.h). So both sides are line integrals, and nothing has to be integrated over the face: a
 * loop that does not close is closed by a straight piece in the parameters, as for the integrals.
 *
 * | kind of fault | vector area | moments | case that proves it (TestFaceCheck) |
 * |---|---|---|---|
 * | the other side of a loop: the rest of a sphere for a cap | yes | yes | "the rest instead" |
 * | the other side of a symmetric zone: two caps | 0 for both | yes | "two caps instead" |
 * | a lateral face that counts nothing, or twice | 0 for both | yes | "no area", "twice the face" |
 * | a part of a face | yes | yes | "half of the face" |
 * | a lost corner, an additional loop | yes | yes | "square without a side", "additional" |
 * | a face of a repair in two parts of which one is lost | yes | yes | "of which one is lost" |
 * | a loop off its edges on the surface | yes | yes | "a loop off its edges" |
 *
 * What is integrated afterwards are these loops, and the integrals are not compared with the statement again:
 *
 * | kind of fault between loops and numbers     | found by                                                |
 * |---------------------------------------------|---------------------------------------------------------|
 * | a panel, patch or face lost, or added       | the vector area of the closed chain as integrated, 0    |
 * |                                             | for a solid: above 1e-9 it is suspect                   |
 * |                                             | (smMassAnalysis.cxx, "the faces do not close")          |
 * | a part covered twice, or against the others | the multiplicities of the coverage (smLoopCrossings.h)  |
 * | all panels of a face of vector area 0       | nothing; they lie in several knot spans, and each is    |
 * |                                             | cut and integrated by itself                            |
 *
 * The edges' part of the chain cancels between the faces, so that what vanishes is the sum over the faces of
 * what is integrated less what the loops bound: nothing is gained by the comparison of each face but its
 * name. The moments x_i n_j are not among the fourteen integrands, and nine more would cost more than all
 * checks. None of the integrals of mass properties could take their place: the flux of a field is that of the
 * boundary alone only if its divergence is 0, and theirs are r g(r).
 */
#ifndef smFaceCheck_h
#define smFaceCheck_h

#include "smFace.h"
#include "smFaceStatement.h"

#include <vector>

namespace sm
{
/// Place of a model in the coordinates of its statements: a point x of these is at Linear x + Shift in the
/// model. Linear is a rotation, or a reflection, times a factor.
struct StatementPlace
{
  Matrix3 Linear{ Vector3{ 1.0, 0.0, 0.0 }, Vector3{ 0.0, 1.0, 0.0 }, Vector3{ 0.0, 0.0, 1.0 } };
  Vector3 Shift{};
};

enum class FaceVerdict
{
  /// The file states nothing, or has a curve that is not understood.
  Unknown,
  Agrees,
  /// The boundary is the file's, in the opposite direction relative to the face's normal.
  Reversed,
  Differs
};

struct FaceFinding
{
  FaceVerdict Verdict = FaceVerdict::Unknown;
  /// Vector areas by the file's edges and by the loops, about the normal of the face in the file, in the
  /// units of the statement.
  Vector3 Stated{};
  Vector3 Read{};
  /// Magnitudes of the differences of the vector areas, and of the moments.
  double AreaDifference = 0.0;
  double MomentDifference = 0.0;
};

/// Integrates along the images of the loops of a face, about `center`, in the direction in which the
/// surface's normal Su x Sv sees the face on its left. If `size` is above 0, it is the size of the face, and
/// the integration is adaptive; else each piece of a trim curve has five samples.
SMREADERSFACES_EXPORT LineIntegrals IntegrateLoops(const Face& face, const Vector3& center, double size);

/**
 * Compares a face with its statement. `parts` are the faces of the model that the face of the file has
 * become, usually one.
 *
 * A difference of the vector area counts above 1e-6 of the square of the perimeter, and above twice the area
 * between the face's boundary and its edges. For that the distance of an edge from the surface counts in
 * full, and that along the surface up to a thousandth of the perimeter, so that a fault does not excuse
 * itself. The allowance for gaps is at most 3e-3 of the square of the perimeter. The limits of the moments
 * are those times a quarter of the perimeter. In 98 real files with 25,207 faces the widest gap of a sound
 * face makes 2e-3 (ploopy_mini_primary), and a face differs by less than the area between boundary and edges,
 * not twice that.
 */
SMREADERSFACES_EXPORT FaceFinding CheckFace(
  const std::vector<const Face*>& parts, const FaceStatement& statement, const StatementPlace& place);
}

#endif
