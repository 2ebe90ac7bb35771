/**
 * @class   vtkSMDisplayDefaultsHelper
 * @brief   gives the properties of a new representation other defaults than those of the one it is derived from
 *
 * In the hints of the representation:
 * @code{xml}
 * <InitializationHelper class="vtkSMDisplayDefaultsHelper">
 *   <Default property="Opacity" values="0.4"/>
 * </InitializationHelper>
 * @endcode
 * Values are numbers or words between blanks; none makes the representation's ColorArrayName no array. What somebody set before is
 * left alone. Defaults of properties that a representation exposes from a subproxy cannot be changed in XML.
 */
#ifndef vtkSMDisplayDefaultsHelper_h
#define vtkSMDisplayDefaultsHelper_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMDisplayDefaultsHelper : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMDisplayDefaultsHelper* New();
  vtkTypeMacro(vtkSMDisplayDefaultsHelper, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMDisplayDefaultsHelper();
  ~vtkSMDisplayDefaultsHelper() override;

private:
  vtkSMDisplayDefaultsHelper(const vtkSMDisplayDefaultsHelper&) = delete;
  void operator=(const vtkSMDisplayDefaultsHelper&) = delete;
};

#endif
