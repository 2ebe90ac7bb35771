/**
 * @file smUserIntegrals.h
 * @brief Integrals beside the mass properties: moments and expressions of the user
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

/// Highest degree of moments that a user may ask for.
constexpr int LargestMomentDegree = 16;

/// Splits "NAME=EXPR"; false when a part is missing.
bool ParseIntegral(const std::string& text, std::string& name, std::string& expression);

/// A name that two integrals, or an integral and another column of the results, would share; empty when there is none.
std::string FindClash(const JobOptions& options);

/// Gives a filter what all filters of a job share: limits and backend.
void SetUpFilter(vtkSurfaceIntegralBase* filter, const JobOptions& options);

/// Gives a filter the densities and materials.
void SetUpMass(vtkMassPropertiesBase* filter, const JobOptions& options);

/// Limits the next run of a filter to the seconds that the job has left.
void SetTimeLimit(vtkSurfaceIntegralBase* filter, const JobOptions& options);

/// Adds the integrals, waterlines and sections that the options ask for to the file and each solid, with null for every value.
void AddPlaceholders(const JobOptions& options, Json& file);

/// Adds evaluations, dispatches and messages of a filter's last run to the file's. Its status becomes the file's when that was ok.
void AddEffort(vtkSurfaceIntegralBase* filter, Json& file, MessageList& messages);

/// Computes the integrals that the options ask for into `integrals` of the file and of each solid: {NAME: {"value", "bound"}}, null
/// where it is not known. `update` runs a filter.
void IntegrateUsers(vtkCADReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages);
}

#endif
