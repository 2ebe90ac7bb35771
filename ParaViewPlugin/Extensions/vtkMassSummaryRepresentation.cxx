#include "vtkMassSummaryRepresentation.h"

#include "smFormat.h"
#include "smIntegralNames.h"

#include "vtk3DWidgetRepresentation.h"
#include "vtkActor2D.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkTextRepresentation.h"
#include "vtkViewport.h"
#include "vtkWindow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkMassSummaryRepresentation);

namespace
{
/// Pixels of the box around the text.
constexpr double Padding = 4.0;
/// The relative luminance that has the same contrast to black and to white.
constexpr double MiddleLuminance = 0.179;

/// Returns the relative luminance of a colour in sRGB.
double GetLuminance(const double color[3])
{
  const auto linear = [](double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

/// A box that is placed whenever it is drawn.
class BoxActor : public vtkActor2D
{
public:
  static BoxActor* New();
  vtkTypeMacro(BoxActor, vtkActor2D);

  std::function<void(vtkViewport*)> Place;

  int RenderOverlay(vtkViewport* viewport) override
  {
    if (this->Place)
    {
      this->Place(viewport);
    }
    return this->Superclass::RenderOverlay(viewport);
  }
};
vtkStandardNewMacro(BoxActor);

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

/// Returns where the line with the status begins; npos without one.
std::size_t FindStatus(const std::string& text)
{
  const std::string label = "Status: ";
  const std::size_t at = text.compare(0, label.size(), label) == 0 ? 0 : text.find("\n" + label);
  return at == 0 || at == std::string::npos ? at : at + 1;
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

vtkMassSummaryRepresentation::vtkMassSummaryRepresentation()
{
  this->Corners->SetNumberOfPoints(4);
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 1, 2, 3 });
  vtkNew<vtkPolyData> box;
  box->SetPoints(this->Corners);
  box->SetPolys(quads);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(box);
  vtkNew<BoxActor> actor;
  actor->Place = [this](vtkViewport* viewport) { this->PlaceBox(viewport); };
  actor->SetMapper(mapper);
  this->Box = actor.Get();
  this->StatusActor->SetTextScaleModeToNone();
  this->StatusActor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  for (vtkActor2D* prop : { this->Box.Get(), static_cast<vtkActor2D*>(this->StatusActor) })
  {
    prop->SetVisibility(false);
    prop->SetPickable(false);
  }
}

vtkMassSummaryRepresentation::~vtkMassSummaryRepresentation()
{
  // The view may keep the actor.
  BoxActor::SafeDownCast(this->Box)->Place = nullptr;
}

void vtkMassSummaryRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FlaggedColor: " << this->FlaggedColor[0] << " " << this->FlaggedColor[1] << " "
     << this->FlaggedColor[2] << "\n"
     << indent << "BoxOpacity: " << this->BoxOpacity << "\n"
     << indent << "Heading: " << this->Heading << "\n"
     << indent << "SelectedText: " << this->SelectedText << "\n";
}

bool vtkMassSummaryRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  vtkRenderer* front =
    renderView ? renderView->GetRenderer(vtkPVRenderView::NON_COMPOSITED_RENDERER) : nullptr;
  // Actors are drawn in the order in which they are added: the box behind the text, the status in front of
  // it.
  if (front)
  {
    front->AddViewProp(this->Box);
  }
  const bool isAdded = this->Superclass::AddToView(view);
  if (front)
  {
    front->AddViewProp(this->StatusActor);
  }
  return isAdded;
}

bool vtkMassSummaryRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    vtkRenderer* front = renderView->GetRenderer(vtkPVRenderView::NON_COMPOSITED_RENDERER);
    front->RemoveViewProp(this->Box);
    front->RemoveViewProp(this->StatusActor);
  }
  return this->Superclass::RemoveFromView(view);
}

void vtkMassSummaryRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  // The next rendering shows them.
  this->Box->SetVisibility(false);
  this->StatusActor->SetVisibility(false);
}

void vtkMassSummaryRepresentation::SetHeading(const std::string& text)
{
  if (this->Heading != text)
  {
    this->Heading = text;
    this->Modified();
  }
}

std::string vtkMassSummaryRepresentation::GetHeading() const
{
  return this->Heading;
}

