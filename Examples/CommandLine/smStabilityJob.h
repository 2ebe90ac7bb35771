/**
 * @file smStabilityJob.h
 * @brief Static stability of the part under gravity in a direction: for JSON, table and picture
 */
#ifndef smStabilityJob_h
#define smStabilityJob_h

#include "smFileJob.h"

#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <string>

class vtkAlgorithm;
class vtkPolyData;
class vtkSTEPReader;

namespace sm
{
class MessageList;

/// Parses "x", "+y", "-z", or three numbers, "0,0.1,-1"; false when the text is neither, or all three are 0.
bool ParseDirection(const std::string& text, std::array<double, 3>& direction);

/// Fills `stability` of the total (all solids as one body that rests on its lowest points) and of every solid alone. `update` runs a
/// filter. Returns the drawing for the picture; null when the options have no direction.
vtkSmartPointer<vtkPolyData> FindStability(vtkSTEPReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages);
}

#endif
