/**
 * @file smFaceIntegrals.h
 * @brief A face to integrate, and its results
 */
#ifndef smFaceIntegrals_h
#define smFaceIntegrals_h

#include "smFacePanelsCache.h"
#include "smPlacementError.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace sm
{
/// A face to integrate. Its result depends on nothing else.
struct FaceTask
{
  FacePointer Source;
  /// Panels of `Source` if the caller has cut it; null if the integrator is to cut it. The Source of both
  /// must be the same.
  CutFacePointer Cut;
  /// Absolute tolerance of each integrand for this face.
  std::vector<double> Tolerances;
  /// Rows of a 3x4 placement applied to positions and normals; used after SetUsePlacements(true).
  std::array<double, 12> Placement{};
  /// Rounding of that placement.
  PlacementError PlacementBound{};
};

/// The gap along one coedge, the distance of the face's curve from the edge's curve at foot points: integral
/// of its square, integral, and maximum.
struct CoedgeGap
{
  int Loop = 0;
  int Coedge = 0;
  double GapSquared = 0.0;
  double GapArea = 0.0;
  double MaxGap = 0.0;
};

/// Returns the larger of two gaps. std::max is not used here because it may drop a NaN.
inline double GetLargerGap(double a, double b)
{
  return std::isnan(a) || b <= a ? a : b;
}

/// Results of one face, with one entry per integrand. An integrand that the runner cannot evaluate is NaN.
struct FaceIntegrals
{
  /// Integral over the face alone, and over its ribbons and caps.
  std::vector<double> Face;
  std::vector<double> Closing;
  /// Bounds over both: of the quadrature's error (if Estimated, from differences of orders), of the rounding
  /// of every sample, and of the effect of the residuals of converted curves and surfaces.
  std::vector<double> QuadratureError;
  std::vector<double> Rounding;
  std::vector<double> Conversion;
  /// The part of Conversion that is measured, not proved: that of the residuals.
  std::vector<double> Residual;
  double GetBound(std::size_t integrand) const
  {
    return this->QuadratureError[integrand] + this->Rounding[integrand] + this->Conversion[integrand];
  }
  /// Appends an integrand whose entries all have this value.
  void Append(double value)
  {
    for (std::vector<double>* values : { &this->Face, &this->Closing, &this->QuadratureError, &this->Rounding,
           &this->Conversion, &this->Residual })
    {
      values->push_back(value);
    }
  }
  /// True if the bound of the area, or of an integrand whose orders cannot be planned (an expression), is
  /// estimated and not proved.
  bool Estimated = false;
  /// True if the run was stopped before this face: its integrals are 0, with their largest possible magnitude
  /// as error.
  bool Skipped = false;
  /// True if the bound of some integral would have been larger than its largest possible magnitude, which is
  /// its error instead: it is 0.
  bool LeftOut = false;
  /// Gaps between all coedges and their edges at foot points: integral of the square, integral, and maximum.
  double GapSquared = 0.0;
  double GapArea = 0.0;
  double MaxGap = 0.0;
  /// Gap of every coedge that was measured.
  std::vector<CoedgeGap> Gaps;
  int CoverageDefects = 0;
  /// As FacePanels::Overlap.
  double Overlap = 0.0;
  /// Trim curves beyond the surface's domain. True if the surface is continued to them; the paper's schemes
  /// integrate nothing there.
  Overhang Outside;
  bool IsContinued = false;
  /// Reason why the face could not be integrated, in which case everything else is zero; empty otherwise.
  std::string Error;
};
}

#endif
