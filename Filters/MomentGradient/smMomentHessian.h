/**
 * @file smMomentHessian.h
 * @brief Second derivatives of moments by control points: the Hessian times a direction, with bounds
 *
 * Control points move along e = sum of R_ij v_ij, weights and trim curves stay. The gradient
 * dM_g/dP_ij = integral of g R_ij n du dv then changes by the second variation
 *
 *     (H v)_ij = integral of R_ij [ (grad g . e) n + g (e_u x Sv + Su x e_v) ] du dv.
 *
 * Along a line P + t v the gradient is a polynomial in t of degree 2 + deg g, of which H v is the linear
 * coefficient: the gradients at four t give it exactly, for any distance of them, and with their bounds.
 * Documentation/Gradients.md derives both.
 *
 * It is the Hessian of the solid where all faces that share a control point move alike (Tied) and are their
 * whole nets (HasTiedBorder). On other faces it is the derivative of the gradient with
 * trim curves fixed, which is not symmetric: how edges follow then counts in the second order.
 */
#ifndef smMomentHessian_h
#define smMomentHessian_h

#include "smFiltersMomentGradientModule.h"
#include "smProgressCallback.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;

namespace sm
{
/// Displacements of the control points of a face, in world coordinates: point (i,j) at i Count[1] + j. The
/// largest one of a solid is 0, or 1e-200 to 1e200 long.
struct NetDirection
{
  int Solid = 0;
  int Face = 0;
  std::vector<std::array<double, 3>> Displacements;
};

struct MomentHessianOptions
{
  /// True: coinciding points are one variable, as in MomentGradientOptions. Their displacements have to
  /// agree, to 1e-12 of the largest one; those of the first point count.
  bool Tied = true;
  /// As in MomentGradientOptions. In (0, 1]; values below 1e-15 count as that.
  double RelativeTolerance = 1e-9;
  /// Gets the progress and may stop the run. It is called by the calling thread.
  ProgressCallback Progress;
};

constexpr int NumberOfHessianQuantities = 10;

/// The product for the control points of a face.
struct FaceHessianProduct
{
  int Solid = 0;
  int Face = 0;
  std::int64_t FileId = 0;
  int Count[2] = { 0, 0 };
  /// True if the face is its whole net, without trim curves inside, and other rows of nets, of neighbours or
  /// of this one, coincide with all rows of the net's border, or these are points: see above.
  bool HasTiedBorder = false;
  /// Component c (x, y, z) of point (i,j) for quantity q at GetIndex(i, j, c, q), and an upper bound of its
  /// error: arrays of the shape (Count[0], Count[1], 3, 10) in C order. Quantities are the first ten of
  /// GetGradientQuantities(): Volume, first and second moments about the world's origin. NaN: not known.
  /// Bounds are those of the integrals over the faces with their trim curves; what gaps leave open is not in
  /// them.
  std::vector<double> Values;
  std::vector<double> Bounds;

  std::size_t GetIndex(int i, int j, int component, int quantity) const
  {
    return NumberOfHessianQuantities * (3 * (static_cast<std::size_t>(i) * this->Count[1] + j) + component) +
      quantity;
  }
};

struct MomentHessianResult
{
  /// As in MomentGradientResult.
  std::string Status;
  std::string Reason;
  std::vector<std::string> Messages;
  std::string LengthUnit;
  /// All faces of the solids that move.
  std::vector<FaceHessianProduct> Faces;
  std::int64_t Evaluations = 0;
};

/**
 * Computes the Hessian times a direction. Faces that are not named stay; of each solid at least one face has
 * to be named for it to be in the result. Failure is a status, never an exception: "not-computed" for an
 * option out of its range, a face that does not exist or is named twice, another number of displacements than
 * control points, one that is not finite, or tied points that move apart; Reason has a sentence.
 */
SMFILTERSMOMENTGRADIENT_EXPORT MomentHessianResult ComputeMomentHessianProduct(
  vtkDataObject* model, const std::vector<NetDirection>& direction, const MomentHessianOptions& options = {});
}

#endif
