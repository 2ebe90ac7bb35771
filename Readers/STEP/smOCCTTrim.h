/**
 * @file smOCCTTrim.h
 * @brief Converts OpenCASCADE's pcurves to polynomial pieces in the parameters of the converted surface
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
  /// Foot points of the edge's curve, instead of Curve.
  std::shared_ptr<const FootCurve> Feet;
  double First = 0.0;
  double Last = 0.0;
  double Shift[2] = { 0.0, 0.0 };
  /// Largest distance of each coordinate from the foot points that the curve stands for; 0 for a curve of the file.
  double Residual[2] = { 0.0, 0.0 };
  /// The result of Sample(), if it is kept; else empty.
  std::vector<std::array<double, 2>> Samples;

  std::array<double, 2> Evaluate(double parameter) const;
  std::array<double, 2> GetStart() const { return this->Evaluate(this->First); }
  std::array<double, 2> GetEnd() const { return this->Evaluate(this->Last); }
  /// Returns First, Last and the knots between.
  std::vector<double> GetBreaks() const;
  /// Returns the pcurve if it is a line, else null.
  Handle(Geom2d_Line) GetLine() const;
  /// Returns points at the FitOrder + 1 nodes of each piece between breaks, before the shift.
  std::vector<std::array<double, 2>> Sample() const;
  /// Extends the box to contain the curve, before the shift.
  void AddTo(NativeBox& box) const;
};

/// Returns the tolerance of the fit of a trim curve in each of our parameters.
std::array<double, 2> GetTrimTolerance(const ParameterMap maps[2], const double width[2]);

/**
 * Converts a pcurve to a trim curve over the edge's range, in the parameters of the converted surface: exactly for polynomial pcurves if
 * both maps are the identity, else cut at arc borders and fitted to 1e-13 of an arc or of `width`, or to the level of rounding of the
 * angles.
 */
SMREADERSSTEP_EXPORT TrimCurve ConvertTrim(const NativeTrim& trim, double edgeFirst, double edgeLast,
  const ParameterMap maps[2], const double width[2]);
}

#endif
