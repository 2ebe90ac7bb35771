/**
 * @class   vtkMassSummaryRepresentation
 * @brief   the summary of a filter as text in the view, in another colour when its status is not ok
 *
 * The input is that of vtkTextSourceRepresentation; the table's field data may hold the string array Status.
 * If it does and the status is not "ok", the text has the colour FlaggedColor, else the colour of the text
 * property, as the user or the palette sets it.
 */
#ifndef vtkMassSummaryRepresentation_h
#define vtkMassSummaryRepresentation_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkTextSourceRepresentation.h"

#include <string> // for the text

class SMPARAVIEWEXTENSIONS_EXPORT vtkMassSummaryRepresentation : public vtkTextSourceRepresentation
{
public:
  static vtkMassSummaryRepresentation* New();
  vtkTypeMacro(vtkMassSummaryRepresentation, vtkTextSourceRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Colour of the text when the status is not ok: red, green and blue, each from 0 to 1. Default: 1 0.4
   * 0.35. */
  vtkSetVector3Macro(FlaggedColor, double);
  vtkGetVector3Macro(FlaggedColor, double);
  ///@}

  ///@{
  /** Text about the selection, in lines, which is drawn below the summary. Default: empty. */
  void SetSelectedText(const std::string& text);
  std::string GetSelectedText() const;
  ///@}

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkMassSummaryRepresentation();
  ~vtkMassSummaryRepresentation() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  /** Number of lines, of this text's height, that summaries before this one take in the same corner of the
   * view. */
  int CountLinesAbove(double lineHeight) const;

  vtkMassSummaryRepresentation(const vtkMassSummaryRepresentation&) = delete;
  void operator=(const vtkMassSummaryRepresentation&) = delete;

  std::string SelectedText;
  double FlaggedColor[3] = { 1.0, 0.4, 0.35 };
  /// The colour of the text property when it is not overridden.
  double OrdinaryColor[3] = { 1.0, 1.0, 1.0 };
  /// The flagged colour that the text has now; negative when it has the ordinary one.
  double DrawnColor[3] = { -1.0, -1.0, -1.0 };
  /// Lines of the text, without those that CountLinesAbove() adds; 0 where it is not in the upper left
  /// corner.
  int Lines = 0;
  double LineHeight = 0.0;
};

#endif
