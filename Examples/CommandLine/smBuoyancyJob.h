/**
 * @file smBuoyancyJob.h
 * @brief Buoyancy below the waterlines that a user asked for, as JSON
 */
#ifndef smBuoyancyJob_h
#define smBuoyancyJob_h

#include "smFileJob.h"

#include <functional>

class vtkAlgorithm;
class vtkCADReader;

namespace sm
{
class MessageList;

/// Fills `waterlines` of the file and of each solid, a list of {"height", "up", "volume", "center", "bounds": {"volume", "center"}},
/// null where it is not known. A flag of theirs becomes the file's when that was ok. `update` runs a filter.
void IntegrateBelowWaterlines(vtkCADReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages);
}

#endif