std::string vtkMassSummaryRepresentation::GetWholeText(const std::string& summary) const
{
  int shown = 0;
  vtkView* view = this->GetView();
  for (int i = 0; view && i < view->GetNumberOfRepresentations(); ++i)
  {
    auto* other = vtkMassSummaryRepresentation::SafeDownCast(view->GetRepresentation(i));
    shown += other && other->GetVisibility() ? 1 : 0;
  }
  std::string text = shown > 1 && !this->Heading.empty() && !summary.empty() ? this->Heading + "\n" : "";
  text += summary;
  if (!this->SelectedText.empty())
  {
    text += (text.empty() || text.back() == '\n' ? "\n" : "\n\n") + this->SelectedText;
  }
  return text;
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
    this->Flagged = data && IsFlagged(data->GetFieldData());
    std::string written = this->GetWholeText(widget->GetText() ? widget->GetText() : "");
    widget->SetText(written.c_str());
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
      // Several summaries in the corner stand below each other.
      const int above = this->CountLinesAbove(this->LineHeight);
      if (above > 0 && !written.empty())
      {
        widget->SetText((std::string(static_cast<std::size_t>(above), '\n') + written).c_str());
      }
    }
    // ParaView has no property for the line spacing, and VTK's default makes lines touch.
    text->SetLineSpacing(1.3);
    const bool isShown = this->GetVisibility() && !written.empty();
    this->Written = written;
    this->Box->SetVisibility(isShown && this->BoxOpacity > 0.0);
    // The status needs its text here: VTK reports an error when it draws an actor without text.
    const std::size_t begin = FindStatus(written);
    const bool hasStatus = isShown && this->Flagged && begin != std::string::npos;
    this->StatusActor->SetVisibility(hasStatus);
    this->StatusActor->SetInput(
      hasStatus ? written.substr(begin, written.find('\n', begin) - begin).c_str() : "");
    vtkTextProperty* own = this->StatusActor->GetTextProperty();
    own->ShallowCopy(text);
    own->SetColor(1.0, 1.0, 1.0);
    own->SetShadow(false);
    own->SetBackgroundColor(this->FlaggedColor);
    own->SetBackgroundOpacity(1.0);
    own->SetJustificationToLeft();
    own->SetVerticalJustificationToTop();
  }
  return 1;
}

void vtkMassSummaryRepresentation::PlaceBox(vtkViewport* viewport)
{
  auto* widget = this->TextWidgetRepresentation
    ? vtkTextRepresentation::SafeDownCast(this->TextWidgetRepresentation->GetRepresentation())
    : nullptr;
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  vtkWindow* window = viewport->GetVTKWindow();
  if (!widget || !widget->GetText() || !renderer || !window)
  {
    return;
  }
  // The widget places its text for the size of the view.
  widget->BuildRepresentation();
  vtkTextActor* actor = widget->GetTextActor();
  vtkTextProperty* text = actor->GetTextProperty();
  double box[4];
  actor->GetBoundingBox(viewport, box);
  const double* anchor = actor->GetActualPositionCoordinate()->GetComputedDoubleViewportValue(viewport);
  const auto measure = [&](const std::string& lines)
  {
    int own[4] = { 0, -1, 0, -1 };
    renderer->GetBoundingBox(text, lines, own, window->GetDPI());
    return std::array<double, 2>{ own[1] - own[0] + 1.0, own[3] - own[2] + 1.0 };
  };
  const std::string lines =
    this->Written.substr(0, this->Written.find_last_not_of('\n') + 1); // not those at the end
  const double advance = measure("X\nX")[1] - measure("X")[1];
  const double empty =
    static_cast<double>(this->Written.size() - std::min(lines.size(), this->Written.size())) * advance;
  const std::array<double, 2> size = measure(lines);
  const double left = anchor[0] + box[0];
  const double bottom = anchor[1] + box[2] + empty;
  const double top = bottom + size[1];
  const double corners[4][2] = { { left - Padding, bottom - Padding },
    { left + size[0] + Padding, bottom - Padding }, { left + size[0] + Padding, top + Padding },
    { left - Padding, top + Padding } };
  for (int i = 0; i < 4; ++i)
  {
    this->Corners->SetPoint(i, corners[i][0], corners[i][1], 0.0);
  }
  this->Corners->Modified();
  double color[3];
  text->GetColor(color);
  const double shade = GetLuminance(color) > MiddleLuminance ? 0.0 : 1.0;
  this->Box->GetProperty()->SetColor(shade, shade, shade);
  this->Box->GetProperty()->SetOpacity(this->BoxOpacity);
  const std::size_t begin = std::min(FindStatus(lines), lines.size());
  const auto before = static_cast<double>(std::count(lines.begin(), lines.begin() + begin, '\n'));
  this->StatusActor->SetPosition(left, top - before * advance);
}
