/**
 * @class   vtkSMPlaneDefaultsHelper
 * @brief   puts the plane of a new filter, such as Section, through the middle of its input
 *
 * A plane through the origin often runs along a face of the part, where a section has no definite area. A
 * Point that was set keeps its value, also 0 0 0: in the XML its default_values are "none", so that setting
 * any value changes the property, and traces and states in Python always contain it.
 */
#ifndef vtkSMPlaneDefaultsHelper_h
#define vtkSMPlaneDefaultsHelper_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMPlaneDefaultsHelper : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMPlaneDefaultsHelper* New();
  vtkTypeMacro(vtkSMPlaneDefaultsHelper, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMPlaneDefaultsHelper();
  ~vtkSMPlaneDefaultsHelper() override;

private:
  vtkSMPlaneDefaultsHelper(const vtkSMPlaneDefaultsHelper&) = delete;
  void operator=(const vtkSMPlaneDefaultsHelper&) = delete;
};

#endif
