/**
 * @class   vtkSMSolidsRepresentationProxy
 * @brief   draws solids in the colours of their file, and gives colour bars a unit
 *
 * The array Color of the reader's meshes is drawn as it is, without a colour map; other arrays are mapped as
 * usual. ParaView's property MapScalars is set according to the array by which the solids are coloured. A
 * colour bar of Color is never shown; the title of another has the unit of its array.
 *
 * Solids without an array of colours have one colour. Apply in ParaView's window would colour them like the
 * input, or with vtkBlockColors, and add a legend. Therefore GetUsingScalarColoring() is true until the first
 * drawing, and GetRepresentedDataInformation() is empty between the view's first update and its drawing
 * (ParaView 5.13 asks only for that), so that Apply does not change the colouring; the user may change it.
 */
#ifndef vtkSMSolidsRepresentationProxy_h
#define vtkSMSolidsRepresentationProxy_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkNew.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPVRepresentationProxy.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkSMSolidsRepresentationProxy : public vtkSMPVRepresentationProxy
{
public:
  static vtkSMSolidsRepresentationProxy* New();
  vtkTypeMacro(vtkSMSolidsRepresentationProxy, vtkSMPVRepresentationProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using Superclass::GetUsingScalarColoring;
  bool GetUsingScalarColoring() override;
  vtkPVDataInformation* GetRepresentedDataInformation() override;
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
  vtkNew<vtkPVDataInformation> NoInformation;
};

#endif
