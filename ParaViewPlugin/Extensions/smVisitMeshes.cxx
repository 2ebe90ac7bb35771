#include "smVisitMeshes.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace sm
{
namespace
{
void Visit(vtkDataObject* data, const std::string& name, bool isShown,
  vtkCompositeDataDisplayAttributes* attributes,
  const std::function<void(vtkPolyData*, const std::string&)>& visit)
{
  if (attributes && data && attributes->HasBlockVisibility(data))
  {
    isShown = attributes->GetBlockVisibility(data);
  }
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    if (isShown)
    {
      visit(mesh, name);
    }
  }
  else if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    const auto blocks = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    blocks->VisitOnlyLeavesOff();
    blocks->TraverseSubTreeOff();
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      const char* own = blocks->HasCurrentMetaData()
        ? blocks->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME())
        : nullptr;
      Visit(blocks->GetCurrentDataObject(), own && *own ? own : name, isShown, attributes, visit);
    }
  }
}
}

void VisitMeshes(vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes,
  const std::function<void(vtkPolyData* mesh, const std::string& name)>& visit)
{
  Visit(data, {}, true, attributes, visit);
}
}
