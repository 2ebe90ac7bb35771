/**
 * @class   vtkMassSummaryRepresentation
 * @brief   the summary of a filter as text in the view, on a box, with a status that is not ok on red
 *
 * The input is that of vtkTextSourceRepresentation; the table's field data may hold the string array Status.
 * If it does and the status is not "ok", the line of the text that begins with "Status:" is white on
 * FlaggedColor. The text has the colour of the text property, as the user or the palette sets it; the box
 * behind it is black or white, whichever contrasts more, so that the text has a contrast of at least 4.5 : 1
 * on any background and before any part.
 */
#ifndef vtkMassSummaryRepresentation_h
#define vtkMassSummaryRepresentation_h

#include "smParaViewExtensionsModule.h" // for the export macro
#include "vtkNew.h"                     // for the box
#include "vtkSmartPointer.h"            // for the box
#include "vtkTextSourceRepresentation.h"

#include <string> // for the text

class vtkActor2D;
class vtkPoints;
class vtkTextActor;
class vtkViewport;

class SMPARAVIEWEXTENSIONS_EXPORT vtkMassSummaryRepresentation : public vtkTextSourceRepresentation
{
public:
  static vtkMassSummaryRepresentation* New();
  vtkTypeMacro(vtkMassSummaryRepresentation, vtkTextSourceRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Colour behind the status when it is not ok: red, green and blue, each from 0 to 1. Default: 0.75 0.1
   * 0.1. */
  vtkSetVector3Macro(FlaggedColor, double);
  vtkGetVector3Macro(FlaggedColor, double);
  ///@}

  ///@{
  /** Text about the selection, in lines, which is drawn below the summary. Default: empty. */
  void SetSelectedText(const std::string& text);
  std::string GetSelectedText() const;
  ///@}

  ///@{
  /** Opacity of the box behind the text, from 0 to 1, clamped. Default: 0.7. */
  vtkSetClampMacro(BoxOpacity, double, 0.0, 1.0);
  vtkGetMacro(BoxOpacity, double);
  ///@}

  ///@{
  /** The line above the summary, which is drawn where the view shows other summaries, too. Default: empty. */
  void SetHeading(const std::string& text);
  std::string GetHeading() const;
  ///@}

  void SetVisibility(bool visible) override;
  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkMassSummaryRepresentation();
  ~vtkMassSummaryRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  /** Number of lines, of this text's height, that summaries before this one take in the same corner of the
   * view. */
  int CountLinesAbove(double lineHeight) const;
  /** Returns the text: heading, summary and selection. */
  std::string GetWholeText(const std::string& summary) const;
  /** Places the box and the status for the text that the widget draws, whose first `above` lines are empty.
   */
  void PlaceBox(vtkViewport* viewport);

  vtkMassSummaryRepresentation(const vtkMassSummaryRepresentation&) = delete;
  void operator=(const vtkMassSummaryRepresentation&) = delete;

  std::string SelectedText;
  std::string Heading;
  double FlaggedColor[3] = { 0.75, 0.1, 0.1 };
  double BoxOpacity = 0.7;
  bool Flagged = false;
  /// The text that is drawn, without the empty lines above.
  std::string Written;
  vtkNew<vtkPoints> Corners;
  vtkSmartPointer<vtkActor2D> Box;
  vtkNew<vtkTextActor> StatusActor;
  /// Lines of the text, without those that CountLinesAbove() adds; 0 where it is not in the upper left
  /// corner.
  int Lines = 0;
  double LineHeight = 0.0;
};

#endif
