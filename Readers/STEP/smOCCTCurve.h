/**
 * @file smOCCTCurve.h
 * @brief OpenCASCADE's edge curves and pcurves as polynomial pieces in the edge's parameter
 */
#ifndef smOCCTCurve_h
#define smOCCTCurve_h

#include "smChebyshevFit.h"
#include "smOCCTSurface.h"

#include <Geom2d_Curve.hxx>

#include <functional>
#include <limits>

namespace sm
{
/// A pcurve over [First, Last], moved by whole periods of its surface.
struct NativeTrim
{
  Handle(Geom2d_Curve) Curve;
  double First = 0.0;
  double Last = 0.0;
  double Shift[2] = { 0.0, 0.0 };

  std::array<double, 2> Evaluate(double parameter) const;
  std::array<double, 2> GetStart() const { return this->Evaluate(this->First); }
  std::array<double, 2> GetEnd() const { return this->Evaluate(this->Last); }
  /// First, Last and the knots between.
  std::vector<double> GetBreaks() const;
  /// Widens the box by what the curve covers, before the shift.
  void AddTo(ParameterBox& box) const;
};

/**
 * The trim curve over the edge's range, in the parameters of the converted surface: exact for polynomial
 * pcurves where both maps are the identity, else cut at arc borders and fitted to 1e-13 of an arc or of
 * `width`, or to the floor that rounding of the angles sets.
 */
TrimCurve ConvertTrim(const NativeTrim& trim, double edgeFirst, double edgeLast, const ParameterMap maps[2],
  const double width[2]);

/// Exact for lines and polynomial splines, else FitEdge.
EdgeCurve ConvertEdge(const Handle(Geom_Curve) & curve, double first, double last, const AffineMap& map);

/// Polynomial pieces to 1e-14 of the curve's size.
EdgeCurve FitEdge(const Handle(Geom_Curve) & curve, double first, double last, const AffineMap& map);

/// The same for any smooth function of the parameter between the breaks; its values carry roundings of
/// coordinates as large as `magnitude`.
EdgeCurve FitEdge(
  const std::function<Vector3(double)>& position, const std::vector<double>& breaks, double magnitude);

/// Breaks of a 3D curve: first, last and the knots between.
std::vector<double> GetCurveBreaks(const Handle(Geom_Curve) & curve, double first, double last);
}

#endif
