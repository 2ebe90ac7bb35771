/**
 * @class   vtkMassSummaryRepresentation
 * @brief   the summary of a mass filter as text in the view, in another colour when the result is flagged
 *
 * Input as of vtkTextSourceRepresentation; the table's field data may hold the string array Status. Where it is there and not "ok" the
 * text is drawn in FlaggedColor, else in the colour of the text property, as the user or the palette sets it.
 */
#ifndef vtkMassSummaryRepresentation_h
#define vtkMassSummaryRepresentation_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkTextSourceRepresentation.h"

class SMPARAVIEWEXTENSIONS_EXPORT vtkMassSummaryRepresentation : public vtkTextSourceRepresentation
{
public:
  static vtkMassSummaryRepresentation* New();
  vtkTypeMacro(vtkMassSummaryRepresentation, vtkTextSourceRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Red, green and blue from 0 to 1. Default: 1 0.4 0.35. */
  vtkSetVector3Macro(FlaggedColor, double);
  vtkGetVector3Macro(FlaggedColor, double);
  ///@}

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkMassSummaryRepresentation();
  ~vtkMassSummaryRepresentation() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkMassSummaryRepresentation(const vtkMassSummaryRepresentation&) = delete;
  void operator=(const vtkMassSummaryRepresentation&) = delete;

  double FlaggedColor[3] = { 1.0, 0.4, 0.35 };
  /// The colour to come back to.
  double OrdinaryColor[3] = { 1.0, 1.0, 1.0 };
  /// Not negative: the flagged colour that is drawn now.
  double DrawnColor[3] = { -1.0, -1.0, -1.0 };
};

#endif
