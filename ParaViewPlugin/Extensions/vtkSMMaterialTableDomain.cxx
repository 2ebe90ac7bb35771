#include "vtkSMMaterialTableDomain.h"

#include "smPanel.h"

#include "vtkPartMaterialsInformation.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringVectorProperty.h"

#include <cstddef>
#include <string>

vtkStandardNewMacro(vtkSMMaterialTableDomain);

namespace
{
constexpr int SolidsPort = 1;
}

vtkSMMaterialTableDomain::vtkSMMaterialTableDomain()
{
  this->Masses->SetPortNumber(SolidsPort);
  // Before the panel makes its widgets.
  sm::HasPanel();
}

vtkSMMaterialTableDomain::~vtkSMMaterialTableDomain() = default;

void vtkSMMaterialTableDomain::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Parts: " << this->Parts->GetParts().size() << "\n";
}

void vtkSMMaterialTableDomain::Update(vtkSMProperty* requestingProperty)
{
  vtkSMProxy* filter = this->GetProperty() ? this->GetProperty()->GetParent() : nullptr;
  if (!filter)
  {
    return;
  }
  if (!this->IsObserving)
  {
    this->IsObserving = true;
    this->GetProperty()->AddObserver(vtkCommand::ModifiedEvent, this, &vtkSMMaterialTableDomain::FollowCells);
    filter->AddObserver(vtkCommand::UpdateDataEvent, this, &vtkSMMaterialTableDomain::FollowRun);
  }
  if (requestingProperty == this->GetRequiredProperty("Input"))
  {
    this->GatherParts();
  }
  this->Masses->Clear();
  this->FillCells();
}

std::vector<sm::MaterialRow> vtkSMMaterialTableDomain::GetRules()
{
  std::vector<sm::MaterialRow> rules;
  auto* property = vtkSMStringVectorProperty::SafeDownCast(this->GetRequiredProperty("Rules"));
  const std::vector<std::string> texts = property ? property->GetElements() : std::vector<std::string>();
  for (std::size_t i = 0; i + 2 < texts.size(); i += 3)
  {
    rules.push_back({ texts[i], texts[i + 1], texts[i + 2] });
  }
  return rules;
}

void vtkSMMaterialTableDomain::GatherParts()
{
  this->Parts->Clear();
  vtkSMPropertyHelper input(this->GetRequiredProperty("Input"));
  auto* source =
    input.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()) : nullptr;
  if (source && source->GetObjectsCreated())
  {
    this->Parts->SetPortNumber(static_cast<int>(input.GetOutputPort()));
    source->GatherInformation(this->Parts);
  }
}

void vtkSMMaterialTableDomain::FollowCells()
{
  auto* table = vtkSMStringVectorProperty::SafeDownCast(this->GetProperty());
  auto* property = vtkSMStringVectorProperty::SafeDownCast(this->GetRequiredProperty("Rules"));
  if (this->IsFilling || !table || !property)
  {
    return;
  }
  const std::vector<sm::MaterialRow> rules = this->GetRules();
  std::vector<std::string> cells = table->GetElements();
  sm::TakeEditedCell(this->Filled, cells);
  const std::vector<sm::MaterialRow> read = sm::ReadMaterialTable(cells, rules);
  if (read == sm::ReadMaterialTable(this->MakeCells(), rules))
  {
    this->FillCells();
    return;
  }
  std::vector<std::string> texts;
  for (const sm::MaterialRow& row : read)
  {
    texts.insert(texts.end(), row.begin(), row.end());
  }
  // Fills the cells by Update().
  property->SetElements(texts);
}

void vtkSMMaterialTableDomain::FollowRun()
{
  auto* filter = vtkSMSourceProxy::SafeDownCast(this->GetProperty()->GetParent());
  if (!filter)
  {
    return;
  }
  if (this->Parts->GetParts().empty())
  {
    this->GatherParts();
  }
  this->Masses->Clear();
  filter->GatherInformation(this->Masses);
  this->FillCells();
}

double vtkSMMaterialTableDomain::GetDensity()
{
  vtkSMProperty* density = this->GetRequiredProperty("Density");
  return density ? vtkSMPropertyHelper(density).GetAsDouble() : 0.0;
}

bool vtkSMMaterialTableDomain::IsSomeSolids()
{
  vtkSMProperty* selectors = this->GetRequiredProperty("Selectors");
  return selectors && vtkSMPropertyHelper(selectors).GetNumberOfElements() > 0;
}

std::vector<std::string> vtkSMMaterialTableDomain::MakeCells()
{
  return sm::MakeMaterialTable(this->Parts->GetParts(), this->Masses->GetParts(), this->GetRules(),
    this->GetDensity(), this->IsSomeSolids(), !sm::HasPanel());
}

void vtkSMMaterialTableDomain::FillCells()
{
  auto* table = vtkSMStringVectorProperty::SafeDownCast(this->GetProperty());
  const std::vector<std::string> cells = this->MakeCells();
  this->Filled = cells;
  if (table && table->GetElements() != cells)
  {
    this->IsFilling = true;
    table->SetElements(cells);
    this->IsFilling = false;
  }
}
