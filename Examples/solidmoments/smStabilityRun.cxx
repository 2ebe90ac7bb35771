#include "smFileJob.h"
#include "smFilterSetUp.h"
#include "smMassPropertyNames.h"
#include "smMessageList.h"
#include "smOptionValues.h"
#include "smResults.h"
#include "smStabilityAnalysis.h"
#include "smStabilityNames.h"

#include "vtkCADReader.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMassPropertiesGPU.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSolidStability.h"
#include "vtkTable.h"

namespace sm
{
namespace
{
std::vector<StabilitySide> ReadSides(vtkSolidStability* filter, vtkIdType solid)
{
  vtkDataSetAttributes* columns = vtkTable::SafeDownCast(filter->GetOutputDataObject(3))->GetRowData();
  std::vector<StabilitySide> sides;
  vtkDataArray* owner = columns->GetArray(names::Solid);
  for (vtkIdType row = 0; row < owner->GetNumberOfTuples(); ++row)
  {
    if (static_cast<vtkIdType>(owner->GetComponent(row, 0)) == solid)
    {
      sides.push_back({ GetPoint(columns, row, names::SideFrom), GetPoint(columns, row, names::SideTo),
        GetNumber(columns, row, names::StabilityMargin), GetNumber(columns, row, names::TipAngle),
        GetNumber(columns, row, names::CenterOfMassRise) });
    }
  }
  return sides;
}

std::unique_ptr<AnalysisResult> ReadStability(vtkSolidStability* filter, vtkIdType row)
{
  vtkDataSetAttributes* columns = vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetRowData();
  auto result = std::make_unique<StabilityResult>();
  result->Verdict = GetText(columns, row, names::Stability);
  result->Support = GetText(columns, row, names::Support);
  result->DecidedBy = GetText(columns, row, names::DecidedBy);
  result->Margin = GetQuantity<1>(columns, row, names::StabilityMargin);
  result->TipAngle = GetQuantity<1>(columns, row, names::TipAngle);
  result->Rise = GetQuantity<1>(columns, row, names::CenterOfMassRise);
  result->CenterHeight = GetQuantity<1>(columns, row, names::CenterHeight);
  result->RollingMargin = GetQuantity<1>(columns, row, names::RollingMargin);
  result->TipEnergy = GetNumber(columns, row, names::TipEnergy);
  result->RollingRadius = GetNumber(columns, row, names::RollingRadius);
  result->ProjectedCenter.Value = GetPoint(columns, row, names::ProjectedCenterOfMass);
  result->ContactFaces = GetCount(columns, row, names::ContactFaces);
  result->ContactEdges = GetCount(columns, row, names::ContactEdges);
  result->Sides = ReadSides(filter, row);
  return result;
}
}

const char* StabilityAnalysis::GetMissingModule() const
{
  return nullptr;
}

void StabilityAnalysis::Run(const AnalysisRun& run) const
{
  std::array<double, 3> direction;
  ParseDirection(this->Direction, direction);
  vtkNew<vtkSolidStability> filter;
  filter->SetInputConnection(run.Reader->GetOutputPort());
  filter->SetGravityDirection(direction.data());
  SetUpFilter(filter->GetMassProperties(), run.Options);
  SetUpMass(filter->GetMassProperties(), run.Options);
  filter->GetMassProperties()->SetRelativeTolerance(run.Options.Tolerance);
  // The filter integrates again in the remaining time, so that its status may be worse than that of the file;
  // its messages have the reason.
  const auto update = [&]()
  {
    run.Update(filter);
    AddStatus(filter->GetStatus(), run.File);
    for (int i = 0; i < filter->GetNumberOfMessages(); ++i)
    {
      run.Messages.AddEcho(filter->GetMessage(i));
    }
  };
  update();
  if (filter->GetMassProperties()->GetNumberOfSolids() == 0)
  {
    return;
  }
  run.Drawing = vtkSmartPointer<vtkPolyData>::New();
  run.Drawing->ShallowCopy(filter->GetOutput());
  run.File.Total.Analyses.Set(run.Index, ReadStability(filter, 0));
  if (run.File.Solids.size() == 1)
  {
    run.File.Solids[0].Analyses.Set(run.Index, ReadStability(filter, 0));
    return;
  }
  filter->SetBodies(vtkSolidStability::EACH);
  SetTimeLimit(filter->GetMassProperties(), run.Options);
  update();
  vtkIdType row = 0;
  for (SolidResult& solid : run.File.Solids)
  {
    solid.Analyses.Set(run.Index, ReadStability(filter, row));
    ++row;
  }
}
}
