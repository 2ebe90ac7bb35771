/**
 * @file smStabilityJob.h
 * @brief Static stability of the part under gravity in a direction: for JSON, table and picture
 */
#ifndef smStabilityJob_h
#define smStabilityJob_h

#include "smFileJob.h"

#include "vtkSmartPointer.h"

#include <functional>

class vtkAlgorithm;
class vtkPolyData;
class vtkCADReader;

namespace sm
{
class MessageList;

/// Fills `stability` of the total (all solids as one body that rests on its lowest points) and of every solid alone. `update` runs a
/// filter. Returns the drawing for the picture; null when the options have no direction.
vtkSmartPointer<vtkPolyData> FindStability(vtkCADReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages);

/// Sets "bounding_box" and its bound of every solid and of all together.
void AddBoxes(vtkCADReader* reader, Json& file);
}

#endif
