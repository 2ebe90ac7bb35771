/**
 * @file smStabilityJob.h
 * @brief How the part stands when things fall in a direction: for JSON, for the table, for the picture
 */
#ifndef smStabilityJob_h
#define smStabilityJob_h

#include "smFileJob.h"

#include "vtkSmartPointer.h"

#include <functional>

class vtkAlgorithm;
class vtkPolyData;
class vtkSTEPReader;

namespace sm
{
class MessageList;

/// Fills `stability` of the total (all solids as one body, resting on their lowest points) and of every solid alone. `update` runs a
/// filter. Returns the drawing for the picture; null when it was not asked for.
vtkSmartPointer<vtkPolyData> FindStability(vtkSTEPReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages);
}

#endif
