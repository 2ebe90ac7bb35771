#include "smMeshDemand.h"

#include "vtkAlgorithm.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNURBSDataSet.h"

namespace sm
{
namespace
{
bool IsNeededBy(vtkAlgorithm* consumer, int inputPort);

/// `without`: the answer where nothing is connected.
bool IsNeeded(vtkInformation* output, bool without)
{
  vtkInformationExecutivePortVectorKey* key = vtkExecutive::CONSUMERS();
  const int count = output && output->Has(key) ? key->Length(output) : 0;
  bool isPassedOn = false;
  for (int i = 0; i < count; ++i)
  {
    vtkExecutive* executive = key->GetExecutives(output)[i];
    vtkAlgorithm* consumer = executive ? executive->GetAlgorithm() : nullptr;
    if (!consumer)
    {
      continue;
    }
    // ParaView has one behind every output; all that it does is to convert arrays on demand.
    const bool isPassing = consumer->IsA("vtkPVPostFilter");
    if (isPassing ? IsNeeded(executive->GetOutputInformation(0), without)
                  : IsNeededBy(consumer, key->GetPorts(output)[i]))
    {
      return true;
    }
    isPassedOn = true;
  }
  return !isPassedOn && without;
}

bool IsNeededBy(vtkAlgorithm* consumer, int inputPort)
{
  vtkInformation* input = consumer->GetInputPortInformation(inputPort);
  if (!input || !input->Has(vtkNURBSDataSet::EXACT_INPUT()))
  {
    return true;
  }
  for (int port = 0; port < consumer->GetNumberOfOutputPorts(); ++port)
  {
    if (consumer->GetOutputPortInformation(port)->Has(vtkNURBSDataSet::MESH_OUTPUT()) &&
      (consumer->GetInformation()->Has(vtkNURBSDataSet::MESH_REQUESTED()) ||
        IsNeeded(consumer->GetExecutive()->GetOutputInformation(port), false)))
    {
      return true;
    }
  }
  return false;
}
}

void DeclareExactInput(vtkInformation* inputPortInformation)
{
  inputPortInformation->Set(vtkNURBSDataSet::EXACT_INPUT(), 1);
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

bool IsMeshNeeded(vtkInformation* outputInformation)
{
  return IsNeeded(outputInformation, true);
}
}
