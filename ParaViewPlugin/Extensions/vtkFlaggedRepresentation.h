/**
 * @class   vtkFlaggedRepresentation
 * @brief   draws flagged edges and faces, with the numbers of the worst next to them
 *
 * The input is port 6 of vtkSurfaceIntegralBase. The numbers are those of the cell array Flag, by which the
 * summary names the places. The process with the window draws them in front of all solids and behind the
 * summary; while a server renders for it, there are none.
 */
#ifndef vtkFlaggedRepresentation_h
#define vtkFlaggedRepresentation_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkNew.h"                     // for the numbers
#include "vtkPVCompositeRepresentation.h"

#include <array> // for the numbers

class vtkTextActor;

class SMPARAVIEWEXTENSIONS_EXPORT vtkFlaggedRepresentation : public vtkPVCompositeRepresentation
{
public:
  static vtkFlaggedRepresentation* New();
  vtkTypeMacro(vtkFlaggedRepresentation, vtkPVCompositeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Colour of the numbers: red, green and blue, each from 0 to 1, on dark red. Default: 1 1 1. */
  vtkSetVector3Macro(NumberColor, double);
  vtkGetVector3Macro(NumberColor, double);
  ///@}

  void SetVisibility(bool visible) override;
  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkFlaggedRepresentation();
  ~vtkFlaggedRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkFlaggedRepresentation(const vtkFlaggedRepresentation&) = delete;
  void operator=(const vtkFlaggedRepresentation&) = delete;

  double NumberColor[3] = { 1.0, 1.0, 1.0 };
  /// One for each place that the summary names.
  std::array<vtkNew<vtkTextActor>, 5> Numbers;
};

#endif
