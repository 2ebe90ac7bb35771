/**
 * @file smUserIntegrals.h
 * @brief What a user asked for besides mass properties: moments, expressions of one's own, and what waterlines displace
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

/// Highest degree of moments that may be asked for.
constexpr int LargestMomentDegree = 16;

/// "NAME=EXPR" taken apart; false when a part is missing.
bool ParseIntegral(const std::string& text, std::string& name, std::string& expression);

/// A name that two of the integrals would have, or an integral and another column of the results; empty when none.
std::string FindClash(const JobOptions& options);

/// Gives a filter what all filters of a job share: tolerance, budgets and backend.
void SetUpFilter(vtkSurfaceIntegralGPU* filter, const JobOptions& options);

/// Computes the integrals that the options ask for into `integrals` of the file and of each solid: {NAME: {"value",
/// "bound"}}, null where it is not known; and what is below the waterlines into `waterlines` of each, a list of {"height", "up",
/// "volume", "center", "bounds": {"volume", "center"}}. A flag of theirs becomes the file's when that was ok. `update` runs a filter.
void IntegrateUsers(vtkSTEPReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages);
}

#endif
