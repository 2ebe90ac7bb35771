#include "smResults.h"

#include "smFileJob.h"
#include "smMassPropertyNames.h"
#include "smReportRows.h"

#include "vtkBoundingBox.h"
#include "vtkDataSetAttributes.h"
#include "vtkNURBSDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstring>

namespace sm
{
namespace
{
void Visit(Fields& fields, EdgeResult& edge)
{
  fields.Count("id", edge.Id);
  fields.Text("name", edge.Name);
  fields.Count("uses", edge.Uses);
  fields.Flag("open", edge.IsOpen);
  fields.Number("max_gap", edge.MaxGap);
  fields.Number("gap_area", edge.GapArea);
  fields.Number("gap_squared", edge.GapSquared);
}

void Visit(Fields& fields, StageSeconds& seconds)
{
  fields.Number("start", seconds.Start);
  fields.Number("read", seconds.Read);
  fields.Number("parse", seconds.Parse);
  fields.Number("transfer", seconds.Transfer);
  fields.Number("trims", seconds.Trims);
  fields.Number("prepare", seconds.Prepare);
  fields.Number("mesh", seconds.Mesh);
  fields.Number("convert", seconds.Convert);
  fields.Number("cut", seconds.Cut);
  fields.Number("plan", seconds.Plan);
  fields.Number("upload", seconds.Upload);
  fields.Number("integrate", seconds.Integrate);
  fields.Number("analyse", seconds.Analyse);
}

Status FindStatus(const std::string& text)
{
  for (int i = 0; i <= static_cast<int>(Status::Unreadable); ++i)
  {
    if (text == GetText(static_cast<Status>(i)))
    {
      return static_cast<Status>(i);
    }
  }
  return Status::None;
}

void Visit(Fields& fields, PartsSums& sums)
{
  const bool isWhole = sums.HasWholeMass();
  double volume = sums.Volume.GetValue(), volumeBound = sums.Volume.GetBound();
  double area = sums.Area.GetValue(), areaBound = sums.Area.GetBound();
  double known = sums.Mass.GetValue(), knownBound = sums.Mass.GetBound();
  double mass = isWhole ? known : Unknown, massBound = isWhole ? knownBound : Unknown;
  long long withMass = sums.Mass.Terms, withVolume = sums.Volume.Terms;
  fields.Number("volume", volume);
  fields.Number("area", area);
  fields.Number("mass", mass);
  fields.Number("known_mass", known);
  fields.Count("solids_with_mass", withMass);
  fields.Count("solids_with_volume", withVolume);
  fields.Begin("bounds");
  fields.Number("volume", volumeBound);
  fields.Number("area", areaBound);
  fields.Number("mass", massBound);
  fields.Number("known_mass", knownBound);
  fields.End();
  sums.Volume = { volume, volumeBound, static_cast<int>(withVolume) };
  sums.Area = { area, areaBound, std::isnan(area) ? 0 : std::max(sums.Area.Terms, 1) };
  sums.Mass = { known, knownBound, static_cast<int>(withMass) };
}

void VisitNumber(Fields& fields, const char* key, int& number)
{
  long long count = number;
  fields.Count(key, count);
  number = static_cast<int>(count);
}

void Visit(Fields& fields, PartsListEntry& part)
{
  std::string kind = part.IsAssembly ? "assembly" : "part";
  std::string status = GetText(part.Status);
  fields.Text("name", part.Name);
  fields.Text("kind", kind);
  VisitNumber(fields, "count", part.Count);
  VisitNumber(fields, "count_in_all", part.CountInAll);
  VisitNumber(fields, "solids", part.Solids);
  fields.Text("status", status);
  fields.Name("layer", part.Layer);
  fields.Name("material", part.Material);
  fields.Number("density", part.Density);
  fields.Begin("each");
  Visit(fields, part.Each);
  fields.End();
  fields.Begin("in_all");
  Visit(fields, part.InAll);
  fields.End();
  fields.List("children", part.Children, [&](PartsListEntry& child) { Visit(fields, child); });
  part.IsAssembly = kind == "assembly";
  part.Status = FindStatus(status);
}

/// Returns for each solid the edges with the widest gaps, at most five, without edges that have no gap. In the table the widest gap is
/// first.
void ReadWorstEdges(vtkTable* table, std::vector<SolidResult>& solids)
{
  constexpr std::size_t most = 5;
  vtkDataSetAttributes* columns = table->GetRowData();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const double widest = GetNumber(columns, row, names::MaxGap);
    if (!(widest != 0.0) || std::isnan(widest))
    {
      break;
    }
    std::vector<EdgeResult>& edges =
      solids.at(static_cast<std::size_t>(GetCount(columns, row, names::Solid))).WorstEdges;
    if (edges.size() == most)
    {
      continue;
    }
    edges.push_back({ GetCount(columns, row, names::EdgeId), GetText(columns, row, names::Name),
      GetCount(columns, row, names::Uses), GetCount(columns, row, names::Open) != 0, widest,
      GetNumber(columns, row, names::GapArea), GetNumber(columns, row, names::GapSquared) });
  }
}
}

