/**
 * @class   vtkSMDeformDefaultsHelper
 * @brief   gives a new NURBS Deform values for the size of its input, so that the first Apply changes
 * something
 *
 * The displacement is a tenth of the input's height along z. The points of the top of the lattice move by a
 * tenth of its length along x, which shears the solid without opening it. Properties that were set keep their
 * values; for 0 0 0 the displacement has "none" as its default_values, as vtkSMPlaneDefaultsHelper.h
 * explains.
 */
#ifndef vtkSMDeformDefaultsHelper_h
#define vtkSMDeformDefaultsHelper_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMDeformDefaultsHelper : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMDeformDefaultsHelper* New();
  vtkTypeMacro(vtkSMDeformDefaultsHelper, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMDeformDefaultsHelper();
  ~vtkSMDeformDefaultsHelper() override;

private:
  vtkSMDeformDefaultsHelper(const vtkSMDeformDefaultsHelper&) = delete;
  void operator=(const vtkSMDeformDefaultsHelper&) = delete;
};

#endif
