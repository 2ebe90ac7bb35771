/**
 * @file smSubPatches.h
 * @brief A face prepared for the paper's schemes: its sub-patches, their deviation K and its trim polygons
 *
 * "Accurate Moment Computation Using the GPU" (SPM 2010) divides the parameter domain of a face into **sub-patches**: the knot
 * intervals in u and v, each divided into k (the sub-patch factor) equal parts in each direction. Its error estimate needs
 * of every sub-patch the largest deviation K from a linear approximation (its Eq. 1-4).
 */
#ifndef smSubPatches_h
#define smSubPatches_h

#include "smFiltersNURBSModule.h"

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
/// Borders of the sub-patches; the knots are every Factor-th of them, to the bit.
struct SubPatchGrid
{
  std::vector<double> U, V;
  int Factor = 1;

  int GetNumberOfColumns() const { return this->U.empty() ? 0 : static_cast<int>(this->U.size()) - 1; }
  int GetNumberOfRows() const { return this->V.empty() ? 0 : static_cast<int>(this->V.size()) - 1; }
};

/// `factor` is at least 1.
SMFILTERSNURBS_EXPORT SubPatchGrid MakeSubPatchGrid(const NURBSSurface& surface, int factor);

enum class DeviationMode
{
  /// Bounds of the second derivatives by control points: K is an upper bound, up to rounding.
  Bounded,
  /// The largest of samples on a grid with the corners, max(3, degree) in each direction: K is a lower bound.
  Sampled
};

/**
 * K of Eq. 4, a length, for the sub-patch [u0,u1] x [v0,v1], which lies within one knot interval:
 * K = (K1 + 2 K2 + K3) / 8 with K1, K2, K3 the largest |second derivatives| by u u, u v and v v of any coordinate, by the
 * sub-patch's own unit domain (n = m = 1). The same as derivatives by the knot interval's unit domain and n = m = k.
 */
SMFILTERSNURBS_EXPORT double ComputeDeviation(
  const NURBSSurface& surface, double u0, double u1, double v0, double v1, DeviationMode mode);

/// True for a parallelogram in one piece: degree 1 x 1, one knot interval, equal weights. To 1e-12 of the coordinates' size.
SMFILTERSNURBS_EXPORT bool IsPlanar(const NURBSSurface& surface);

/// Sub-patches that a face may have: their K fill half a gigabyte.
constexpr long long MaximumSubPatches = 1LL << 26;

struct SchemeOptions
{
  /// k, at least 1.
  int Factor = 2;
  /// Texels of the trim texture per sub-patch and direction, at least 1.
  int TextureFactor = 4;
  DeviationMode Deviation = DeviationMode::Bounded;
  /// Largest distance, a length, of the chords of a planar face's trim polygon from its trim curves; above 0.
  double ChordTolerance = 0.0;
};

/// Data of a face that the schemes read. u and v are not exchanged.
struct SubPatchFace
{
  FacePointer Source;
  /// Integrated by triangles, see smPlaneMoments.h: Grid, Patches, Points and Deviations are empty, K is 0.
  bool Planar = false;
  SubPatchGrid Grid;
  /// One per knot interval, u fastest; points are relative to the patch's centre.
  std::vector<Patch> Patches;
  std::vector<std::array<double, 4>> Points;
  /// K per sub-patch, u fastest.
  std::vector<double> Deviations;
  /// Trim polygons of a planar face, at the chord tolerance. No loops: it is not trimmed.
  TrimPolygons Polygons;
  /// Trim curves of any other face: the trim texture is made from the curves themselves. Chords to a share of a texel would not do: along L
  /// texels of a curve they err to one side by their deviation times L, the texels' own errors by the root of L.
  std::vector<TrimRise> Rises;
  /// Estimated distance, a length, by which the trim curves leave the surface; 0 for a planar face, whose plane has no border.
  double Outside = 0.0;

  /// There is a trim texture.
  bool HasTexture() const { return !this->Planar && this->Source && !this->Source->Loops.empty(); }
  /// Not empty: the face cannot be integrated by a scheme; it says why and names the face. All but Source is empty then.
  std::string Error;
};

/// Never throws: what is wrong with the face or the options is told in Error. Thread safe.
SMFILTERSNURBS_EXPORT SubPatchFace PrepareSubPatchFace(const FacePointer& face, const SchemeOptions& options);

/**
 * The same in two steps, for the deviations of a face may take minutes: first all but their values, which are 0, then those of
 * the sub-patches [begin, end), as many at a time as wanted. Thread safe; of one face, where the ranges are apart.
 */
///@{
SMFILTERSNURBS_EXPORT SubPatchFace PrepareSubPatchShape(
  const FacePointer& face, const SchemeOptions& options);
SMFILTERSNURBS_EXPORT void ComputeDeviations(
  SubPatchFace& face, DeviationMode mode, std::size_t begin, std::size_t end);
///@}
}

#endif
