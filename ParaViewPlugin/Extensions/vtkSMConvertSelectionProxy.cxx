#include "vtkSMConvertSelectionProxy.h"

#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"

vtkStandardNewMacro(vtkSMConvertSelectionProxy);

vtkSMConvertSelectionProxy::vtkSMConvertSelectionProxy() = default;
vtkSMConvertSelectionProxy::~vtkSMConvertSelectionProxy() = default;

void vtkSMConvertSelectionProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkSMConvertSelectionProxy::UpdateVTKObjects()
{
  vtkSMPropertyHelper input(this, "Input");
  if (input.GetNumberOfElements() == 1 && input.GetOutputPort() != 0)
  {
    input.Set(input.GetAsProxy(), 0);
  }
  this->Superclass::UpdateVTKObjects();
}
