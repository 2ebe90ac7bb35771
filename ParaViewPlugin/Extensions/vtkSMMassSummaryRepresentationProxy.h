/**
 * @class   vtkSMMassSummaryRepresentationProxy
 * @brief   proxy of a summary, which keeps the heading: the names of the filter in the pipeline and of the
 * file that it reads
 */
#ifndef vtkSMMassSummaryRepresentationProxy_h
#define vtkSMMassSummaryRepresentationProxy_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSMRepresentationProxy.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMMassSummaryRepresentationProxy : public vtkSMRepresentationProxy
{
public:
  static vtkSMMassSummaryRepresentationProxy* New();
  vtkTypeMacro(vtkSMMassSummaryRepresentationProxy, vtkSMRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ViewUpdated(vtkSMProxy* view) override;

protected:
  vtkSMMassSummaryRepresentationProxy();
  ~vtkSMMassSummaryRepresentationProxy() override;

private:
  vtkSMMassSummaryRepresentationProxy(const vtkSMMassSummaryRepresentationProxy&) = delete;
  void operator=(const vtkSMMassSummaryRepresentationProxy&) = delete;
};

#endif
