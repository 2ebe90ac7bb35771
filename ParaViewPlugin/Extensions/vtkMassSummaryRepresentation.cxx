#include "vtkMassSummaryRepresentation.h"

#include "smFormat.h"
#include "smIntegralNames.h"

#include "vtk3DWidgetRepresentation.h"
#include "vtkAlgorithmOutput.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkTextRepresentation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkMassSummaryRepresentation);

namespace
{
/// Fraction of the view's width for text in a corner; ParaView leaves a margin of one per cent.
constexpr double WidthShare = 0.98;

bool IsFlagged(vtkFieldData* data)
{
  auto* status = vtkStringArray::SafeDownCast(data->GetAbstractArray(sm::names::Status));
  return status && status->GetNumberOfValues() > 0 && status->GetValue(0) != sm::names::StatusOk;
}

/// Returns the width of a line in pixels; 0 without a font.
double MeasureWidth(const std::string& line, vtkTextProperty* text, int dpi)
{
  int box[4] = { 0, -1, 0, -1 };
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  return renderer && !line.empty() && renderer->GetBoundingBox(text, line, box, dpi)
    ? std::max(0, box[1] - box[0] + 1)
    : 0.0;
}

/// Breaks lines that are wider than the view; continuation lines are indented and come before indented lines
/// of the text. Words and values are not divided.
std::string BreakLines(const std::string& lines, vtkTextProperty* text, int dpi, double width)
{
  std::string result;
  std::istringstream source(lines);
  for (std::string line; std::getline(source, line);)
  {
    std::size_t at = 0;
    while ((at = line.find_last_not_of(' ')) != std::string::npos && MeasureWidth(line, text, dpi) > width)
    {
      // The last blank before which the words fit; if the first word is too long, the blank behind it.
      const std::size_t begin = line.find_first_not_of(' ');
      std::size_t blank = at;
      std::size_t cut = std::string::npos;
      while ((blank = line.rfind(' ', blank - 1)) != std::string::npos && blank > begin)
      {
        if (!sm::IsLineBreak(line, blank))
        {
          continue;
        }
        cut = blank;
        if (MeasureWidth(line.substr(0, blank), text, dpi) <= width)
        {
          break;
        }
      }
      if (cut == std::string::npos)
      {
        break;
      }
      result += line.substr(0, cut) + "\n";
      line = "   " + line.substr(line.find_first_not_of(' ', cut));
      if (std::string next; source.peek() == ' ' && std::getline(source, next))
      {
        const std::size_t first = next.find_first_not_of(' ');
        line += first == std::string::npos ? "" : " " + next.substr(first);
      }
    }
    result += line + (source.eof() ? "" : "\n");
  }
  return result;
}
}

vtkMassSummaryRepresentation::vtkMassSummaryRepresentation() = default;
vtkMassSummaryRepresentation::~vtkMassSummaryRepresentation() = default;

void vtkMassSummaryRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FlaggedColor: " << this->FlaggedColor[0] << " " << this->FlaggedColor[1] << " "
     << this->FlaggedColor[2] << "\n"
     << indent << "SelectedText: " << this->SelectedText << "\n";
}

void vtkMassSummaryRepresentation::SetSelectedText(const std::string& text)
{
  if (this->SelectedText != text)
  {
    this->SelectedText = text;
    this->Modified();
  }
}

std::string vtkMassSummaryRepresentation::GetSelectedText() const
{
  return this->SelectedText;
}

int vtkMassSummaryRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int done = this->Superclass::RequestData(request, inputVector, outputVector);
  vtkTable* input =
    inputVector[0]->GetNumberOfInformationObjects() == 1 ? vtkTable::GetData(inputVector[0], 0) : nullptr;
  vtkAbstractArray* status = input ? input->GetFieldData()->GetAbstractArray(sm::names::Status) : nullptr;
  if (status && input->GetNumberOfRows() > 0)
  {
    // Added after the text, because the superclass draws the first array.
    this->DummyPolyData->GetFieldData()->AddArray(status);
  }
  return done;
}

int vtkMassSummaryRepresentation::CountLinesAbove(double lineHeight) const
{
  double height = 0.0;
  vtkView* view = this->GetView();
  for (int i = 0; view && i < view->GetNumberOfRepresentations(); ++i)
  {
    auto* other = vtkMassSummaryRepresentation::SafeDownCast(view->GetRepresentation(i));
    if (other == this)
    {
      return static_cast<int>(std::ceil(height / lineHeight));
    }
    if (other && other->GetVisibility() && other->Lines > 0)
    {
      height += (other->Lines + 1) * other->LineHeight; // and an empty line
    }
  }
  return 0;
}

int vtkMassSummaryRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  auto* widget = this->TextWidgetRepresentation
    ? vtkTextRepresentation::SafeDownCast(this->TextWidgetRepresentation->GetRepresentation())
    : nullptr;
  if (request == vtkPVView::REQUEST_RENDER() && widget)
  {
    vtkAlgorithmOutput* piece = vtkPVRenderView::GetPieceProducer(inInfo, this);
    vtkDataObject* data = piece ? piece->GetProducer()->GetOutputDataObject(piece->GetIndex()) : nullptr;
    vtkTextProperty* text = widget->GetTextActor()->GetTextProperty();
    double color[3];
    text->GetColor(color);
    // A colour that differs from the one drawn here was set by the user or the palette.
    if (!std::equal(color, color + 3, this->DrawnColor))
    {
      std::copy_n(color, 3, this->OrdinaryColor);
    }
    const bool flagged = data && IsFlagged(data->GetFieldData());
    text->SetColor(flagged ? this->FlaggedColor : this->OrdinaryColor);
    // Several summaries in the corner stand below each other.
    std::string written = widget->GetText() ? widget->GetText() : "";
    if (!this->SelectedText.empty())
    {
      written += (written.empty() || written.back() == '\n' ? "\n" : "\n\n") + this->SelectedText;
      widget->SetText(written.c_str());
    }
    if (auto* view = vtkPVRenderView::SafeDownCast(this->GetView()))
    {
      written = BreakLines(
        written, text, view->GetRenderWindow()->GetDPI(), WidthShare * view->GetRenderer()->GetSize()[0]);
      widget->SetText(written.c_str());
    }
    this->LineHeight = text->GetFontSize();
    this->Lines = 0;
    if (widget->GetWindowLocation() == vtkTextRepresentation::UpperLeftCorner && this->LineHeight > 0.0)
    {
      this->Lines = static_cast<int>(std::count(written.begin(), written.end(), '\n')) +
        (written.empty() || written.back() == '\n' ? 0 : 1);
      const int above = this->CountLinesAbove(this->LineHeight);
      if (above > 0 && !written.empty())
      {
        widget->SetText((std::string(static_cast<std::size_t>(above), '\n') + written).c_str());
      }
    }
    // ParaView has no property for the line spacing, and VTK's default makes lines touch.
    text->SetLineSpacing(1.3);
    for (int i = 0; i < 3; ++i)
    {
      this->DrawnColor[i] = flagged ? this->FlaggedColor[i] : -1.0;
    }
  }
  return 1;
}
