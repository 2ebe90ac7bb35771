#include "vtkSMMassSummaryRepresentationProxy.h"

#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"

#include <string>

vtkStandardNewMacro(vtkSMMassSummaryRepresentationProxy);

namespace
{
vtkSMProxy* GetInput(vtkSMProxy* proxy)
{
  vtkSMProperty* input = proxy->GetProperty("Input");
  return input ? vtkSMPropertyHelper(input).GetAsProxy() : nullptr;
}

/// Returns the name of the file that the first inputs lead to, without its folder; empty where there is none.
std::string FindFile(vtkSMProxy* source)
{
  for (; source; source = GetInput(source))
  {
    if (vtkSMProperty* file = source->GetProperty("FileName"))
    {
      const char* path = vtkSMPropertyHelper(file, true).GetAsString();
      const std::string text = path ? path : "";
      return text.substr(text.find_last_of("/\\") + 1);
    }
  }
  return {};
}
}

vtkSMMassSummaryRepresentationProxy::vtkSMMassSummaryRepresentationProxy() = default;
vtkSMMassSummaryRepresentationProxy::~vtkSMMassSummaryRepresentationProxy() = default;

void vtkSMMassSummaryRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkSMMassSummaryRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  this->Superclass::ViewUpdated(view);
  vtkSMProxy* filter = GetInput(this);
  vtkSMProperty* heading = this->GetProperty("Heading");
  if (!filter || !heading)
  {
    return;
  }
  const char* registered = this->GetSessionProxyManager()->GetProxyName("sources", filter);
  const std::string file = FindFile(filter);
  std::string text = registered ? registered : filter->GetXMLLabel();
  text += file.empty() ? "" : " of " + file;
  vtkSMPropertyHelper helper(heading);
  if (text != helper.GetAsString())
  {
    helper.Set(text.c_str());
    this->UpdateVTKObjects();
  }
}
