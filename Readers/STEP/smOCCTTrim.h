/**
 * @file smOCCTTrim.h
 * @brief OpenCASCADE's pcurves as polynomial pieces in the parameters of the converted surface
 */
#ifndef smOCCTTrim_h
#define smOCCTTrim_h

#include "smOCCTFootCurve.h"
#include "smOCCTSurface.h"
#include "smPolynomialCurve.h"
#include "smReadersSTEPModule.h"

#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>

#include <array>
#include <memory>
#include <vector>

namespace sm
{
/// A pcurve over [First, Last], moved by whole periods of its surface.
struct SMREADERSSTEP_EXPORT NativeTrim
{
  Handle(Geom2d_Curve) Curve;
  /// Instead of Curve: the feet of the edge's own curve.
  std::shared_ptr<const FootCurve> Feet;
  double First = 0.0;
  double Last = 0.0;
  double Shift[2] = { 0.0, 0.0 };
  /// What Sample() returns, where that is kept.
  std::vector<std::array<double, 2>> Samples;

  std::array<double, 2> Evaluate(double parameter) const;
  std::array<double, 2> GetStart() const { return this->Evaluate(this->First); }
  std::array<double, 2> GetEnd() const { return this->Evaluate(this->Last); }
  /// First, Last and the knots between.
  std::vector<double> GetBreaks() const;
  /// The pcurve where it is a line, else null.
  Handle(Geom2d_Line) GetLine() const;
  /// Points at the FitOrder + 1 nodes of each piece between breaks, before the shift.
  std::vector<std::array<double, 2>> Sample() const;
  /// Widens the box by what the curve covers, before the shift.
  void AddTo(NativeBox& box) const;
};

/// Residual that a trim curve is fitted to, in each of our parameters.
std::array<double, 2> GetTrimTolerance(const ParameterMap maps[2], const double width[2]);

/**
 * The trim curve over the edge's range, in the parameters of the converted surface: exact for polynomial
 * pcurves where both maps are the identity, else cut at arc borders and fitted to 1e-13 of an arc or of
 * `width`, or to the floor that rounding of the angles sets.
 */
SMREADERSSTEP_EXPORT TrimCurve ConvertTrim(const NativeTrim& trim, double edgeFirst, double edgeLast,
  const ParameterMap maps[2], const double width[2]);
}

#endif
