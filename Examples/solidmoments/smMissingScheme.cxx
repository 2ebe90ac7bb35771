// Compiled where this build is without the schemes of the paper.
#include "smScheme.h"

#include "vtkMassPropertiesBase.h"

namespace sm
{
const char* Scheme::GetMissingModule()
{
  return "SOLIDMOMENTS_ENABLE_MOMENT_SCHEMES";
}

vtkSmartPointer<vtkMassPropertiesBase> Scheme::MakeFilter() const
{
  return nullptr;
}

void Scheme::ReadOptions(vtkMassPropertiesBase*, FileResult&) {}

void Scheme::ReadBody(vtkFieldData*, vtkIdType, BodyResult&) {}

std::string Scheme::WriteTrimPictures(vtkMassPropertiesBase*, const std::string&)
{
  return {};
}
}