AnalysisResults& AnalysisResults::operator=(const AnalysisResults& other)
{
  std::vector<std::unique_ptr<AnalysisResult>> copies;
  for (const std::unique_ptr<AnalysisResult>& result : other.Results)
  {
    copies.push_back(result ? result->Clone() : nullptr);
  }
  this->Results = std::move(copies);
  return *this;
}

void AnalysisResults::Set(std::size_t index, std::unique_ptr<AnalysisResult> result)
{
  this->Results.resize(std::max(this->Results.size(), index + 1));
  this->Results[index] = std::move(result);
}

FileResult::FileResult(const JobOptions& options)
  : File(options.FileName)
  , Status(names::StatusUnreadable)
  , Known(options.Analyses)
{
  for (std::size_t i = 0; i < this->Known.size(); ++i)
  {
    if (!this->Known[i]->IsOfBodies() && this->Known[i]->IsWanted())
    {
      this->Analyses.Set(i, this->Known[i]->MakeResult());
    }
  }
}

SolidResult FileResult::MakeSolid() const
{
  SolidResult solid;
  solid.Analyses = this->Analyses;
  return solid;
}

std::string FileResult::FormatUnit(int power) const
{
  return RaiseUnit(this->LengthUnit.value_or(""), power);
}

std::string FileResult::FormatAnalyses() const
{
  std::string text;
  for (const AnalysisResults* results : { &this->Total.Analyses, &this->Analyses })
  {
    for (std::size_t i = 0; i < this->Known.size(); ++i)
    {
      text += results->Get(i) ? results->Get(i)->FormatRows(this->FormatUnit(1)) : "";
    }
  }
  return text;
}

void FileResult::AddColumns(const AnalysisResults& results, Columns& columns) const
{
  for (std::size_t i = 0; i < this->Known.size(); ++i)
  {
    if (results.Get(i))
    {
      results.Get(i)->AddColumns(columns);
    }
  }
}

