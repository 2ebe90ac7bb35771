/**
 * @class   vtkSMSolidHighlightHelper
 * @brief   highlights the solids whose rows are selected in the table of a mass filter
 *
 * In the hints of the filter, with the ports of the table and of the meshes, whose partitioned datasets are in the order of the rows:
 * @code{xml}
 * <InitializationHelper class="vtkSMSolidHighlightHelper" table="1" meshes="5"/>
 * @endcode
 * From then on a selection of rows (by index, as a spreadsheet makes it) selects the blocks, and the render views that show them are
 * rendered again; an empty one clears what was selected so, and leaves what the user selected in a view. Works on the client, without
 * Qt, so that scripts have it too. Selections by other means than indices clear the blocks.
 */
#ifndef vtkSMSolidHighlightHelper_h
#define vtkSMSolidHighlightHelper_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSMProxyInitializationHelper.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMSolidHighlightHelper : public vtkSMProxyInitializationHelper
{
public:
  static vtkSMSolidHighlightHelper* New();
  vtkTypeMacro(vtkSMSolidHighlightHelper, vtkSMProxyInitializationHelper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void PostInitializeProxy(
    vtkSMProxy* proxy, vtkPVXMLElement* xml, vtkMTimeType initializationTimeStamp) override;

protected:
  vtkSMSolidHighlightHelper();
  ~vtkSMSolidHighlightHelper() override;

private:
  vtkSMSolidHighlightHelper(const vtkSMSolidHighlightHelper&) = delete;
  void operator=(const vtkSMSolidHighlightHelper&) = delete;
};

#endif
