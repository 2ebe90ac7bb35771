/**
 * @file smGradientBodies.h
 * @brief The solids whose moments are differentiated, with their mass properties
 */
#ifndef smGradientBodies_h
#define smGradientBodies_h

#include "smIntegralEngine.h"
#include "smMassAnalysis.h"
#include "smProgressCallback.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace sm
{
/// Returns a sentence on the first index outside 0 .. count - 1; empty if there is none.
std::string FindWrongIndex(const std::vector<int>& indices, std::size_t count, const char* what);

struct GradientBodies
{
  std::vector<BodyIntegrals> Bodies;
  /// Indices of the bodies in the input.
  std::vector<int> Indices;
  MassAnalysis Analysis;
  /// Status and its reason, and messages about the bodies.
  std::string Status;
  std::string Reason;
  std::vector<std::string> Messages;

  /// Computes the mass properties of the solids with these indices (empty: all) on the CPU. Returns false,
  /// with Status and Reason, if there is no result.
  bool Compute(vtkDataObject* model, const std::vector<int>& solids, double relativeTolerance,
    const ProgressCallback& progress);
  /// Returns 1 or -1 for each face of a body: a factor of its fluxes.
  std::vector<double> GetSides(std::size_t body) const;
};
}

#endif
