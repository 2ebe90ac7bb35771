/**
 * @file vtkSurfaceIntegralGPUInternals.h
 * @brief The integrands of vtkSurfaceIntegralGPU and the results of its last run; not installed
 */
#ifndef vtkSurfaceIntegralGPUInternals_h
#define vtkSurfaceIntegralGPUInternals_h

#include "smIntegrand.h"
#include "vtkSurfaceIntegralGPU.h"

#include <map>
#include <set>
#include <utility>

struct vtkSurfaceIntegralGPU::Internals
{
  /// What Add…() added, and what the lines of the text say. Expressions are translated with the constants of the run.
  std::vector<sm::Integrand> Added;
  std::vector<sm::Integrand> OfText;
  std::string IntegrandText;
  int MomentDegree = -1;
  bool BendingEnergy = false;
  double ProjectedAreaDirection[3] = { 0.0, 0.0, 0.0 };
  sm::UserExpression::Constants Constants;
  /// Entity numbers of the faces to integrate over; empty: all.
  std::set<int> FaceIds;

  /// The integrands of the last run; totals and their bounds, by name.
  std::vector<sm::Integrand> Integrated;
  std::map<std::string, std::pair<double, double>> Totals;

  /// All integrands, in the order of the outputs.
  std::vector<sm::Integrand> GetIntegrands() const;
};

#endif
