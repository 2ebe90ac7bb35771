/**
 * @class   vtkSMConvertSelectionProxy
 * @brief   ParaView's converter of selections, for any output port of a filter
 *
 * ParaView 5.11 converts what the key `b` picks to blocks, and connects the selection by the number of the
 * port whose data is picked. A selection has port 0 only: on every other port the conversion fails with
 * errors, and nothing is selected. This proxy connects port 0.
 */
#ifndef vtkSMConvertSelectionProxy_h
#define vtkSMConvertSelectionProxy_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSMSourceProxy.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMConvertSelectionProxy : public vtkSMSourceProxy
{
public:
  static vtkSMConvertSelectionProxy* New();
  vtkTypeMacro(vtkSMConvertSelectionProxy, vtkSMSourceProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void UpdateVTKObjects() override;

protected:
  vtkSMConvertSelectionProxy();
  ~vtkSMConvertSelectionProxy() override;

private:
  vtkSMConvertSelectionProxy(const vtkSMConvertSelectionProxy&) = delete;
  void operator=(const vtkSMConvertSelectionProxy&) = delete;
};

#endif
