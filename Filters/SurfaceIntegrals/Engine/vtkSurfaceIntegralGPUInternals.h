/**
 * @file vtkSurfaceIntegralGPUInternals.h
 * @brief Integrands and last results of vtkSurfaceIntegralGPU; not installed
 */
#ifndef vtkSurfaceIntegralGPUInternals_h
#define vtkSurfaceIntegralGPUInternals_h

#include "smIntegrand.h"
#include "vtkSurfaceIntegralGPU.h"

#include <cstdint>
#include <map>
#include <set>
#include <utility>

struct vtkSurfaceIntegralGPU::Internals
{
  /// Integrands of the Add…() methods and of the text. Expressions are translated with the constants of the
  /// run.
  std::vector<sm::Integrand> Added;
  std::vector<sm::Integrand> OfText;
  std::string IntegrandText;
  int MomentDegree = -1;
  bool BendingEnergy = false;
  double ProjectedAreaDirection[3] = { 0.0, 0.0, 0.0 };
  sm::UserExpression::Constants Constants;
  /// Entity numbers of the faces to integrate over; empty: all.
  std::set<std::int64_t> FaceIds;

  /// Integrands of the last run, and totals with their bounds by name.
  std::vector<sm::Integrand> Integrated;
  std::map<std::string, std::pair<double, double>> Totals;

  /// All integrands, in the order of the outputs.
  std::vector<sm::Integrand> GetIntegrands() const;
};

#endif
