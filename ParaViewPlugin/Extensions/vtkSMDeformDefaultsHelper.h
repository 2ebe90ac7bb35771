/**
 * @class   vtkSMDeformDefaultsHelper
 * @brief   gives a new NURBS Deform a region for the size of its input, in which nothing moves until the user
 * says so
 *
 * The region is a sphere at the middle of the input's box, with a quarter of its diagonal as radius. A script
 * that sets the displacement, the centre or the radius when it makes the filter keeps the defaults of the
 * others: with a radius of 0 everything moves. The rows of the lattice are those of its top, with
 * displacements of 0. For 0 0 0 the displacement has "none" as its default_values, as
 * vtkSMPlaneDefaultsHelper.h explains.
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
