#include "Detail/smLeaves.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

namespace sm
{
bool CopyLeaves(vtkDataObject* input, vtkDataObject* output,
  const std::function<bool(vtkPointSet* source, vtkPointSet* copy)>& change,
  const std::function<bool(double share)>& report)
{
  auto* inputTree = vtkCompositeDataSet::SafeDownCast(input);
  auto* outputTree = vtkCompositeDataSet::SafeDownCast(output);
  if (!inputTree)
  {
    output->ShallowCopy(input);
    auto* source = vtkPointSet::SafeDownCast(input);
    return (!source || change(source, vtkPointSet::SafeDownCast(output))) && report(1.0);
  }
  if (!outputTree)
  {
    return false;
  }
  outputTree->CopyStructure(inputTree);
  outputTree->GetFieldData()->PassData(inputTree->GetFieldData());
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(inputTree->NewIterator());
  double total = 0.0;
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    total += 1.0;
  }
  double done = 0.0;
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    const auto copy = vtkSmartPointer<vtkDataObject>::Take(leaf->NewInstance());
    copy->ShallowCopy(leaf);
    auto* source = vtkPointSet::SafeDownCast(leaf);
    if (source && !change(source, vtkPointSet::SafeDownCast(copy)))
    {
      return false;
    }
    outputTree->SetDataSet(iterator, copy);
    done += 1.0;
    if (!report(done / total))
    {
      return false;
    }
  }
  return true;
}
}
