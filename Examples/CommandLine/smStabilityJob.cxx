#include "smStabilityJob.h"

#include "smMassPropertyNames.h"
#include "smMessageList.h"
#include "smQuantities.h"
#include "smStabilityNames.h"
#include "smText.h"
#include "smUserIntegrals.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMassPropertiesGPU.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTEPReader.h"
#include "vtkSolidStability.h"
#include "vtkTable.h"

namespace
{
using sm::GetCount;
using sm::GetNumber;
using sm::GetPoint;
using sm::GetText;
using sm::Json;
namespace names = sm::names;

Json Sides(vtkSolidStability* filter, vtkIdType solid)
{
  vtkDataSetAttributes* columns = vtkTable::SafeDownCast(filter->GetOutputDataObject(3))->GetRowData();
  Json sides = Json::array();
  vtkDataArray* owner = columns->GetArray(names::Solid);
  for (vtkIdType row = 0; row < owner->GetNumberOfTuples(); ++row)
  {
    if (static_cast<vtkIdType>(owner->GetComponent(row, 0)) == solid)
    {
      sides.push_back({ { "from", GetPoint(columns, row, names::SideFrom) },
        { "to", GetPoint(columns, row, names::SideTo) },
        { "stability_margin", GetNumber(columns, row, names::StabilityMargin) },
        { "tip_angle", GetNumber(columns, row, names::TipAngle) },
        { "center_of_mass_rise", GetNumber(columns, row, names::CenterOfMassRise) } });
    }
  }
  return sides;
}

Json Describe(vtkSolidStability* filter, vtkIdType row)
{
  vtkDataSetAttributes* columns = vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetRowData();
  const std::string bound = names::BoundSuffix;
  Json entry;
  entry["verdict"] = GetText(columns, row, names::Stability);
  entry["support"] = GetText(columns, row, names::Support);
  entry["decided_by"] = GetText(columns, row, names::DecidedBy);
  Json bounds;
  for (const auto& [key, name] : { std::pair("stability_margin", names::StabilityMargin),
         std::pair("tip_angle", names::TipAngle), std::pair("center_of_mass_rise", names::CenterOfMassRise),
         std::pair("center_height", names::CenterHeight), std::pair("rolling_margin", names::RollingMargin) })
  {
    entry[key] = GetNumber(columns, row, name);
    bounds[key] = GetNumber(columns, row, name + bound);
  }
  entry["bounds"] = bounds;
  entry["tip_energy"] = GetNumber(columns, row, names::TipEnergy);
  entry["rolling_radius"] = GetNumber(columns, row, names::RollingRadius);
  entry["projected_center_of_mass"] = GetPoint(columns, row, names::ProjectedCenterOfMass);
  entry["contact_faces"] = GetCount(columns, row, names::ContactFaces);
  entry["contact_edges"] = GetCount(columns, row, names::ContactEdges);
  entry["sides"] = Sides(filter, row);
  return entry;
}
}

namespace sm
{
vtkSmartPointer<vtkPolyData> FindStability(vtkSTEPReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages)
{
  std::array<double, 3> direction;
  if (options.Stability.empty() || !ParseDirection(options.Stability, direction))
  {
    return nullptr;
  }
  vtkNew<vtkSolidStability> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetGravityDirection(direction.data());
  filter->SetDensity(options.Density);
  SetUpFilter(filter->GetMassProperties(), options);
  filter->GetMassProperties()->SetRelativeTolerance(options.Tolerance);
  // It integrates again, in what is left of the time: its own status may be worse, and its messages say why.
  const auto run = [&]()
  {
    update(filter);
    if (file["status"] == names::StatusOk)
    {
      file["status"] = filter->GetStatus();
    }
    for (int i = 0; i < filter->GetNumberOfMessages(); ++i)
    {
      messages.AddEcho(filter->GetMessage(i));
    }
  };
  run();
  auto drawing = vtkSmartPointer<vtkPolyData>::New();
  if (filter->GetMassProperties()->GetNumberOfSolids() == 0)
  {
    return nullptr;
  }
  drawing->ShallowCopy(filter->GetOutput());
  file["total"]["stability"] = Describe(filter, 0);
  if (file["solids"].size() == 1)
  {
    file["solids"][0]["stability"] = file["total"]["stability"];
    return drawing;
  }
  filter->SetBodies(vtkSolidStability::EACH);
  SetTimeLimit(filter->GetMassProperties(), options);
  run();
  vtkIdType row = 0;
  for (Json& solid : file["solids"])
  {
    solid["stability"] = Describe(filter, row);
    ++row;
  }
  return drawing;
}
}
