#include "vtkMassTolerances.h"

#include "Detail/smFaceTolerances.h"
#include "Detail/smMassSensitivity.h"
#include "smBodyMeshes.h"
#include "smColumns.h"
#include "smFormat.h"
#include "smMassAnalysis.h"
#include "smMassIntegrands.h"
#include "smMassPropertyNames.h"

#include "vtkDataSetAttributes.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

vtkStandardNewMacro(vtkMassTolerances);

namespace
{
struct ToleranceColumn
{
  const char* Name;
  int Components;
  const double* (*Get)(const sm::ToleranceRow&);
};

using ToleranceOf = const sm::ToleranceRow&;

const ToleranceColumn ToleranceColumns[] = {
  { sm::names::VolumeLower, 1, [](ToleranceOf r) { return &r.VolumeLower; } },
  { sm::names::VolumeUpper, 1, [](ToleranceOf r) { return &r.VolumeUpper; } },
  { sm::names::VolumeDeviation, 1, [](ToleranceOf r) { return &r.VolumeDeviation; } },
  { sm::names::CenterOfMassReach, 1, [](ToleranceOf r) { return &r.CenterReach; } },
  { sm::names::CenterOfMassDeviation, 3, [](ToleranceOf r) { return r.CenterDeviation.data(); } },
  { sm::names::VolumeInertiaReach, 1, [](ToleranceOf r) { return &r.InertiaReach; } },
  { sm::names::VolumeInertiaDeviation, 9, [](ToleranceOf r) { return r.InertiaDeviation.data(); } },
  { sm::names::PrincipalMomentsReach, 1, [](ToleranceOf r) { return &r.PrincipalReach; } },
  { sm::names::PrincipalMomentsDeviation, 3, [](ToleranceOf r) { return r.PrincipalDeviation.data(); } },
  { sm::names::MassLower, 1, [](ToleranceOf r) { return &r.MassLower; } },
  { sm::names::MassUpper, 1, [](ToleranceOf r) { return &r.MassUpper; } },
  { sm::names::MassDeviation, 1, [](ToleranceOf r) { return &r.MassDeviation; } },
};
constexpr std::size_t MassColumns = 3;

void WriteRows(const sm::ToleranceRow* rows, std::size_t count, bool withMass, sm::columns::Writer& writer)
{
  const auto* end = std::end(ToleranceColumns) - (withMass ? 0 : MassColumns);
  for (const auto* column = std::begin(ToleranceColumns); column != end; ++column)
  {
    double* values = writer.AddDoubles(column->Name, column->Components);
    for (std::size_t i = 0; i < count; ++i)
    {
      values = std::copy_n(column->Get(rows[i]), column->Components, values);
    }
  }
}
}

vtkMassTolerances::vtkMassTolerances()
  : Results(new sm::FaceToleranceResults)
{
}

vtkMassTolerances::~vtkMassTolerances() = default;

void vtkMassTolerances::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FaceTolerance: " << this->FaceTolerance[0] << " " << this->FaceTolerance[1] << "\n"
     << indent << "NumberOfTolerances: " << this->GetNumberOfTolerances() << "\n"
     << indent << "UseDrawing: " << this->UseDrawing << "\n"
     << indent << "Distribution: " << this->Distribution << "\n";
}

bool vtkMassTolerances::CheckRange(double lower, double upper)
{
  if (!(lower <= upper) || !std::isfinite(lower) || !std::isfinite(upper))
  {
    vtkErrorMacro("The tolerance from " << sm::FormatDigits(lower, 6) << " to " << sm::FormatDigits(upper, 6)
                                        << " is not used: give finite limits, the lower one first.");
    return false;
  }
  if (lower > 0.0 || upper < 0.0)
  {
    vtkErrorMacro("The tolerance from "
      << sm::FormatDigits(lower, 6) << " to " << sm::FormatDigits(upper, 6)
      << " is not used: give a range that has 0 in it. Another one excludes the face of the model, and no "
         "worst case is known; move the face to the middle of its range first.");
    return false;
  }
  return true;
}

void vtkMassTolerances::SetFaceTolerance(double lower, double upper)
{
  if (this->CheckRange(lower, upper) && (lower != this->FaceTolerance[0] || upper != this->FaceTolerance[1]))
  {
    this->FaceTolerance[0] = lower;
    this->FaceTolerance[1] = upper;
    this->Modified();
  }
}

void vtkMassTolerances::SetFaceTolerance(double tolerance)
{
  this->SetFaceTolerance(-tolerance, tolerance);
}

void vtkMassTolerances::AddTolerance(const char* kind, const char* pattern, double lower, double upper)
{
  sm::FaceToleranceRule rule;
  if (!kind || !sm::FindToleranceKind(kind, rule.By) || !pattern || !*pattern)
  {
    vtkErrorMacro("The tolerance for \"" << (kind ? kind : "") << "\" \"" << (pattern ? pattern : "")
                                         << "\" is not used: give face, part or colour, and a pattern.");
    return;
  }
  if (this->CheckRange(lower, upper))
  {
    rule.Pattern = pattern;
    rule.Lower = lower;
    rule.Upper = upper;
    this->Rules.push_back(rule);
    this->Modified();
  }
}

