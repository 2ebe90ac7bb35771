#include "vtkSMMaterialTableProperty.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSMMaterialTableProperty);

vtkSMMaterialTableProperty::vtkSMMaterialTableProperty() = default;
vtkSMMaterialTableProperty::~vtkSMMaterialTableProperty() = default;

void vtkSMMaterialTableProperty::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
