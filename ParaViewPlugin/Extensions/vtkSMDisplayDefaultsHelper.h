/**
 * @class   vtkSMDisplayDefaultsHelper
 * @brief   gives properties of a new representation other defaults than the representation that it is derived
 * from
 *
 * In the hints of the representation:
 * @code{xml}
 * <InitializationHelper class="vtkSMDisplayDefaultsHelper">
 *   <Default property="Opacity" values="0.4"/>
 * </InitializationHelper>
 * @endcode
 * Values are numbers or words separated by blanks; those of ColorArrayName are an association (0: points, 1:
 * cells) and the name of an array, or nothing for no array, which is also taken where the input lacks it.
 * Properties that were set explicitly keep their value. XML alone cannot change the default of a property
 * that is exposed from a subproxy.
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
