/**
 * @file smUserIntegrals.h
 * @brief Integrals beside the mass properties: moments, expressions of the user, and the volume below waterlines
 */
#ifndef smUserIntegrals_h
#define smUserIntegrals_h

#include "smFileJob.h"

#include <functional>

class vtkAlgorithm;
class vtkSTEPReader;
class vtkSurfaceIntegralGPU;

namespace sm
{
class MessageList;

/// Highest degree of moments that a user may ask for.
constexpr int LargestMomentDegree = 16;

/// Splits "NAME=EXPR"; false when a part is missing.
bool ParseIntegral(const std::string& text, std::string& name, std::string& expression);

/// A name that two integrals, or an integral and another column of the results, would share; empty when there is none.
std::string FindClash(const JobOptions& options);

/// Sets the options that all filters of a job share: tolerance, budgets and backend.
void SetUpFilter(vtkSurfaceIntegralGPU* filter, const JobOptions& options);

/// Computes the integrals that the options ask for into `integrals` of the file and of each solid: {NAME: {"value",
/// "bound"}}, null where a value is not known; and what is below the waterlines into `waterlines` of each, a list of {"height", "up",
/// "volume", "center", "bounds": {"volume", "center"}}. A status that is not ok becomes the file's when that was ok. `update` runs a
/// filter.
void IntegrateUsers(vtkSTEPReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages);
}

#endif
