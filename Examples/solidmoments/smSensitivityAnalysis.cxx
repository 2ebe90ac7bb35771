#include "smSensitivityAnalysis.h"

#include "smFileJob.h"
#include "smFilterSetUp.h"
#include "smMassPropertyNames.h"
#include "smOptions.h"
#include "smQuantities.h"
#include "smReportRows.h"
#include "smResults.h"

#include "vtkCADReader.h"
#include "vtkDataSetAttributes.h"
#include "vtkMassSensitivity.h"
#include "vtkNew.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Returns three numbers of which some may not be known, which are NaN.
VectorQuantity GetVector(vtkFieldData* data, vtkIdType row, const std::string& name)
{
  VectorQuantity quantity;
  vtkDataArray* array = data->GetArray(name.c_str());
  for (int i = 0; array && i < 3; ++i)
  {
    quantity.Value[i] = array->GetComponent(row, i);
  }
  quantity.Bound = GetNumber(data, row, name + names::BoundSuffix);
  return quantity;
}

SensitivityEntry ReadEntry(vtkFieldData* data, vtkIdType row)
{
  SensitivityEntry entry;
  entry.Solid = GetText(data, row, names::Id);
  entry.Face = GetCount(data, row, names::FaceId);
  entry.Volume = GetQuantity<1>(data, row, names::VolumePerOffset);
  entry.Mass = GetQuantity<1>(data, row, names::MassPerOffset);
  entry.Area = GetQuantity<1>(data, row, names::SurfaceAreaPerOffset);
  entry.Center = GetVector(data, row, names::CenterOfMassPerOffset);
  entry.PrincipalMoments = GetVector(data, row, names::PrincipalMomentsPerOffset);
  return entry;
}
}

void SensitivityResult::Visit(Fields& fields, const char* key)
{
  fields
    .Note("",
      "with `--sensitivity`: derivatives by an outward offset of a face; of each solid all faces, of the "
      "file the five that change the volume most")
    .List(key, this->Faces,
      [&fields](SensitivityEntry& entry)
      {
        fields.Note("", "id of its solid").Text("solid", entry.Solid);
        fields.Note("", "entity number").Count("face", entry.Face);
        fields.Note("L^2", "volume per offset").Number("volume", entry.Volume);
        fields.Note("kg/L", "mass per offset").Number("mass", entry.Mass);
        fields.Note("L", "area of the solid per offset, edges intersected anew").Number("area", entry.Area);
        fields.Note("1", "centre of mass of the solid per offset")
          .Point("center_of_mass", entry.Center.Value);
        fields.Note("L^4", "per offset; unknown where moments coincide")
          .Point("principal_moments", entry.PrincipalMoments.Value);
        fields.Note("", "of the quantities with the same names").Begin("bounds");
        fields.Number("volume", entry.Volume.Bound);
        fields.Number("mass", entry.Mass.Bound);
        fields.Number("area", entry.Area.Bound);
        fields.Number("center_of_mass", entry.Center.Bound);
        fields.Number("principal_moments", entry.PrincipalMoments.Bound);
        fields.End();
      });
}

std::string SensitivityResult::FormatRows(const std::string& unit) const
{
  std::string text;
  for (const SensitivityEntry& entry : this->Faces)
  {
    std::string value = "face #" + std::to_string(entry.Face) + " of solid " + entry.Solid + ": " +
      FormatValue(entry.Volume.Get(), entry.Volume.Bound) + " " + RaiseUnit(unit, 3);
    value += entry.Mass.IsKnown() ? ", " + FormatValue(entry.Mass.Get(), entry.Mass.Bound) + " kg" : "";
    value += entry.Area.IsKnown()
      ? ", area " + FormatValue(entry.Area.Get(), entry.Area.Bound) + " " + RaiseUnit(unit, 2)
      : "";
    value += ", centre " + FormatVector(entry.Center.Value, entry.Center.Bound) + " " + unit;
    text += Row(text.empty() ? "per " + unit + " of offset" : "", value, "");
  }
  return text;
}

void SensitivityAnalysis::Declare(CLI::App& app)
{
  app.option_defaults()->group("Analyses");
  app.add_flag("--sensitivity", this->Wanted,
    "How volume, mass, area, centre and principal moments of each solid change if one\n"
    "face is moved outwards, per unit of length");
}

std::unique_ptr<AnalysisResult> SensitivityAnalysis::MakeResult() const
{
  return std::make_unique<SensitivityResult>();
}

void SensitivityAnalysis::Run(const AnalysisRun& run) const
{
  vtkNew<vtkMassSensitivity> filter;
  SetUpFilter(filter, run.Options);
  SetUpMass(filter, run.Options);
  filter->SetRelativeTolerance(run.Options.Tolerance);
  filter->SetInputConnection(run.Reader->GetOutputPort());
  run.Update(filter);
  vtkTable* faces = vtkTable::SafeDownCast(filter->GetOutputDataObject(3));
  std::vector<SensitivityEntry>& all = run.File.Analyses.Find<SensitivityResult>()->Faces;
  for (vtkIdType row = 0; row < faces->GetNumberOfRows(); ++row)
  {
    const SensitivityEntry entry = ReadEntry(faces->GetRowData(), row);
    const long long solid = GetCount(faces->GetRowData(), row, names::Solid);
    run.File.Solids.at(static_cast<std::size_t>(solid))
      .Analyses.Find<SensitivityResult>()
      ->Faces.push_back(entry);
    if (entry.Volume.IsKnown())
    {
      all.push_back(entry);
    }
  }
  std::stable_sort(all.begin(), all.end(),
    [](const SensitivityEntry& a, const SensitivityEntry& b) { return a.Volume.Get() > b.Volume.Get(); });
  all.resize(std::min(all.size(), SensitivityResult::MaxFacesOfFile));
  run.Colors = { vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(5)),
    names::VolumePerOffset,
    "volume per offset, " + run.File.FormatUnit(3) + " per " + run.File.FormatUnit(1) };
  AddEffort(filter, run.File, run.Messages);
}
}
