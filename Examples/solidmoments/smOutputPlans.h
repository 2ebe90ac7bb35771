/**
 * @file smOutputPlans.h
 * @brief What a job writes besides the results, decided before these are sent, as its messages go with them
 */
#ifndef smOutputPlans_h
#define smOutputPlans_h

#include "smRobotFile.h"
#include "smValidationFile.h"

#include <array>

class vtkCADReader;
class vtkMassPropertiesBase;
class vtkPartitionedDataSetCollection;

namespace sm
{
class MessageList;
struct FileResult;
struct JobOptions;

struct OutputPlans
{
  /// Is subtracted from the points of --mesh.
  std::array<double, 3> MeshOrigin{};
  sm::Robot Robot;
  ValidationPlan Validation;
};

/// Returns the bodies that are written as triangles and drawn: those that --only and --materials leave.
vtkPartitionedDataSetCollection* GetShownBodies(
  vtkCADReader* reader, vtkMassPropertiesBase* filter, const JobOptions& options);

/// Plans the outputs that the options request, after the runs of reader and filter. Adds messages, and flags
/// a result whose triangles would be inside out.
OutputPlans PlanOutputs(vtkCADReader* reader, vtkMassPropertiesBase* filter, const JobOptions& options,
  FileResult& file, MessageList& messages);
}

#endif
