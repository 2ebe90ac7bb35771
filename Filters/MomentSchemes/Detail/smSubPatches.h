/**
 * @file smSubPatches.h
 * @brief A face prepared for the paper's schemes: its sub-patches, their deviation K and its trim polygons
 *
 * "Accurate Moment Computation Using the GPU" (SPM 2010) divides the parameter domain of a face into
 * **sub-patches**: the knot intervals in u and v, each divided into k (the sub-patch factor) equal parts in
 * each direction. Its error estimate needs the largest deviation K of every sub-patch from a linear
 * approximation (its Eq. 1-4).
 */
#ifndef smSubPatches_h
#define smSubPatches_h

#include "smFiltersMomentSchemesModule.h"

#include "smFace.h"
#include "smFacePanels.h"
#include "smTrimPolygons.h"
#include "smTrimRises.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace sm
{
/// Borders of the sub-patches. Every Factor-th border is bitwise equal to a knot.
struct SubPatchGrid
{
  std::vector<double> U, V;
  int Factor = 1;

  int GetNumberOfColumns() const { return this->U.empty() ? 0 : static_cast<int>(this->U.size()) - 1; }
  int GetNumberOfRows() const { return this->V.empty() ? 0 : static_cast<int>(this->V.size()) - 1; }
};

/// Makes the grid of a surface. `factor` must be at least 1.
SMFILTERSMOMENTSCHEMES_EXPORT SubPatchGrid MakeSubPatchGrid(const NURBSSurface& surface, int factor);

/// Method by which the second derivatives in the deviation K are found.
enum class DeviationMode
{
  /// K is computed from bounds of the second derivatives by control points: an upper bound, up to rounding.
  Bounded,
  /// K is computed from the largest of max(3, degree) samples in each direction, on a grid that includes the
  /// corners: a lower bound.
  Sampled
};

/**
 * Returns K of Eq. 4, a length, for the sub-patch [u0,u1] x [v0,v1], which lies within one knot interval: K =
 * (K1 + 2 K2 + K3) / 8 with K1, K2, K3 the largest |second derivatives| by u u, u v and v v of any
 * coordinate, with respect to the sub-patch's own unit domain (n = m = 1). This equals the paper's K from
 * derivatives with respect to the knot interval's unit domain with n = m = k.
 */
SMFILTERSMOMENTSCHEMES_EXPORT double ComputeDeviation(
  const NURBSSurface& surface, double u0, double u1, double v0, double v1, DeviationMode mode);

/// Returns true for a parallelogram in one piece: degree 1 x 1, one knot interval, equal weights, to 1e-12 of
/// the coordinates' size.
SMFILTERSMOMENTSCHEMES_EXPORT bool IsPlanar(const NURBSSurface& surface);

/// Largest number of sub-patches of a face; their K occupy half a gigabyte.
constexpr long long MaximumSubPatches = 1LL << 26;

/// Options for the preparation of a face.
struct SchemeOptions
{
  /// Sub-patch factor k, at least 1.
  int Factor = 2;
  /// Number of texels of the trim texture per sub-patch and direction, at least 1.
  int TextureFactor = 4;
  DeviationMode Deviation = DeviationMode::Bounded;
  /// Largest distance between the trim curves of a planar face and the chords of its trim polygon, a length
  /// above 0.
  double ChordTolerance = 0.0;
};

/// The data of a face that the schemes need. u and v are not exchanged.
struct SubPatchFace
{
  FacePointer Source;
  /// True for a face that is integrated by triangles (smPlaneMoments.h): Grid, Patches, Points and Deviations
  /// are empty, K is 0.
  bool Planar = false;
  SubPatchGrid Grid;
  /// Bézier patches, one per knot interval, u fastest; Points are relative to the patch's centre.
  std::vector<Patch> Patches;
  std::vector<std::array<double, 4>> Points;
  /// Deviation K of each sub-patch, u fastest.
  std::vector<double> Deviations;
  /// Trim polygons of a planar face, at the chord tolerance. A face without loops is not trimmed.
  TrimPolygons Polygons;
  /// Trim curves of a face that is not planar. The trim texture is made from the curves themselves. Chords
  /// within a fraction of a texel would not be accurate enough: along L texels of a curve their error has one
  /// sign and sums to their deviation times L, while the errors of the texels sum to the root of L.
  std::vector<TrimRise> Rises;
  /// Approximate distance, a length, by which the trim curves leave the surface; 0 for a planar face, whose
  /// plane is unbounded.
  double Outside = 0.0;

  /// Returns true if the face has a trim texture.
  bool HasTexture() const { return !this->Planar && this->Source && !this->Source->Loops.empty(); }
  /// Reason why the face cannot be integrated by a scheme, with the name of the face; else empty. If it is
  /// not empty, everything except Source is empty.
  std::string Error;
};

/// Prepares a face. It never throws: errors of the face or the options are returned in Error. Thread safe.
SMFILTERSMOMENTSCHEMES_EXPORT SubPatchFace PrepareSubPatchFace(
  const FacePointer& face, const SchemeOptions& options);

/**
 * The two steps of PrepareSubPatchFace(), for faces whose deviations may take minutes: PrepareSubPatchShape()
 * computes everything except the deviations, which are 0, and ComputeDeviations() computes those of the
 * sub-patches [begin, end). Thread safe; for one face if the ranges are disjoint.
 */
///@{
SMFILTERSMOMENTSCHEMES_EXPORT SubPatchFace PrepareSubPatchShape(
  const FacePointer& face, const SchemeOptions& options);
SMFILTERSMOMENTSCHEMES_EXPORT void ComputeDeviations(
  SubPatchFace& face, DeviationMode mode, std::size_t begin, std::size_t end);
///@}
}

#endif
