/**
 * @file smUserIntegrals.h
 * @brief Further integrals: moments and expressions of the user
 */
#ifndef smUserIntegrals_h
#define smUserIntegrals_h

#include "smFileJob.h"

#include <functional>

class vtkAlgorithm;
class vtkCADReader;
class vtkMassPropertiesBase;
class vtkSurfaceIntegralBase;

namespace sm
{
class MessageList;

/// Highest degree of moments that the options accept.
constexpr int LargestMomentDegree = 16;

/// Splits "NAME=EXPR"; returns false if a part is missing.
bool ParseIntegral(const std::string& text, std::string& name, std::string& expression);

/// Returns a name that two integrals, or an integral and another column of the results, would share; empty if there is none.
std::string FindClash(const JobOptions& options);

/// Sets the limits and the backend of a filter, which all filters of a job share.
void SetUpFilter(vtkSurfaceIntegralBase* filter, const JobOptions& options);

/// Sets the densities and materials of a filter.
void SetUpMass(vtkMassPropertiesBase* filter, const JobOptions& options);

/// Limits the next run of a filter to the seconds that the job has left.
void SetTimeLimit(vtkSurfaceIntegralBase* filter, const JobOptions& options);

/// Adds entries for the integrals, waterlines and sections of the options to the file and each solid, with null for every value.
void AddPlaceholders(const JobOptions& options, Json& file);

/// Adds evaluations, dispatches and messages of a filter's last run to the file's. If the file was ok, it gets the status of the filter.
void AddEffort(vtkSurfaceIntegralBase* filter, Json& file, MessageList& messages);

/// Computes the integrals of the options into `integrals` of the file and of each solid: {NAME: {"value", "bound"}}, null
/// where it is not known. `update` runs a filter.
void IntegrateUsers(vtkCADReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages);
}

#endif
