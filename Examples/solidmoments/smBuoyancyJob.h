/**
 * @file smBuoyancyJob.h
 * @brief Buoyancy below the waterlines of the options, as JSON
 */
#ifndef smBuoyancyJob_h
#define smBuoyancyJob_h

#include "smFileJob.h"

#include "vtkType.h"

#include <functional>

class vtkAlgorithm;
class vtkCADReader;
class vtkFieldData;
class vtkPlaneCutBase;

namespace sm
{
class MessageList;

/// Writes a row of field data or of a table into the entry of the file or of a solid.
using RowWriter = std::function<void(vtkFieldData* data, vtkIdType row, Json& entry)>;

/// Runs a filter that cuts the solids by the plane that it is given, and adds its results to the file and to each solid. If the file was
/// ok, it gets the status of the filter. `update` runs a filter.
void RunPlaneCut(vtkCADReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, vtkPlaneCutBase* filter, const RowWriter& write,
  Json& file, MessageList& messages);

/// Fills `waterlines` of the file and of each solid, a list of {"height", "up", "volume", "center", "bounds": {"volume", "center"}},
/// null where it is not known, by RunPlaneCut().
void IntegrateBelowWaterlines(vtkCADReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages);
}

#endif
