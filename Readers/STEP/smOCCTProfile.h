/**
 * @file smOCCTProfile.h
 * @brief The profile curve of a surface of revolution or extrusion, as a rational B-spline
 */
#ifndef smOCCTProfile_h
#define smOCCTProfile_h

#include "smOCCTParameterMap.h"

#include <Geom_Curve.hxx>

#include <array>
#include <vector>

namespace sm
{
/// A curve as a rational B-spline in kernel coordinates: homogeneous (w x, w y, w z, w).
struct Profile
{
  int Degree = 1;
  std::vector<double> Knots;
  std::vector<std::array<double, 4>> Poles;
  ParameterMap Map;
  double Residual = 0.0;
};
Profile ConvertProfile(const Handle(Geom_Curve) & curve, double low, double high);
}

#endif
