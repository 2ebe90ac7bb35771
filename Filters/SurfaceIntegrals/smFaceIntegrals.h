/**
 * @file smFaceIntegrals.h
 * @brief One face to integrate, and what came of it
 */
#ifndef smFaceIntegrals_h
#define smFaceIntegrals_h

#include "smFacePanelsCache.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace sm
{
/// One face to integrate. Its result depends on nothing but this.
struct FaceTask
{
  FacePointer Source;
  /// Not null: what `Source` is cut into, by somebody else; its Source is the same.
  CutFacePointer Cut;
  /// Absolute tolerance of each integrand for this face.
  std::vector<double> Tolerances;
  /// Rows of a 3x4 placement applied to positions and normals; used when SetUsePlacements(true).
  std::array<double, 12> Placement{};
};

/// The gap between one use of an edge and its curve, at foot points: integral of the square, of the gap, and the largest.
struct CoedgeGap
{
  int Loop = 0;
  int Coedge = 0;
  double GapSquared = 0.0;
  double GapArea = 0.0;
  double MaxGap = 0.0;
};

/// Not std::max, which loses a NaN.
inline double GetLargerGap(double a, double b)
{
  return std::isnan(a) || b <= a ? a : b;
}

/// Results of one face, one entry per integrand. NaN for an integrand that the runner cannot evaluate.
struct FaceIntegrals
{
  /// Integral over the face alone, and over its ribbons and caps.
  std::vector<double> Face;
  std::vector<double> Closing;
  /// Bounds, over both: of the quadrature's error (where Estimated: from differences of orders), of the rounding of
  /// every sample, and of what the residuals of converted curves and surfaces may move.
  std::vector<double> QuadratureError;
  std::vector<double> Rounding;
  std::vector<double> Conversion;
  double GetBound(std::size_t integrand) const
  {
    return this->QuadratureError[integrand] + this->Rounding[integrand] + this->Conversion[integrand];
  }
  /// Adds an integrand, with this number for all of its entries.
  void Append(double value)
  {
    for (std::vector<double>* values :
      { &this->Face, &this->Closing, &this->QuadratureError, &this->Rounding, &this->Conversion })
    {
      values->push_back(value);
    }
  }
  /// The bound of the area, or of an integrand without a theory, is no theorem.
  bool Estimated = false;
  /// The run was stopped before this face: its integrals are 0, with their largest possible magnitude as error.
  bool Skipped = false;
  /// Gaps between coedges and their edges, at foot points: integral of the square, of the gap, and the largest.
  double GapSquared = 0.0;
  double GapArea = 0.0;
  double MaxGap = 0.0;
  /// The same for every coedge that was measured.
  std::vector<CoedgeGap> Gaps;
  int CoverageDefects = 0;
  double Outside = 0.0;
  /// Not empty: the face could not be integrated; everything else is zero.
  std::string Error;
};
}

#endif
