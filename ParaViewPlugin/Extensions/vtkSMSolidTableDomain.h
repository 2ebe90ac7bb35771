/**
 * @class   vtkSMSolidTableDomain
 * @brief   accepts tables with a column of length units, as the filters over surface integrals make them
 *
 * For the input property of the writer of such tables: `<SolidTableDomain name="solid_table"/>`.
 */
#ifndef vtkSMSolidTableDomain_h
#define vtkSMSolidTableDomain_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSMDomain.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMSolidTableDomain : public vtkSMDomain
{
public:
  static vtkSMSolidTableDomain* New();
  vtkTypeMacro(vtkSMSolidTableDomain, vtkSMDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** IN_DOMAIN when the property has (unchecked) inputs and every one is such a table. */
  int IsInDomain(vtkSMProperty* property) override;

protected:
  vtkSMSolidTableDomain();
  ~vtkSMSolidTableDomain() override;

private:
  vtkSMSolidTableDomain(const vtkSMSolidTableDomain&) = delete;
  void operator=(const vtkSMSolidTableDomain&) = delete;
};

#endif
