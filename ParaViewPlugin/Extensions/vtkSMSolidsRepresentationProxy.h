/**
 * @class   vtkSMSolidsRepresentationProxy
 * @brief   draws solids in the colours of their file, and gives colour bars a unit
 *
 * The array Color of the reader's meshes is drawn as it is, without a colour map; other arrays are mapped as ever. ParaView's property
 * MapScalars follows the array that colours. A colour bar of Color is never shown; the title of another has the unit of its array.
 *
 * What has no array to colour by has one colour. Apply in ParaView's window would colour it as its input, or with vtkBlockColors, and add a
 * legend. Until the first drawing GetUsingScalarColoring() is therefore true, and Apply leaves such a representation alone; who wants other
 * colours chooses them.
 */
#ifndef vtkSMSolidsRepresentationProxy_h
#define vtkSMSolidsRepresentationProxy_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkSMPVRepresentationProxy.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMSolidsRepresentationProxy : public vtkSMPVRepresentationProxy
{
public:
  static vtkSMSolidsRepresentationProxy* New();
  vtkTypeMacro(vtkSMSolidsRepresentationProxy, vtkSMPVRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using Superclass::GetUsingScalarColoring;
  bool GetUsingScalarColoring() override;
  void ViewUpdated(vtkSMProxy* view) override;

  using Superclass::SetScalarBarVisibility;
  bool SetScalarBarVisibility(vtkSMProxy* view, bool visible) override;

protected:
  vtkSMSolidsRepresentationProxy();
  ~vtkSMSolidsRepresentationProxy() override;

  void CreateVTKObjects() override;

private:
  vtkSMSolidsRepresentationProxy(const vtkSMSolidsRepresentationProxy&) = delete;
  void operator=(const vtkSMSolidsRepresentationProxy&) = delete;

  void FollowArray();
  void EndFirstDrawing();
  void AddUnit(vtkSMProxy* view, const char* array);

  /// Waits for the end of the first drawing.
  bool IsWaiting = false;
  bool IsDrawn = false;
};

#endif
