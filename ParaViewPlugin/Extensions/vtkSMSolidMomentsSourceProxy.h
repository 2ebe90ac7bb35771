/**
 * @class   vtkSMSolidMomentsSourceProxy
 * @brief   proxy of our reader and filters: what they need on the client however they were made
 *
 * In the plugin's XML `<SolidMomentsSourceProxy>` stands where ParaView's own have `<SourceProxy>`. Unlike an InitializationHelper in
 * the hints, which runs for proxies made by Apply or a script, it is there for those of a loaded state as well. It gives
 * - rows selected in the table of a mass filter that highlight their solids (smSolidHighlight.h), where the hints say so:
 * @code{xml}
 * <HighlightRows table="1" meshes="5"/>
 * @endcode
 * - the key Esc in ParaView's window, which stops a run that goes on in this process (smEscapeKey.h). ParaView 5.11 enables its
 *   own button beside the progress never. The status bar says so while it can: "Mass Properties (GPU), Esc stops it". What runs on a
 *   server cannot hear the client before it has ended: limit it by its property MaximumSeconds.
 */
#ifndef vtkSMSolidMomentsSourceProxy_h
#define vtkSMSolidMomentsSourceProxy_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSMSourceProxy.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMSolidMomentsSourceProxy : public vtkSMSourceProxy
{
public:
  static vtkSMSolidMomentsSourceProxy* New();
  vtkTypeMacro(vtkSMSolidMomentsSourceProxy, vtkSMSourceProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSMSolidMomentsSourceProxy();
  ~vtkSMSolidMomentsSourceProxy() override;

  void CreateVTKObjects() override;

private:
  vtkSMSolidMomentsSourceProxy(const vtkSMSolidMomentsSourceProxy&) = delete;
  void operator=(const vtkSMSolidMomentsSourceProxy&) = delete;
};

#endif
