#include "smMeshDemand.h"

#include "vtkAlgorithm.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationExecutivePortVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNURBSDataSet.h"

namespace sm
{
namespace
{
/// Marks the output that is connected to this input. ParaView appends a filter (vtkPVPostFilter) to every
/// output, which only converts arrays on demand; in that case the output before that filter is marked.
void LeaveExactMark(vtkInformation* input)
{
  while (input)
  {
    vtkExecutive* producer = nullptr;
    int port = 0;
    vtkExecutive::PRODUCER()->Get(input, producer, port);
    vtkAlgorithm* algorithm = producer ? producer->GetAlgorithm() : nullptr;
    if (!algorithm || !algorithm->IsA("vtkPVPostFilter"))
    {
      break;
    }
    vtkInformationVector* before =
      algorithm->GetNumberOfInputPorts() > 0 ? producer->GetInputInformation()[0] : nullptr;
    input = before ? before->GetInformationObject(0) : nullptr;
  }
  if (input)
  {
    input->Set(vtkNURBSDataSet::EXACT_MARK(), 1);
  }
}

/// Returns true if something is connected to an output with the mesh other than `port`. This matters because
/// mappers that draw one port call Update() of their filter, which asks for port 0. A consumer that was
/// deleted without being disconnected still counts, so that a mesh is made which nobody uses.
bool IsOtherMeshOutputConnected(vtkAlgorithm* filter, vtkInformationVector* outputs, int port)
{
  for (int i = 0; i < filter->GetNumberOfOutputPorts(); ++i)
  {
    vtkInformation* output = outputs->GetInformationObject(i);
    if (i != port && output && filter->GetOutputPortInformation(i)->Has(vtkNURBSDataSet::MESH_OUTPUT()) &&
      vtkExecutive::CONSUMERS()->Length(output) > 0)
    {
      return true;
    }
  }
  return false;
}
}

void DeclareMeshOutput(vtkInformation* outputPortInformation)
{
  outputPortInformation->Set(vtkNURBSDataSet::MESH_OUTPUT(), 1);
}

void RequestMeshOutput(vtkAlgorithm* filter, int port)
{
  if (port >= 0 && port < filter->GetNumberOfOutputPorts() &&
    filter->GetOutputPortInformation(port)->Has(vtkNURBSDataSet::MESH_OUTPUT()))
  {
    filter->GetInformation()->Set(vtkNURBSDataSet::MESH_REQUESTED(), 1);
  }
}

bool TakeExactMark(vtkInformation* outputInformation)
{
  const bool isMarked = outputInformation && outputInformation->Has(vtkNURBSDataSet::EXACT_MARK());
  if (isMarked)
  {
    outputInformation->Remove(vtkNURBSDataSet::EXACT_MARK());
  }
  return isMarked;
}

void PassMeshDemand(
  vtkAlgorithm* filter, vtkInformationVector** inputs, vtkInformationVector* outputs, int port)
{
  const bool isMarked = port >= 0 && TakeExactMark(outputs->GetInformationObject(port));
  const bool isMeshOutput =
    port >= 0 && filter->GetOutputPortInformation(port)->Has(vtkNURBSDataSet::MESH_OUTPUT());
  if (filter->GetInformation()->Has(vtkNURBSDataSet::MESH_REQUESTED()) || (isMeshOutput && !isMarked) ||
    IsOtherMeshOutputConnected(filter, outputs, port))
  {
    return;
  }
  for (int i = 0; i < filter->GetNumberOfInputPorts(); ++i)
  {
    for (int j = 0; j < inputs[i]->GetNumberOfInformationObjects(); ++j)
    {
      LeaveExactMark(inputs[i]->GetInformationObject(j));
    }
  }
}
}