void vtkMassTolerances::AddTolerance(
  const char* kind, const char* pattern, const char* lower, const char* upper)
{
  double limits[2] = { 0.0, 0.0 };
  const std::string texts[2] = { lower ? lower : "", upper ? upper : "" };
  for (int i = 0; i < 2; ++i)
  {
    // std::from_chars expects a decimal point in every locale.
    const char* last = texts[i].data() + texts[i].size();
    const auto [end, error] = std::from_chars(texts[i].data(), last, limits[i]);
    if (error != std::errc() || end != last)
    {
      vtkErrorMacro("The limit \"" << texts[i] << "\" of the tolerance for " << (pattern ? pattern : "")
                                   << " is not a number; give one with a decimal point, for example -0.1.");
      return;
    }
  }
  this->AddTolerance(kind, pattern, limits[0], limits[1]);
}

void vtkMassTolerances::ClearTolerances()
{
  if (!this->Rules.empty())
  {
    this->Rules.clear();
    this->Modified();
  }
}

int vtkMassTolerances::GetNumberOfTolerances() const
{
  return static_cast<int>(this->Rules.size());
}

void vtkMassTolerances::ResetResults()
{
  this->Superclass::ResetResults();
  *this->Results = sm::FaceToleranceResults();
}

void vtkMassTolerances::AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies)
{
  this->Superclass::AnalyzeBodies(bodies);
  const sm::MassAnalysis& analysis = this->GetAnalysis();
  std::vector<sm::FaceToleranceRule> rules = this->Rules;
  if (this->UseDrawing)
  {
    const std::vector<sm::FaceToleranceRule> drawing =
      sm::MakeDrawingRules(sm::GetDrawingTolerances(this->GetInputDataObject(0, 0)));
    rules.insert(rules.end(), drawing.begin(), drawing.end());
  }
  const sm::FaceToleranceOptions options = { rules, this->FaceTolerance[0], this->FaceTolerance[1],
    this->Distribution == NORMAL };
  *this->Results =
    sm::ComputeFaceTolerances(bodies, analysis.Rows, analysis.Total, this->GetOffsets(), options);
  std::vector<std::string>& messages = this->GetEngine().GetReport().Messages;
  messages.insert(messages.end(), this->Results->Messages.begin(), this->Results->Messages.end());
}

void vtkMassTolerances::WriteOutputs(
  const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const
{
  this->Superclass::WriteOutputs(bodies, outputs);
  const sm::MassAnalysis& analysis = this->GetAnalysis();
  const bool hasMass = analysis.HasMass || this->Density > 0.0;
  sm::columns::Writer totals(outputs.Arrays, outputs.Totals->GetFieldData());
  WriteRows(&this->Results->Total, 1, hasMass, totals);
  sm::columns::Writer solids(outputs.Arrays, outputs.Solids->GetRowData(), bodies.size());
  WriteRows(this->Results->Rows.data(), bodies.size(), hasMass, solids);
  std::size_t rows = 0;
  for (const std::vector<sm::OffsetRange>& ranges : this->Results->Ranges)
  {
    rows += ranges.size();
  }
  sm::columns::Writer faces(outputs.Arrays, outputs.Faces->GetRowData(), rows);
  for (const sm::MeshArray& array : this->GetMeshArrays(bodies))
  {
    if (array.Name == sm::names::ToleranceLower || array.Name == sm::names::ToleranceUpper ||
      array.Name == sm::names::VolumeByTolerance || array.Name == sm::names::MassByTolerance)
    {
      double* values = faces.AddDoubles(array.Name);
      for (std::size_t b = 0; b < bodies.size(); ++b)
      {
        for (std::size_t f = 0; f < this->Results->Ranges[b].size(); ++f)
        {
          *values++ = array.GetValue(b, f);
        }
      }
    }
  }
}

std::vector<sm::MeshArray> vtkMassTolerances::GetMeshArrays(
  const std::vector<sm::BodyIntegrals>& bodies) const
{
  std::vector<sm::MeshArray> arrays = this->Superclass::GetMeshArrays(bodies);
  const std::vector<std::vector<sm::OffsetRange>>& ranges = this->Results->Ranges;
  const auto getVolume = [this, &ranges, &bodies](std::size_t body, std::size_t face)
  {
    return sm::HasAreaMoments(bodies[body], this->GetAnalysis().Rows[body], face)
      ? ranges[body][face].GetLargest() * (*bodies[body].Faces)[face].Face[sm::MassArea]
      : vtkMath::Nan();
  };
  arrays.push_back({ sm::names::ToleranceLower,
    [&ranges](std::size_t body, std::size_t face) { return ranges[body][face].Lower; } });
  arrays.push_back({ sm::names::ToleranceUpper,
    [&ranges](std::size_t body, std::size_t face) { return ranges[body][face].Upper; } });
  arrays.push_back({ sm::names::VolumeByTolerance, getVolume });
  arrays.push_back({ sm::names::MassByTolerance, [this, getVolume](std::size_t body, std::size_t face) {
                      return getVolume(body, face) * this->GetAnalysis().Rows[body].GetAddedDensity();
                    } });
  return arrays;
}
