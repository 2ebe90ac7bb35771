/**
 * @class   vtkSMSolidMomentsSourceProxy
 * @brief   proxy of the plugin's reader and filters, with highlighting of solids and the key Esc
 *
 * The plugin's XML uses `<SolidMomentsSourceProxy>` in place of ParaView's `<SourceProxy>`. An
 * InitializationHelper in the hints runs only for proxies made by Apply or a script; this class also serves
 * those of a loaded state. It adds
 * - highlighting of the solids, faces and edges whose rows are selected in tables, and rows of what is picked
 * (smSolidHighlight.h), where the hints have `<HighlightRows/>`; with `<HighlightClipped/>` on the clipped
 * meshes;
 * - the key Esc in ParaView's window, which stops a run in this process (smEscapeKey.h); ParaView 5.11 never
 * enables its own button next to the progress bar. During such a run the status bar shows "Mass Properties,
 * Esc stops it". A run on a server cannot be stopped by the client: limit it by the property MaximumSeconds.
 * - the choice of series with which new plots of such filters begin (smPlotSeries.h);
 * - a plane that the filter follows while it is dragged (smLivePlane.h), where the hints have `<LivePlane/>`;
 * - second names: a definition with the hint `<SecondNameOf name="MassPropertiesGPU"/>` makes that filter, so
 * that ParaView's search, which knows labels only, finds it by other words;
 * - the text "Mass Properties: compiling shaders" in the status bar during the seconds that a first run may
 * take for it.
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
  /// Makes the filter that the hint SecondNameOf names of one that was found by its second name.
  void TakeFirstName();

  vtkSMSolidMomentsSourceProxy(const vtkSMSolidMomentsSourceProxy&) = delete;
  void operator=(const vtkSMSolidMomentsSourceProxy&) = delete;
};

#endif
