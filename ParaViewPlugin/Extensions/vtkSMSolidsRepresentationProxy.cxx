#include "vtkSMSolidsRepresentationProxy.h"

#include "smColumnUnits.h"
#include "smMassPropertyNames.h"
#include "vtkExactGeometryInformation.h"
#if VTK_MODULE_ENABLE_SolidMoments_FiltersStability
#include "smStabilityNames.h"
#endif

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMTransferFunctionManager.h"

#include <string>

vtkStandardNewMacro(vtkSMSolidsRepresentationProxy);

vtkSMSolidsRepresentationProxy::vtkSMSolidsRepresentationProxy() = default;
vtkSMSolidsRepresentationProxy::~vtkSMSolidsRepresentationProxy() = default;

void vtkSMSolidsRepresentationProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

namespace
{
std::string GetArrayName(vtkSMProxy* proxy)
{
  vtkSMPropertyHelper helper(proxy->GetProperty("ColorArrayName"));
  const char* name = helper.GetInputArrayNameToProcess();
  return name ? name : "";
}

/// True for an array of colours, which are drawn as they are.
bool IsColor(const std::string& array)
{
#if VTK_MODULE_ENABLE_SolidMoments_FiltersStability
  if (array == sm::names::StabilityColor)
  {
    return true;
  }
#endif
  return array == sm::names::Color;
}
}

void vtkSMSolidsRepresentationProxy::CreateVTKObjects()
{
  const bool first = !this->ObjectsCreated;
  this->Superclass::CreateVTKObjects();
  vtkSMProperty* array = this->GetProperty("ColorArrayName");
  if (first && this->ObjectsCreated && array)
  {
    array->AddObserver(vtkCommand::ModifiedEvent, this, &vtkSMSolidsRepresentationProxy::FollowArray);
  }
}

bool vtkSMSolidsRepresentationProxy::GetUsingScalarColoring()
{
  return this->Superclass::GetUsingScalarColoring() || (!this->IsDrawn && GetArrayName(this).empty());
}

vtkPVDataInformation* vtkSMSolidsRepresentationProxy::GetRepresentedDataInformation()
{
  return this->IsWaiting && !this->IsDrawn && GetArrayName(this).empty()
    ? this->NoInformation.Get()
    : this->Superclass::GetRepresentedDataInformation();
}

void vtkSMSolidsRepresentationProxy::ViewUpdated(vtkSMProxy* view)
{
  this->Superclass::ViewUpdated(view);
  if (!this->IsDrawn && !this->IsWaiting && view)
  {
    this->IsWaiting = true;
    view->AddObserver(vtkCommand::EndEvent, this, &vtkSMSolidsRepresentationProxy::EndFirstDrawing);
  }
}

void vtkSMSolidsRepresentationProxy::EndFirstDrawing()
{
  this->IsDrawn = true;
}

void vtkSMSolidsRepresentationProxy::FollowArray()
{
  if (vtkSMProperty* map = this->GetProperty("MapScalars"))
  {
    vtkSMPropertyHelper(map).Set(IsColor(GetArrayName(this)) ? 0 : 1);
  }
}

bool vtkSMSolidsRepresentationProxy::SetScalarBarVisibility(vtkSMProxy* view, bool visible)
{
  const std::string array = GetArrayName(this);
  // Without an array there is no colour bar. For the file's colours the superclass would make a bar in order
  // to hide it.
  if (array.empty() || (IsColor(array) && (visible || !this->IsScalarBarVisible(view))))
  {
    return false;
  }
  const bool done = this->Superclass::SetScalarBarVisibility(view, visible);
  if (done && visible)
  {
    this->AddUnit(view, array.c_str());
  }
  return done;
}

void vtkSMSolidsRepresentationProxy::AddUnit(vtkSMProxy* view, const char* array)
{
  vtkSMPropertyHelper input(this, "Input");
  auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
  vtkSMProxy* map = vtkSMPropertyHelper(this, "LookupTable").GetAsProxy();
  vtkNew<vtkSMTransferFunctionManager> manager;
  vtkSMProxy* bar = map ? manager->GetScalarBarRepresentation(map, view) : nullptr;
  if (!source || !bar || !bar->GetProperty("Title"))
  {
    return;
  }
  vtkNew<vtkExactGeometryInformation> information;
  information->SetPortNumber(static_cast<int>(input.GetOutputPort()));
  source->GatherInformation(information);
  const std::string unit = sm::GetColumnUnit(array, information->GetLengthUnit());
  vtkSMPropertyHelper title(bar, "Title");
  // A title that the user has changed is kept.
  if (!unit.empty() && std::string(title.GetAsString()) == array)
  {
    title.Set((std::string(array) + " (" + unit + ")").c_str());
    bar->UpdateVTKObjects();
  }
}
