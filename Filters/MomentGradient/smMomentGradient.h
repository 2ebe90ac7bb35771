/**
 * @file smMomentGradient.h
 * @brief Gradients of mass properties of exact solids by control points and weights, with bounds
 *
 * If a surface moves by dx, the integral of g over the volume changes by the integral of g dx . n over the
 * surface. With x = sum of R_ij P_ij this gives, without differences,
 *
 *     dM_g / dP_ij = integral of g R_ij n du dv,
 *     dM_g / dw_ij = integral of g R_ij (P_ij - x) . n du dv / w_ij   (at fixed points),
 *
 * and centre, inertia and principal moments follow by the chain rule. Documentation/Gradients.md derives
 * them, with what is meant on trimmed faces: trim curves stay in (u,v), which for volume and moments is the
 * derivative with edges intersected anew, up to gap times speed, which the bounds include. The area is that
 * of the faces with trim curves fixed in (u,v).
 *
 * The integrals run by compute shaders or on the threads of vtkSMPTools, everything else on these.
 * Coordinates are those of the world.
 */
#ifndef smMomentGradient_h
#define smMomentGradient_h

#include "smBackendChoice.h"
#include "smFiltersMomentGradientModule.h"
#include "smProgressCallback.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkComputeContext;
class vtkDataObject;

namespace sm
{
/// A scalar quantity that is differentiated, and its unit as a power of the length unit.
struct GradientQuantity
{
  const char* Name;
  int LengthPower;
};

/// The quantities, in the order of FaceMomentGradient: Volume; FirstMoment_X, _Y, _Z and SecondMoment_XX,
/// _YY, _ZZ, _XY, _YZ, _XZ about the world's origin; CenterOfMass_X, _Y, _Z; Inertia_XX, _YY, _ZZ, _XY, _YZ,
/// _XZ about the centre, with negative products off the diagonal; PrincipalMoment_1, _2, _3 ascending;
/// SurfaceArea. All at density 1.
SMFILTERSMOMENTGRADIENT_EXPORT const std::vector<GradientQuantity>& GetGradientQuantities();

constexpr int NumberOfGradientQuantities = 23;

struct MomentGradientOptions
{
  /// Indices from 0 of the solids and free shells in the input; empty: all.
  std::vector<int> Solids;
  /// Indices from 0 of the faces of each of these; empty: all.
  std::vector<int> Faces;
  /**
   * True: control points that coincide because the surface does are one variable, and each of them has the
   * derivative by that variable: rows that faces share at an edge, as MoveSharedBoundary moves them
   * (smModelEdit.h), with the ends of a closed net among them, and rows that are one point (poles). Weights
   * of such rows keep their ratios, so that derivatives by them are those by the weight that is named; those
   * of a pole are variables of their own. False: every control point of every face is a variable of its own.
   */
  bool Tied = true;
  /// Tolerance of the quadrature of each derivative, relative to the area of the body times powers of half
  /// its diagonal. In (0, 1]; values below 1e-15 count as that.
  double RelativeTolerance = 1e-9;
  /// Values of both differ within the bounds. Automatic takes OpenGL on a GPU where the CPU is estimated to
  /// take more than a second.
  BackendChoice Backend = BackendChoice::Automatic;
  /// For OpenGL; null: a context of its own, on the X display or without any by EGL.
  vtkComputeContext* Context = nullptr;
  /// Gets the progress and may stop the run. It is called by the calling thread.
  ProgressCallback Progress;
};

/// Gradients by the control points and weights of one face of an instance of a solid.
struct FaceMomentGradient
{
  /// Indices from 0 of the solid in the input, and of the face in it; entity number of the face in the file.
  int Solid = 0;
  int Face = 0;
  std::int64_t FileId = 0;
  /// Numbers of control points in u and v.
  int Count[2] = { 0, 0 };
  /// World coordinates and weight of point (i,j) at i Count[1] + j, as the next ones.
  std::vector<std::array<double, 4>> Points;
  /// Numbers of the variables that points and weights belong to, equal for tied ones; unique in the result.
  std::vector<std::int64_t> PointVariables;
  std::vector<std::int64_t> WeightVariables;
  /// The derivative of quantity q by component c (0 to 2: x, y, z; 3: weight) of point (i,j), and an upper
  /// bound of its error, both at GetIndex(i, j, c, q): arrays of the shape (Count[0], Count[1], 4, 23) in C
  /// order. NaN: not known, or there is none.
  std::vector<double> Values;
  std::vector<double> Bounds;

  std::size_t GetIndex(int i, int j, int component, int quantity) const
  {
    return NumberOfGradientQuantities * (4 * (static_cast<std::size_t>(i) * this->Count[1] + j) + component) +
      quantity;
  }
};

struct MomentGradientResult
{
  /// "ok", or what vtkSurfaceIntegralBase says of the mass properties: "open", "suspect", "not-computed", ...
  std::string Status;
  /// Why the status is not "ok"; empty if it is.
  std::string Reason;
  /// What is NaN and why, bounds of the area among it, counted for each solid; and the messages about the
  /// bodies.
  std::vector<std::string> Messages;
  std::string LengthUnit;
  std::vector<FaceMomentGradient> Faces;
  /// CPU or OpenGL, and why the CPU where OpenGL was asked for or tried.
  BackendChoice Backend = BackendChoice::CPU;
  std::string BackendReason;
  /// Points of surfaces that were evaluated for the gradients; seconds for the mass properties, for the
  /// gradients, and of the latter for the integrals.
  std::int64_t Evaluations = 0;
  double MomentSeconds = 0.0;
  double GradientSeconds = 0.0;
  double IntegralSeconds = 0.0;
};

/**
 * Computes the gradients for `model`: a vtkNURBSDataSet with a model, or a composite dataset with any number
 * of them. Failure is a status, never an exception: an option out of its range, a run that was stopped, a
 * lack of memory and an exception of the callback are "not-computed", null and an input without exact
 * geometry are "empty"; Reason has a sentence.
 */
SMFILTERSMOMENTGRADIENT_EXPORT MomentGradientResult ComputeMomentGradient(
  vtkDataObject* model, const MomentGradientOptions& options = {});
}

#endif
