#include "vtkSMDisplayDefaultsHelper.h"

#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSourceProxy.h"

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSMDisplayDefaultsHelper);

vtkSMDisplayDefaultsHelper::vtkSMDisplayDefaultsHelper() = default;
vtkSMDisplayDefaultsHelper::~vtkSMDisplayDefaultsHelper() = default;

void vtkSMDisplayDefaultsHelper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

namespace
{
bool HasArray(vtkSMProxy* representation, const char* array, int association)
{
  vtkSMPropertyHelper input(representation, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  return source && source->GetDataInformation(input.GetOutputPort())->GetArrayInformation(array, association);
}
}

void vtkSMDisplayDefaultsHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp)
{
  for (unsigned int i = 0; i < xml->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* element = xml->GetNestedElement(i);
    const char* name = element->GetAttribute("property");
    vtkSMProperty* property = name ? proxy->GetProperty(name) : nullptr;
    if (std::strcmp(element->GetName(), "Default") != 0 || !property)
    {
      vtkErrorMacro("<" << element->GetName() << " property=\"" << (name ? name : "")
                        << "\"> names no property of " << proxy->GetXMLName() << ".");
      continue;
    }
    if (property->GetMTime() > initializationTimeStamp)
    {
      continue;
    }
    std::istringstream stream(element->GetAttributeOrEmpty("values"));
    std::vector<std::string> values;
    for (std::string value; stream >> value;)
    {
      values.push_back(value);
    }
    vtkSMPropertyHelper helper(property);
    const bool isArray = std::strcmp(name, "ColorArrayName") == 0;
    if (isArray)
    {
      // Association and name.
      const bool isNone =
        values.size() < 2 || !HasArray(proxy, values[1].c_str(), std::atoi(values[0].c_str()));
      helper.SetInputArrayToProcess(
        isNone ? 0 : std::atoi(values[0].c_str()), isNone ? "" : values[1].c_str());
      values.clear();
    }
    for (unsigned int k = 0; k < values.size(); ++k)
    {
      if (vtkSMDoubleVectorProperty::SafeDownCast(property))
      {
        double number = 0.0; // std::atof would expect the locale's decimal point
        std::from_chars(values[k].data(), values[k].data() + values[k].size(), number);
        helper.Set(k, number);
      }
      else if (vtkSMIntVectorProperty::SafeDownCast(property))
      {
        // A number, or the text of an enumeration entry.
        char* end = nullptr;
        const long number = std::strtol(values[k].c_str(), &end, 10);
        *end == '\0' ? helper.Set(k, static_cast<int>(number)) : helper.Set(k, values[k].c_str());
      }
      else
      {
        helper.Set(k, values[k].c_str());
      }
    }
    // Called also if the value did not change, because ParaView sets its own default for properties that are
    // not modified.
    property->Modified();
  }
  proxy->UpdateVTKObjects();
}
