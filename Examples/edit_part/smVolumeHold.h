/**
 * @file smVolumeHold.h
 * @brief Keeps the volume of a part while a control point is dragged
 *
 * Other control points follow along the gradient of the volume by them, all by the same factor t: the first
 * of these sets that is not empty.
 * 1. Points of the farthest faces that are their whole nets, as far as no further face shares them. They open
 *    no edge.
 * 2. Other points of the dragged face that move no edges except those that the drag moves. They may open
 * these edges, as the drag itself may.
 * 3. Points of the farthest face that move no edge.
 * With weights and trim curves fixed the volume, that of the chain which ribbons close, is a
 * polynomial of degree 3 in the displacement of the drag and in t (sm::VariantPolynomial), so that Newton's
 * method finds t from exact integrals in microseconds; gradient and polynomial are made when a drag begins.
 */
#ifndef smVolumeHold_h
#define smVolumeHold_h

#include "smEditedPart.h"

#include <smVariantPolynomial.h>
#include <vtkSmartPointer.h>
#include <vtkTrimmedNURBSModel.h>

#include <array>
#include <memory>
#include <optional>
#include <string>

namespace sm
{
class VolumeHold
{
public:
  /// The largest deviation of a held volume, relative to it.
  static constexpr double Tolerance = 1e-9;

  /// Switches it on or off. The volume to hold is that of the part when the next drag begins. Default: off.
  void SetOn(bool on);
  bool IsOn() const { return this->On; }
  /// Lets the next drag begin with the volume of the part then; for an undo, a redo or a reset.
  void Forget();

  /**
   * Prepares a drag of `grip` by `rule`; `volume` is that of the whole part now, in its unit. Returns false,
   * with GetMessage(), if the volume cannot be held: the part is open; all three sets of points above are
   * empty; or points of the first or the third set would open an edge. Points of the second set may open
   * edges that the drag moves; the volume held is then that of the chain which ribbons close.
   */
  bool Begin(const EditedPart& part, const Grip& grip, EditRule rule, double volume);
  /// Returns the model of the dragged body for a displacement of the dragged point from its start, in world
  /// coordinates; null, with GetMessage(), where the volume cannot be held.
  vtkSmartPointer<vtkTrimmedNURBSModel> Solve(const std::array<double, 3>& displacement);
  const std::string& GetMessage() const { return this->Message; }

  /// Remembers the volume after an update.
  void Record(double volume);
  /// Returns the volume that is held; no value before the first drag.
  const std::optional<double>& GetVolume() const { return this->Volume; }
  /// Returns the deviation of the last recorded volume, relative to the held one, and the largest so far.
  double GetDeviation() const { return this->Deviation; }
  double GetMaxDeviation() const { return this->MaxDeviation; }
  /// Seconds of the last Begin() and of the last Solve().
  double GetBeginSeconds() const { return this->BeginSeconds; }
  double GetSolveSeconds() const { return this->SolveSeconds; }

private:
  vtkSmartPointer<vtkTrimmedNURBSModel> MoveAlongGradient(
    vtkNURBSDataSet* body, const Grip& grip, double amount);
  bool MakePolynomial(vtkNURBSDataSet* body, const Grip& grip, EditRule rule);

  bool On = false;
  std::optional<double> Volume;
  double Deviation = 0.0;
  double MaxDeviation = 0.0;
  double BeginSeconds = 0.0;
  double SolveSeconds = 0.0;
  std::string Message;
  /// The dragged body with the displacement (directions 0 to 2) and t (3), and its volume as a polynomial.
  std::shared_ptr<const VariantShape> Shape;
  std::shared_ptr<const VariantPolynomial> Polynomial;
  /// The wanted value of the polynomial, and half the diagonal of the body.
  double Wanted = 0.0;
  double Reach = 0.0;
  /// True if the points that follow may open edges, those that the drag opens, too.
  bool MayOpen = false;
};
}

#endif
