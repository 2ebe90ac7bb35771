#include "smResults.h"

#include "smFileJob.h"
#include "smMassPropertyNames.h"
#include "smPartsFields.h"
#include "smReportRows.h"
#include "smText.h"

#include "vtkDataSetAttributes.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstring>

namespace sm
{
namespace
{
void Visit(Fields& fields, EdgeResult& edge)
{
  fields.Note("", "entity number").Count("id", edge.Id);
  fields.Text("name", edge.Name);
  fields.Note("", "number of faces that use it").Count("uses", edge.Uses);
  fields.Note("", "true: its uses do not cancel").Flag("open", edge.IsOpen);
  fields.Note("L", "widest gap").Number("max_gap", edge.MaxGap);
  fields.Note("L^2", "area of the gap").Number("gap_area", edge.GapArea);
  fields.Note("L^3", "integral of the squared gap").Number("gap_squared", edge.GapSquared);
  fields.Note("L^3", "how far closing the gap in another way may change the volume")
    .Number("closure_spread", edge.Spread);
}

void Visit(Fields& fields, StageSeconds& seconds)
{
  fields.Note("s", "context and shaders").Number("start", seconds.Start);
  fields.Note("s", "sum of `parse`, `transfer` and `trims`").Number("read", seconds.Read);
  fields.Note("s", "text to entities").Number("parse", seconds.Parse);
  fields.Note("s", "entities to shapes").Number("transfer", seconds.Transfer);
  fields.Note("s", "inspection of faces, with the trim curves that the file leaves out")
    .Number("trims", seconds.Trims);
  fields.Note("s", "sum of the five below").Number("prepare", seconds.Prepare);
  fields.Note("s", "display mesh").Number("mesh", seconds.Mesh);
  fields.Note("s", "exact conversion").Number("convert", seconds.Convert);
  fields.Note("s", "faces into panels").Number("cut", seconds.Cut);
  fields.Note("s", "orders of the rules").Number("plan", seconds.Plan);
  fields.Note("s", "to the GPU").Number("upload", seconds.Upload);
  fields.Note("s", "").Number("integrate", seconds.Integrate);
  fields.Note("s", "checks of shells, plausibility, tables").Number("analyse", seconds.Analyse);
}

/// Returns for each solid the edges with the widest gaps, at most five, without edges that have no gap. In
/// the table the widest gap is first.
void ReadWorstEdges(vtkTable* table, std::vector<SolidResult>& solids)
{
  constexpr std::size_t maximum = 5;
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
    if (edges.size() == maximum)
    {
      continue;
    }
    edges.push_back({ GetCount(columns, row, names::EdgeId), GetText(columns, row, names::Name),
      GetCount(columns, row, names::Uses), GetCount(columns, row, names::Open) != 0, widest,
      GetNumber(columns, row, names::GapArea), GetNumber(columns, row, names::GapSquared),
      GetNumber(columns, row, names::ClosureSpread) });
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

void FileResult::VisitAnalyses(Fields& fields, AnalysisResults& results, bool ofBodies, bool ofFiles)
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
    if (!(analysis.IsOfBodies() ? ofBodies : ofFiles) || !fields.Has(results.Get(i) != nullptr))
    {
      continue;
    }
    if (!results.Get(i))
    {
      results.Set(i, analysis.MakeResult());
    }
    if (AnalysisResult* result = results.Get(i))
    {
      result->Visit(fields, analysis.GetKey());
    }
  }
}

void FileResult::VisitBody(Fields& fields, BodyResult& body, const std::function<void()>& inBounds)
{
  body.Visit(fields,
    [&]()
    {
      fields.Note("L", "").Number("bounding_box", body.LowCorner.Bound);
      if (inBounds)
      {
        inBounds();
      }
    });
  fields.Note("L^3", "with a scheme of the paper: its estimate of the volume's error, no bound")
    .Number("paper_error_estimate", body.PaperErrorEstimate);
  fields.Note("L^3", "as above, with the boundary")
    .Number("paper_error_estimate_with_boundary", body.PaperErrorEstimateWithBoundary);
  fields.Note("", "with a scheme of the paper").Count("sub_patches", body.SubPatches);
  std::array<double, 6> box;
  std::copy(body.LowCorner.Value.begin(), body.LowCorner.Value.end(), box.begin());
  std::copy(body.HighCorner.Value.begin(), body.HighCorner.Value.end(), box.begin() + 3);
  fields.Note("L", "with `--box`: its lowest and its highest corner")
    .Numbers("bounding_box", box.data(), 2, 3);
  std::copy_n(box.begin(), 3, body.LowCorner.Value.begin());
  std::copy_n(box.begin() + 3, 3, body.HighCorner.Value.begin());
}

void FileResult::VisitSolid(Fields& fields, SolidResult& solid)
{
  fields.Note("", "").Text("name", solid.Name);
  fields.Note("", "unique in the file").Text("id", solid.Id);
  fields.Note("", "with the assemblies above, where single instances differ").Text("path", solid.Path);
  fields.Note("", "").Text("status", solid.Status);
  this->VisitBody(fields, solid);
  fields.Note("", "at most five edges with a gap, the widest first")
    .List("worst_edges", solid.WorstEdges, [&](EdgeResult& edge) { sm::Visit(fields, edge); });
  this->VisitAnalyses(fields, solid.Analyses, true, true);
}

void FileResult::VisitRun(Fields& fields)
{
  fields.Note("", "`adaptive`, or a scheme of the paper").Text("scheme", this->Scheme);
  if (fields.Note("", "options of a scheme of the paper")
        .Begin("scheme_options", this->SchemeOptions.has_value()))
  {
    this->SchemeOptions = this->SchemeOptions.value_or(SchemeResult());
    fields.Count("sub_patch_factor", this->SchemeOptions->SubPatchFactor);
    fields.Count("texture_factor", this->SchemeOptions->TextureFactor);
    fields.Number("chord_tolerance", this->SchemeOptions->ChordTolerance);
    fields.Text("deviation", this->SchemeOptions->Deviation);
    fields.End();
  }
  fields.Note("", "`opengl`, `cpu` or `none`").Text("backend", this->Backend);
  fields.Note("", "name of the OpenGL driver, or number of threads").Text("renderer", this->Renderer);
  fields.Note("", "why `auto` took this backend").Text("backend_reason", this->BackendReason);
  fields.Note("", "what the program expected of the mass properties").Begin("estimate");
  fields.Count("evaluations", this->EstimatedEvaluations);
  fields.Number("cpu_seconds", this->EstimatedCPUSeconds);
  fields.Number("opengl_seconds", this->EstimatedOpenGLSeconds);
  fields.End();
  if (fields.Note("", "with `--about`").Begin("frame", !this->Frame.empty()))
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
  fields.Note("", "L, for example `mm`").Text("length_unit", this->LengthUnit);
  fields.Note("", "the worst of its solids").Text("status", this->Status);
  fields.Note("", "sentences for the user").Texts("messages", this->Messages);
  this->VisitRun(fields);
  fields.Note("", "quantities of all solids together").Begin("total");
  this->VisitBody(fields, this->Total, [&]() { fields.Number("known_mass", this->Total.KnownMass.Bound); });
  fields.Note("kg", "of the total only: mass of the solids that have a density")
    .Number("known_mass", this->Total.KnownMass);
  fields.Note("", "of the total only").Count("solids_with_mass", this->Total.SolidsWithMass);
  fields.Note("", "of the total only").Count("solids_with_volume", this->Total.SolidsWithVolume);
  this->VisitAnalyses(fields, this->Total.Analyses, true, false);
  fields.End();
  fields.Note("", "of each solid the quantities of `total`, and the keys below")
    .List("solids", this->Solids, [&](SolidResult& solid) { this->VisitSolid(fields, solid); });
  // These keys exist without a request, too, and in every build.
  fields.Begin("integrals");
  fields.End();
  for (const char* key : { "waterlines", "sections" })
  {
    fields.BeginList(key, 0);
    fields.EndList();
  }
  fields.Note("", "number of faces of the solids").Count("faces", this->Faces);
  fields.Note("", "number of faces that belong to no solid").Count("free_faces", this->FreeFaces);
  fields.Note("L", "of the bounding box").Number("diagonal", this->Diagonal);
  fields.Note("", "evaluations of surfaces").Count("evaluations", this->Evaluations);
  fields.Note("", "dispatches of compute shaders").Count("dispatches", this->Dispatches);
  fields.Note("", "time of each stage").Begin("seconds");
  sm::Visit(fields, this->Seconds);
  fields.End();
  if (fields.Has(this->Parts.has_value()))
  {
    this->Parts = this->Parts.value_or(std::vector<PartsListEntry>());
    fields.Note("", "with `--bom`: the parts list")
      .List("parts", *this->Parts, [&](PartsListEntry& part) { VisitPart(fields, part); });
  }
  if (fields.Has(this->Validation.has_value()))
  {
    this->Validation = this->Validation.value_or(std::vector<ValidationEntry>());
    fields.Note("", "with `--validate`: an entry for each property that the file states")
      .List("validation", *this->Validation, [&](ValidationEntry& entry) { entry.Visit(fields); });
  }
  this->VisitAnalyses(fields, this->Analyses, false, true);
}

ProductResults FileResult::GetProduct() const
{
  ProductResults product{ this->Status, this->LengthUnit, this->Diagonal, this->Total, {} };
  for (const SolidResult& solid : this->Solids)
  {
    product.Solids.push_back({ solid.Id, solid.Name, solid.Status, solid });
  }
  return product;
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
}
