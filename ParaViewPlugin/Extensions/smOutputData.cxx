#include "smOutputData.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"

namespace sm
{
vtkDataObject* GetOutputData(vtkObject* object, int port)
{
  if (auto* data = vtkDataObject::SafeDownCast(object))
  {
    return data;
  }
  auto* output = vtkAlgorithmOutput::SafeDownCast(object);
  auto* algorithm = output ? output->GetProducer() : vtkAlgorithm::SafeDownCast(object);
  if (!algorithm)
  {
    return nullptr;
  }
  // vtkAlgorithm::GetOutputDataObject() is not used, because it runs a pass of the pipeline, which may report
  // errors.
  vtkInformation* info = algorithm->GetExecutive()->GetOutputInformation(output ? output->GetIndex() : port);
  return info ? vtkDataObject::GetData(info) : nullptr;
}
}
