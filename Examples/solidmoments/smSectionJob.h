/**
 * @file smSectionJob.h
 * @brief Sections with the planes of the options, as JSON
 */
#ifndef smSectionJob_h
#define smSectionJob_h

#include "smFileJob.h"

#include <functional>

class vtkAlgorithm;
class vtkCADReader;

namespace sm
{
class MessageList;

/// Fills `sections` of the file and of each solid, null where a value is not known (AddPlaceholders() has the keys). If the file was ok, it
/// gets the status of the filter. `update` runs a filter.
void IntegrateSections(vtkCADReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages);
}

#endif
