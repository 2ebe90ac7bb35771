#include "vtkLabeledSolidsRepresentation.h"

#include "smFormat.h"
#include "smMassPropertyNames.h"
#include "smPolylineText.h"
#include "smVTKCompatibility.h"
#include "smVisitMeshes.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkGeometryRepresentation.h"
#include "vtkInformation.h"
#include "vtkLabelPlacementMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPointSetToLabelHierarchy.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkLabeledSolidsRepresentation);

namespace
{
constexpr std::size_t MaxLabels = 50;
constexpr int MassDigits = 4;
/// The colour in which ParaView draws selections.
constexpr double SelectionColor[3] = { 1.0, 0.0, 1.0 };
constexpr float SelectionLineWidth = 4.0f;
constexpr const char* TextArray = "Label";
constexpr const char* PriorityArray = "Priority";

struct Label
{
  std::string Text;
  double Middle[3];
  double Size;
};
}

vtkLabeledSolidsRepresentation::vtkLabeledSolidsRepresentation()
{
  this->Text->SetBold(true);
  this->Text->SetShadow(true);
  vtkNew<vtkPointSetToLabelHierarchy> hierarchy;
  hierarchy->SetInputData(this->LabelPoints);
  hierarchy->SetLabelArrayName(TextArray);
  hierarchy->SetPriorityArrayName(PriorityArray);
  hierarchy->SetTextProperty(this->Text);
  this->Mapper->SetInputConnection(hierarchy->GetOutputPort());
  this->Mapper->SetMaximumLabelFraction(0.5);
  this->Labels->SetMapper(this->Mapper);
  this->Labels->SetVisibility(false);
  this->Labels->SetPickable(false);
  vtkNew<vtkPolyDataMapper> lines;
  lines->SetInputData(this->SelectedEdges);
  this->SelectedEdgesActor->SetMapper(lines);
  this->SelectedEdgesActor->GetProperty()->SetColor(SelectionColor[0], SelectionColor[1], SelectionColor[2]);
  this->SelectedEdgesActor->GetProperty()->SetLineWidth(SelectionLineWidth);
  this->SelectedEdgesActor->GetProperty()->LightingOff();
  this->SelectedEdgesActor->SetPickable(false);
}

vtkLabeledSolidsRepresentation::~vtkLabeledSolidsRepresentation() = default;

void vtkLabeledSolidsRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PartLabels: " << this->PartLabels << "\n"
     << indent << "LabelColor: " << this->LabelColor[0] << " " << this->LabelColor[1] << " "
     << this->LabelColor[2] << "\n"
     << indent << "LabelFontSize: " << this->LabelFontSize << "\n";
}

bool vtkLabeledSolidsRepresentation::AddToView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    vtkRenderer* front = renderView->GetRenderer(vtkPVRenderView::NON_COMPOSITED_RENDERER);
    front->AddViewProp(this->Labels);
    // Actors are drawn in this order: labels lie behind the summaries, also of filters that were shown
    // before.
    vtkPropCollection* const props = front->GetViewProps();
    props->RemoveItem(this->Labels);
    props->InsertItem(-1, this->Labels);
    front->AddViewProp(this->SelectedEdgesActor);
  }
  return this->Superclass::AddToView(view);
}

bool vtkLabeledSolidsRepresentation::RemoveFromView(vtkView* view)
{
  if (auto* renderView = vtkPVRenderView::SafeDownCast(view))
  {
    vtkRenderer* front = renderView->GetRenderer(vtkPVRenderView::NON_COMPOSITED_RENDERER);
    front->RemoveViewProp(this->Labels);
    front->RemoveViewProp(this->SelectedEdgesActor);
  }
  return this->Superclass::RemoveFromView(view);
}

void vtkLabeledSolidsRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  // The next rendering shows them.
  this->Labels->SetVisibility(false);
  this->SelectedEdgesActor->SetVisibility(visible);
}

void vtkLabeledSolidsRepresentation::SetSelectedEdges(const char* polylines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const std::vector<sm::Vector3>& polyline : sm::ParsePolylines(polylines ? polylines : ""))
  {
    lines->InsertNextCell(static_cast<int>(polyline.size()));
    for (const sm::Vector3& point : polyline)
    {
      lines->InsertCellPoint(points->InsertNextPoint(point[0], point[1], point[2]));
    }
  }
  this->SelectedEdges->SetPoints(points);
  this->SelectedEdges->SetLines(lines);
}

vtkCompositeDataDisplayAttributes* vtkLabeledSolidsRepresentation::GetBlockAttributes()
{
  auto* geometry = vtkGeometryRepresentation::SafeDownCast(this->GetActiveRepresentation());
  auto* mapper = geometry ? sm::CompositeMapper::SafeDownCast(geometry->GetActor()->GetMapper()) : nullptr;
  return mapper ? mapper->GetCompositeDataDisplayAttributes() : nullptr;
}

int vtkLabeledSolidsRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request != vtkPVView::REQUEST_RENDER() || !this->GetActiveRepresentation())
  {
    return 1;
  }
  const bool isShown = this->GetVisibility() && this->PartLabels != NoLabels;
  if (isShown)
  {
    // The labels are drawn where the geometry is.
    vtkAlgorithmOutput* piece = vtkPVRenderView::GetPieceProducer(inInfo, this->GetActiveRepresentation());
    this->MakeLabels(piece ? piece->GetProducer()->GetOutputDataObject(piece->GetIndex()) : nullptr);
  }
  this->Labels->SetVisibility(isShown && this->LabelPoints->GetNumberOfPoints() > 0);
  return 1;
}

void vtkLabeledSolidsRepresentation::MakeLabels(vtkDataObject* data)
{
  std::vector<Label> labels;
  sm::VisitMeshes(data, this->GetBlockAttributes(),
    [this, &labels](vtkPolyData* mesh, const std::string& name)
    {
      if (mesh->GetNumberOfCells() == 0)
      {
        return;
      }
      Label label;
      const vtkBoundingBox box(mesh->GetBounds());
      box.GetCenter(label.Middle);
      label.Size = box.GetDiagonalLength();
      label.Text = name;
      vtkDataArray* masses = mesh->GetCellData()->GetArray(sm::names::MassOfWholeSolid);
      const double mass = masses ? masses->GetComponent(0, 0) : 0.0;
      if (this->PartLabels == NamesAndMasses && masses && std::isfinite(mass))
      {
        label.Text += (name.empty() ? "" : ", ") + sm::FormatDigits(mass, MassDigits) + " kg";
      }
      labels.push_back(label);
    });
  std::stable_sort(
    labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.Size > b.Size; });
  labels.resize(std::min(labels.size(), MaxLabels));
  vtkNew<vtkPoints> points;
  vtkNew<vtkStringArray> texts;
  texts->SetName(TextArray);
  vtkNew<vtkDoubleArray> priorities;
  priorities->SetName(PriorityArray);
  for (const Label& label : labels)
  {
    points->InsertNextPoint(label.Middle);
    texts->InsertNextValue(label.Text);
    priorities->InsertNextValue(label.Size);
  }
  this->Text->SetColor(this->LabelColor);
  this->Text->SetFontSize(this->LabelFontSize);
  this->LabelPoints->Initialize();
  this->LabelPoints->SetPoints(points);
  this->LabelPoints->GetPointData()->AddArray(texts);
  this->LabelPoints->GetPointData()->AddArray(priorities);
  this->LabelPoints->Modified();
}
