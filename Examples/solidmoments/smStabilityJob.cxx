#include "smStabilityJob.h"

#include "smBodyBox.h"
#include "smMassPropertyNames.h"
#include "smMessageList.h"
#include "smOptionValues.h"
#include "smQuantities.h"
#include "smStabilityNames.h"
#include "smText.h"
#include "smUserIntegrals.h"

#include "vtkCADReader.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMassPropertiesGPU.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSolidStability.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
vtkSmartPointer<vtkPolyData> FindStability(vtkCADReader* reader, const JobOptions& options,
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
  SetUpFilter(filter->GetMassProperties(), options);
  SetUpMass(filter->GetMassProperties(), options);
  filter->GetMassProperties()->SetRelativeTolerance(options.Tolerance);
  // The filter integrates again in the remaining time, so that its status may be worse than that of the file; its messages have the reason.
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

void AddBoxes(vtkCADReader* reader, Json& file)
{
  const std::vector<BodyBox> boxes = ComputeBodyBoxes(reader->GetOutputDataObject(0));
  const auto set = [](Json& quantities, const BodyBox& box)
  {
    const std::array<double, 6>& b = box.Bounds;
    if (std::isfinite(box.Bound) && b[0] <= b[1])
    {
      quantities["bounding_box"] = { { b[0], b[2], b[4] }, { b[1], b[3], b[5] } };
      quantities["bounds"]["bounding_box"] = box.Bound;
    }
  };
  const double most = std::numeric_limits<double>::infinity();
  BodyBox total{ { most, -most, most, -most, most, -most }, 0.0 };
  for (Json& solid : file["solids"])
  {
    const BodyBox& box = boxes.at(std::stoul(solid["id"].get<std::string>()) - 1);
    set(solid, box);
    for (size_t i = 0; i < 6; i += 2)
    {
      total.Bounds[i] = std::min(total.Bounds[i], box.Bounds[i]);
      total.Bounds[i + 1] = std::max(total.Bounds[i + 1], box.Bounds[i + 1]);
    }
    // A NaN is kept: without the box of one body the box of all is not known.
    total.Bound = box.Bound <= total.Bound ? total.Bound : box.Bound;
    if (std::isnan(box.Bound))
    {
      return;
    }
  }
  set(file["total"], total);
}
}