void FileResult::VisitAnalyses(Fields& fields, AnalysisResults& results, bool ofBodies)
{
  std::vector<std::size_t> order(this->Known.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  // Version 2 of the document has the sections of a solid first.
  std::stable_partition(order.begin(), order.end(),
    [this](std::size_t i) { return std::strcmp(this->Known[i]->GetKey(), "sections") == 0; });
  for (const std::size_t i : order)
  {
    const Analysis& analysis = *this->Known[i];
    if ((!ofBodies && analysis.IsOfBodies()) || !fields.Has(results.Get(i) != nullptr))
    {
      continue;
    }
    if (!results.Get(i))
    {
      results.Set(i, analysis.MakeResult());
    }
    results.Get(i)->Visit(fields, analysis.GetKey());
  }
}

void FileResult::VisitBody(Fields& fields, BodyResult& body, const std::function<void()>& inBounds)
{
  body.Visit(fields,
    [&]()
    {
      fields.Number("bounding_box", body.LowCorner.Bound);
      if (inBounds)
      {
        inBounds();
      }
    });
  fields.Number("paper_error_estimate", body.PaperErrorEstimate);
  fields.Number("paper_error_estimate_with_boundary", body.PaperErrorEstimateWithBoundary);
  fields.Count("sub_patches", body.SubPatches);
  std::array<double, 6> box;
  std::copy(body.LowCorner.Value.begin(), body.LowCorner.Value.end(), box.begin());
  std::copy(body.HighCorner.Value.begin(), body.HighCorner.Value.end(), box.begin() + 3);
  fields.Numbers("bounding_box", box.data(), 2, 3);
  std::copy_n(box.begin(), 3, body.LowCorner.Value.begin());
  std::copy_n(box.begin() + 3, 3, body.HighCorner.Value.begin());
}

void FileResult::VisitSolid(Fields& fields, SolidResult& solid)
{
  fields.Text("name", solid.Name);
  fields.Text("id", solid.Id);
  fields.Text("path", solid.Path);
  fields.Text("status", solid.Status);
  this->VisitBody(fields, solid);
  fields.List("worst_edges", solid.WorstEdges, [&](EdgeResult& edge) { sm::Visit(fields, edge); });
  this->VisitAnalyses(fields, solid.Analyses, true);
}

void FileResult::VisitRun(Fields& fields)
{
  fields.Text("scheme", this->Scheme);
  if (fields.Begin("scheme_options", this->SchemeOptions.has_value()))
  {
    this->SchemeOptions = this->SchemeOptions.value_or(SchemeResult());
    fields.Count("sub_patch_factor", this->SchemeOptions->SubPatchFactor);
    fields.Count("texture_factor", this->SchemeOptions->TextureFactor);
    fields.Number("chord_tolerance", this->SchemeOptions->ChordTolerance);
    fields.Text("deviation", this->SchemeOptions->Deviation);
    fields.End();
  }
  fields.Text("backend", this->Backend);
  fields.Text("renderer", this->Renderer);
  fields.Text("backend_reason", this->BackendReason);
  fields.Begin("estimate");
  fields.Count("evaluations", this->EstimatedEvaluations);
  fields.Number("cpu_seconds", this->EstimatedCPUSeconds);
  fields.Number("opengl_seconds", this->EstimatedOpenGLSeconds);
  fields.End();
  if (fields.Begin("frame", !this->Frame.empty()))
  {
    this->Frame.resize(9);
    fields.Numbers("origin", this->Frame.data(), 1, 3);
    fields.Numbers("z_axis", this->Frame.data() + 3, 1, 3);
    fields.Numbers("x_axis", this->Frame.data() + 6, 1, 3);
    fields.End();
  }
}

void FileResult::Visit(Fields& fields)
{
  VisitFileName(fields, this->File);
  fields.Text("length_unit", this->LengthUnit);
  fields.Text("status", this->Status);
  fields.Texts("messages", this->Messages);
  this->VisitRun(fields);
  fields.Begin("total");
  this->VisitBody(fields, this->Total, [&]() { fields.Number("known_mass", this->Total.KnownMass.Bound); });
  fields.Number("known_mass", this->Total.KnownMass);
  fields.Count("solids_with_mass", this->Total.SolidsWithMass);
  fields.Count("solids_with_volume", this->Total.SolidsWithVolume);
  this->VisitAnalyses(fields, this->Total.Analyses, true);
  fields.End();
  fields.List("solids", this->Solids, [&](SolidResult& solid) { this->VisitSolid(fields, solid); });
  // These keys exist without a request, too, and in every build.
  fields.Begin("integrals");
  fields.End();
  for (const char* key : { "waterlines", "sections" })
  {
    fields.BeginList(key, 0);
    fields.EndList();
  }
  fields.Count("faces", this->Faces);
  fields.Count("free_faces", this->FreeFaces);
  fields.Number("diagonal", this->Diagonal);
  fields.Count("evaluations", this->Evaluations);
  fields.Count("dispatches", this->Dispatches);
  fields.Begin("seconds");
  sm::Visit(fields, this->Seconds);
  fields.End();
  if (fields.Has(this->Parts.has_value()))
  {
    this->Parts = this->Parts.value_or(std::vector<PartsListEntry>());
    fields.List("parts", *this->Parts, [&](PartsListEntry& part) { sm::Visit(fields, part); });
  }
  if (fields.Has(this->Validation.has_value()))
  {
    this->Validation = this->Validation.value_or(std::vector<ValidationEntry>());
    fields.List("validation", *this->Validation, [&](ValidationEntry& entry) { entry.Visit(fields); });
  }
  this->VisitAnalyses(fields, this->Analyses, false);
}

bool HasMixedDensities(const Quantities& total)
{
  return total.Mass.IsKnown() && std::isnan(total.Density);
}

void ReadTotal(vtkFieldData* fields, TotalResult& total)
{
  static_cast<Quantities&>(total) = ReadQuantities(fields, 0);
  Scheme::ReadBody(fields, 0, total);
  total.KnownMass = GetQuantity<1>(fields, 0, names::KnownMass);
  total.SolidsWithMass = GetCount(fields, 0, names::SolidsWithMass);
  total.SolidsWithVolume = GetCount(fields, 0, names::SolidsWithVolume);
}

void ReadSolids(vtkTable* table, vtkTable* edges, FileResult& file)
{
  vtkDataSetAttributes* columns = table->GetRowData();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    SolidResult solid = file.MakeSolid();
    static_cast<Quantities&>(solid) = ReadQuantities(columns, row);
    Scheme::ReadBody(columns, row, solid);
    solid.Name = GetText(columns, row, names::Name);
    solid.Id = GetText(columns, row, names::Id);
    solid.Path = GetText(columns, row, names::Path);
    solid.Status = GetText(columns, row, names::Status);
    file.Solids.push_back(std::move(solid));
  }
  ReadWorstEdges(edges, file.Solids);
}

double GetDiagonal(vtkDataObject* input)
{
  vtkBoundingBox box;
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(input);
  for (unsigned int i = 0; parts && i < parts->GetNumberOfPartitionedDataSets(); ++i)
  {
    for (unsigned int j = 0; j < parts->GetNumberOfPartitions(i); ++j)
    {
      auto* solid = vtkNURBSDataSet::SafeDownCast(parts->GetPartitionAsDataObject(i, j));
      double bounds[6];
      if (solid && solid->GetBodyBounds(bounds))
      {
        box.AddBounds(bounds);
      }
    }
  }
  return box.IsValid() ? box.GetDiagonalLength() : Unknown;
}
}
