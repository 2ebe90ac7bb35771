#include "smOutputPlans.h"

#include "smFailureReason.h"
#include "smFileJob.h"
#include "smFilterSetUp.h"
#include "smMassPropertyNames.h"
#include "smMeshOrigin.h"
#include "smMessageList.h"
#include "smProductBodies.h"
#include "smProducts.h"
#include "smResults.h"

#include "vtkCADReader.h"
#include "vtkMassPropertiesBase.h"
#include "vtkPartitionedDataSetCollection.h"

#include <new>

namespace sm
{
vtkPartitionedDataSetCollection* GetShownBodies(
  vtkCADReader* reader, vtkMassPropertiesBase* filter, const JobOptions& options)
{
  return vtkPartitionedDataSetCollection::SafeDownCast(options.Only.empty() && !options.LeavesOut()
      ? reader->GetOutputDataObject(0)
      : filter->GetOutputDataObject(5));
}

namespace
{
/// Returns the origin of the mesh that is written, and adds a message if it is not 0.
std::array<double, 3> PlaceMesh(
  vtkCADReader* reader, vtkMassPropertiesBase* filter, const JobOptions& options, MessageList& messages)
{
  vtkPartitionedDataSetCollection* bodies = GetShownBodies(reader, filter, options);
  if (options.MeshName.empty() || !bodies)
  {
    return {};
  }
  const MeshOrigin origin =
    FindMeshOrigin(bodies, reader->GetLengthUnit(), options.Deflection, options.MeshName);
  if (!origin.Message.empty())
  {
    messages.AddEcho(origin.Message);
  }
  return origin.Origin;
}

/// Returns the robot to write, and adds its messages.
Robot PlanRobot(
  vtkCADReader* reader, const FileResult& file, const JobOptions& options, MessageList& messages)
{
  if (options.RobotName.empty())
  {
    return {};
  }
  Robot robot = MakeFileRobot(reader->GetOutputDataObject(0), file.GetProduct(), options);
  for (const std::string& message : robot.Messages)
  {
    messages.AddEcho("robot: " + message);
  }
  return robot;
}

/// Flags a result whose triangles are written inside out.
void CheckTriangles(const JobOptions& options, FileResult& file, MessageList& messages)
{
  const bool areWritten = !options.MeshName.empty() || !options.RobotName.empty();
  if (areWritten && file.Total.FlippedShells > 0)
  {
    messages.AddEcho("the triangles of --mesh and --robot take shells that are inside out as the file "
                     "orients them: correct the file");
    AddStatus(names::StatusSuspect, file);
  }
}

/// Returns what --write-validation writes, and adds its message.
ValidationPlan PlanValidationOf(
  vtkCADReader* reader, const FileResult& file, const JobOptions& options, MessageList& messages)
{
  if (options.ValidationTarget.empty())
  {
    return {};
  }
  ValidationPlan plan;
  try
  {
    plan = PlanValidation(options.GetSource(), MakeProductTree(reader->GetOutputDataObject(0)),
      file.GetProduct(), FindLeftOutNote(reader->GetOutputDataObject(0)));
  }
  catch (const std::bad_alloc&)
  {
    // The result does not depend on it.
    plan.Problem = InsufficientMemory;
  }
  if (!plan.Message.empty())
  {
    messages.AddEcho(plan.Message);
  }
  return plan;
}
}

OutputPlans PlanOutputs(vtkCADReader* reader, vtkMassPropertiesBase* filter, const JobOptions& options,
  FileResult& file, MessageList& messages)
{
  CheckTriangles(options, file, messages);
  return { PlaceMesh(reader, filter, options, messages), PlanRobot(reader, file, options, messages),
    PlanValidationOf(reader, file, options, messages) };
}
}
