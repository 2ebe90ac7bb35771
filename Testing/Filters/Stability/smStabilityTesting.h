/**
 * @file smStabilityTesting.h
 * @brief A filter on a file, and checks of its verdict and of values within their bounds, for the tests of
 * vtkSolidStability
 */
#ifndef smStabilityTesting_h
#define smStabilityTesting_h

#include "smStabilityNames.h"
#include "smTestPipeline.h"

#include <vtkSolidStability.h>

#include <cmath>

namespace smtest
{
constexpr double Degrees = 180.0 / 3.14159265358979323846;

struct Case
{
  vtkNew<vtkSTEPReader> Reader;
  vtkNew<vtkSolidStability> Filter;

  explicit Case(const std::string& path)
  {
    this->Reader->SetFileName(path.c_str());
    this->Filter->SetInputConnection(this->Reader->GetOutputPort());
  }
};

inline double Get(vtkSolidStability* filter, const std::string& name, int component = 0)
{
  return GetField(filter->GetOutput()->GetFieldData(), name, component);
}

inline std::string GetText(vtkSolidStability* filter, const char* name)
{
  return GetFieldText(filter->GetOutput()->GetFieldData(), name);
}

/// |value - exact| <= bound, and the bound is worth having.
inline void CheckBounded(vtkSolidStability* filter, const char* name, double exact, double maximum)
{
  const double bound = Get(filter, std::string(name) + sm::names::BoundSuffix);
  Check(name, exact, Get(filter, name), bound, "its own bound");
  CheckRange(std::string(name) + "Bound", 0.0, bound, maximum, "no vacuous bound");
}

inline void CheckVerdict(const std::string& what, vtkSolidStability* filter, const char* verdict,
  const char* support, const char* decider)
{
  CheckEqual(what, verdict, filter->GetStability());
  CheckEqual(what + ", support", support, filter->GetSupport());
  CheckEqual(what + ", decided by", decider, GetText(filter, sm::names::DecidedBy));
}

/// Margin m and height z on level ground, with the angle and the work that follow.
inline void CheckStanding(vtkSolidStability* filter, double m, double z, double size, double relative = 1e-8)
{
  CheckBounded(filter, sm::names::StabilityMargin, m, relative * size);
  CheckBounded(filter, sm::names::CenterHeight, z, 1e-8 * size);
  CheckBounded(filter, sm::names::TipAngle, std::atan2(m, z) * Degrees, 10.0 * Degrees * relative * size / z);
  CheckBounded(filter, sm::names::CenterOfMassRise, std::hypot(m, z) - z, 10.0 * relative * size);
}
}

#endif
