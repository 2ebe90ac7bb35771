#include "vtkFlaggedRepresentation.h"

#include "smIntegralNames.h"
#include "smVisitMeshes.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCoordinate.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVRenderView.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <set>
#include <string>

vtkStandardNewMacro(vtkFlaggedRepresentation);

vtkFlaggedRepresentation::vtkFlaggedRepresentation()
{
  for (auto& number : this->Numbers)
  {
    number->SetVisibility(false);
    number->SetPickable(false);
    // Six pixels to the right of the place and above it.
    vtkNew<vtkCoordinate> place;
    place->SetCoordinateSystemToWorld();
    number->GetPositionCoordinate()->SetCoordinateSystemToViewport();
    number->GetPositionCoordinate()->SetReferenceCoordinate(place);
    number->SetPosition(6.0, 6.0);
    number->GetTextProperty()->SetFontSize(18);
    number->GetTextProperty()->SetBold(true);
    // White on it has a contrast of 6 : 1.
    number->GetTextProperty()->SetBackgroundColor(0.75, 0.1, 0.1);
    number->GetTextProperty()->SetBackgroundOpacity(1.0);
  }
}

vtkFlaggedRepresentation::~vtkFlaggedRepresentation() = default;

void vtkFlaggedRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberColor: " << this->NumberColor[0] << " " << this->NumberColor[1] << " "
     << this->NumberColor[2] << "\n";
}

bool vtkFlaggedRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  for (auto& number : this->Numbers)
  {
    if (renderView)
    {
      vtkRenderer* front = renderView->GetRenderer(vtkPVRenderView::NON_COMPOSITED_RENDERER);
      front->AddViewProp(number);
      // At the begin of the list, so that the summary covers numbers.
      front->GetViewProps()->RemoveItem(number);
      front->GetViewProps()->InsertItem(-1, number);
    }
  }
  return this->Superclass::AddToView(view);
}

bool vtkFlaggedRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  for (auto& number : this->Numbers)
  {
    if (renderView)
    {
      renderView->GetRenderer(vtkPVRenderView::NON_COMPOSITED_RENDERER)->RemoveViewProp(number);
    }
  }
  return this->Superclass::RemoveFromView(view);
}

void vtkFlaggedRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  for (auto& number : this->Numbers)
  {
    // All numbers are hidden; the next rendering shows those in use.
    number->SetVisibility(false);
  }
}

int vtkFlaggedRepresentation::ProcessViewRequest(
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
  // The numbers are drawn where the geometry is.
  vtkAlgorithmOutput* piece = vtkPVRenderView::GetPieceProducer(inInfo, this->GetActiveRepresentation());
  vtkDataObject* data = piece ? piece->GetProducer()->GetOutputDataObject(piece->GetIndex()) : nullptr;
  std::set<int> shown;
  sm::VisitMeshes(data, nullptr,
    [this, &shown](vtkPolyData* mesh, const std::string&)
    {
      vtkDataArray* flags = mesh->GetCellData()->GetArray(sm::names::Flag);
      for (vtkIdType i = 0; flags && i < mesh->GetNumberOfCells(); ++i)
      {
        const auto flag = static_cast<int>(flags->GetComponent(i, 0));
        if (flag < 1 || flag > static_cast<int>(this->Numbers.size()) || !shown.insert(flag).second)
        {
          continue;
        }
        vtkCell* cell = mesh->GetCell(i);
        double middle[3];
        cell->GetPoints()->GetPoint(cell->GetNumberOfPoints() / 2, middle);
        vtkTextActor* number = this->Numbers[static_cast<std::size_t>(flag) - 1];
        number->SetInput(std::to_string(flag).c_str());
        number->GetPositionCoordinate()->GetReferenceCoordinate()->SetValue(middle);
        number->GetTextProperty()->SetColor(this->NumberColor);
      }
    });
  for (int flag = 1; flag <= static_cast<int>(this->Numbers.size()); ++flag)
  {
    this->Numbers[static_cast<std::size_t>(flag) - 1]->SetVisibility(
      this->GetVisibility() && shown.count(flag) > 0);
  }
  return 1;
}
