/**
 * @file smSplineBasis.h
 * @brief One direction of a B-spline, and the derivatives of its basis functions
 */
#ifndef smSplineBasis_h
#define smSplineBasis_h

#include "smFlatKnots.h"
#include "smReadersFacesModule.h"

#include <string>
#include <vector>

namespace sm
{
/// Highest order of derivatives of curves and surfaces.
constexpr int MaximumOrder = 3;

/**
 * The knots of one direction of a B-spline (ISO 10303-42, b_spline_curve_with_knots), as distinct values with
 * multiplicities. The standard knows no periodic splines. `Periodic` makes one of a spline whose last control
 * points repeat the first ones and are left out: its parameter is taken modulo its period.
 */
struct SMREADERSFACES_EXPORT SplineBasis
{
  int Degree = 1;
  std::vector<double> Knots;
  std::vector<int> Multiplicities;
  bool Periodic = false;

  /// Makes a basis of flat knots; equal neighbours are one knot.
  static SplineBasis MakeFromFlat(int degree, const std::vector<double>& flat);

  double GetStart() const { return this->Knots[this->StartKnot]; }
  double GetEnd() const { return this->Knots[this->EndKnot]; }
  /// Number of control points.
  int GetCount() const { return this->Count; }

  /// Returns a short reason if degree, knots and multiplicities do not fit together; else completes the
  /// basis.
  std::string Complete();

  /// The derivatives of order 0 to `order` of the Degree + 1 basis functions at t that are not 0, and the
  /// index of the control point of each. Outside the domain the polynomials of the first or last span are
  /// continued.
  struct Values
  {
    double N[MaximumOrder + 1][MaximumDegree + 1];
    int Poles[MaximumDegree + 1];
  };
  void Evaluate(double t, int order, Values& values) const;

  /// Returns flat knots that cover [low, high].
  FlatKnots Flatten(double low, double high) const
  {
    return MakeFlatKnots(this->Degree, this->Knots, this->Multiplicities, this->Periodic, low, high);
  }

private:
  /// Flat knots of one period, or of all.
  FlatKnots Flat;
  std::size_t StartKnot = 0;
  std::size_t EndKnot = 0;
  int Count = 0;
};
}

#endif
