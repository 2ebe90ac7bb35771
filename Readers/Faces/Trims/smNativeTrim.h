/**
 * @file smNativeTrim.h
 * @brief A curve in the parameters of a surface: a pcurve, or the foot points of an edge
 */
#ifndef smNativeTrim_h
#define smNativeTrim_h

#include "Geometry/smConvertedSurface.h"
#include "smFootCurve.h"

#include <array>
#include <memory>
#include <vector>

namespace sm
{
/// A pcurve over [First, Last], moved by whole periods of its surface.
struct SMREADERSFACES_EXPORT NativeTrim
{
  CurvePointer<2> Curve;
  /// Foot points of the edge's curve, instead of Curve.
  std::shared_ptr<const FootCurve> Feet;
  double First = 0.0;
  double Last = 0.0;
  double Shift[2] = { 0.0, 0.0 };
  /// Largest distance of each coordinate from the foot points that the curve stands for; 0 for a curve of the
  /// file.
  double Residual[2] = { 0.0, 0.0 };
  /// The result of Sample(), if it is kept; else empty.
  std::vector<std::array<double, 2>> Samples;

  std::array<double, 2> Evaluate(double parameter) const;
  std::array<double, 2> GetStart() const { return this->Evaluate(this->First); }
  std::array<double, 2> GetEnd() const { return this->Evaluate(this->Last); }
  /// Returns First, Last and the knots between.
  std::vector<double> GetBreaks() const;
  /// Returns the pcurve if it is a line, else null.
  const LineCurve<2>* GetLine() const;
  /// Returns points at the FitOrder + 1 nodes of each piece between breaks, before the shift.
  std::vector<std::array<double, 2>> Sample() const;
  /// Extends the box to contain the curve, before the shift.
  void AddTo(NativeBox& box) const;
};
}

#endif
