#include "smToleranceAnalysis.h"

#include "smDrawingTolerances.h"
#include "smFileJob.h"
#include "smFilterSetUp.h"
#include "smFormat.h"
#include "smInputFile.h"
#include "smMassPropertyNames.h"
#include "smMessageList.h"
#include "smOptions.h"
#include "smQuantities.h"
#include "smReportRows.h"
#include "smResults.h"
#include "smText.h"
#include "smTrimText.h"

#include "vtkCADReader.h"
#include "vtkDataSetAttributes.h"
#include "vtkMassTolerances.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace sm
{
namespace
{
ToleranceRange ReadRange(vtkFieldData* data, vtkIdType row, const std::string& name)
{
  return { GetNumber(data, row, name + "Lower"), GetNumber(data, row, name + "Upper"),
    GetNumber(data, row, name + "Deviation") };
}

std::unique_ptr<ToleranceResult> ReadTolerance(vtkFieldData* data, vtkIdType row)
{
  auto result = std::make_unique<ToleranceResult>();
  result->Volume = ReadRange(data, row, names::Volume);
  result->Mass = ReadRange(data, row, names::Mass);
  result->CenterReach = GetNumber(data, row, names::CenterOfMassReach);
  result->InertiaReach = GetNumber(data, row, names::VolumeInertiaReach);
  result->PrincipalReach = GetNumber(data, row, names::PrincipalMomentsReach);
  ReadNumbers(data, row, names::CenterOfMassDeviation, result->CenterDeviation.Value.data(), 3);
  ReadNumbers(data, row, names::VolumeInertiaDeviation, result->InertiaDeviation.Value.data(), 9);
  // Those of single moments may be known.
  vtkDataArray* principal = data->GetArray(names::PrincipalMomentsDeviation);
  for (int i = 0; principal && i < 3; ++i)
  {
    result->PrincipalDeviation.Value[i] = principal->GetComponent(row, i);
  }
  return result;
}

ToleranceEntry ReadFace(vtkFieldData* data, vtkIdType row)
{
  return { GetText(data, row, names::Id), GetCount(data, row, names::FaceId),
    GetNumber(data, row, names::ToleranceLower), GetNumber(data, row, names::ToleranceUpper),
    GetNumber(data, row, names::VolumeByTolerance), GetNumber(data, row, names::MassByTolerance) };
}

/// Relative excess of a sum over its rounding.
constexpr double ShareExcess = 1.0 + 1e-12;

/// Returns how far tolerances may move the mass of a solid, at its largest density; NaN if it is not known.
double GetMassShare(const Quantities& body, const ToleranceResult& tolerance)
{
  // The interval has the numerical bound, which is a share of its own.
  const double mass = body.Mass.Get();
  const double reach = std::max(tolerance.Mass.Maximum - mass, mass - tolerance.Mass.Minimum);
  return std::isnan(tolerance.Mass.Maximum)
    ? Unknown
    : ShareExcess * std::max(reach - body.Mass.Bound, 0.0) * (1.0 + body.MassUncertainty[1] / mass);
}

/// Adds the share of the tolerances to the mass in doubt.
void AddMassShare(Quantities& body, double share)
{
  body.MassUncertainty[5] = share;
  body.MassUncertainty[0] = ShareExcess * (body.MassUncertainty[0] + share);
}

/// Adds the shares of the tolerances to the solids, and their sum to the total.
void AddMassShares(const std::vector<std::unique_ptr<ToleranceResult>>& tolerances,
  const ToleranceResult& total, FileResult& file)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < tolerances.size(); ++i)
  {
    SolidResult& solid = file.Solids[i];
    const double share = GetMassShare(solid, *tolerances[i]);
    // Bodies without a volume have no mass that could be off, and stated masses do not change with a volume,
    // those of products in their sum.
    const bool isFixed = solid.OverriddenMass > 0.0 || (std::isnan(share) && !solid.Mass.IsKnown());
    sum += isFixed ? 0.0 : ShareExcess * share;
    AddMassShare(solid, share);
  }
  AddMassShare(file.Total, std::isnan(total.Mass.Maximum) ? Unknown : sum);
}

/// Keeps the faces that add most to the worst case.
void KeepLargest(std::vector<ToleranceEntry>& faces)
{
  std::stable_sort(faces.begin(), faces.end(),
    [](const ToleranceEntry& a, const ToleranceEntry& b) { return a.Volume > b.Volume; });
  faces.resize(std::min(faces.size(), ToleranceResult::MaxFaces));
}

/// Reads one line of a table. Returns an error message; empty if the line is right.
std::string ReadLine(
  const std::string& line, std::vector<ToleranceFileRule>& rules, double& lower, double& upper)
{
  const std::vector<std::string> values = SplitFields(line);
  const std::string kind = LowerCase(values[0]);
  const bool isForAll = kind == "all";
  if (!isForAll && kind != "face" && kind != "part" && kind != "colour" && kind != "color")
  {
    return values[0] + " is not face, part, colour or all";
  }
  const std::size_t numbers = values.size() - std::min<std::size_t>(values.size(), isForAll ? 1 : 2);
  if (numbers != 1 && numbers != 2)
  {
    return "write KIND,PATTERN,TOLERANCE or KIND,PATTERN,LOWER,UPPER, and all without a PATTERN";
  }
  const double last = ParseNumber(values.back());
  const double first = numbers == 2 ? ParseNumber(values[values.size() - 2]) : -last;
  if (!std::isfinite(first) || !(first <= last))
  {
    return "the limits must be numbers, the lower one first; one number is half of a symmetric range";
  }
  if (first > 0.0 || last < 0.0)
  {
    return "a range without 0 leaves out the face of the model, for which no worst case is known; move the "
           "face to the middle of its range";
  }
  if (isForAll)
  {
    lower = first;
    upper = last;
  }
  else if (values[1].empty())
  {
    return "the pattern is empty";
  }
  else
  {
    rules.push_back({ kind, values[1], first, last });
  }
  return {};
}

/// Lists the tolerances of the drawing that the reader found.
std::vector<ListedTolerance> ListDrawing(vtkDataObject* data)
{
  std::vector<ListedTolerance> list;
  for (const DrawingTolerance& tolerance : GetDrawingTolerances(data))
  {
    list.push_back({ tolerance.Id, static_cast<long long>(tolerance.Faces.size()), tolerance.Kind,
      tolerance.Problem, tolerance.Lower, tolerance.Upper });
  }
  return list;
}

/// Reports how many tolerances of the drawing are used, and the reasons why others are not.
void ReportDrawing(const std::vector<ListedTolerance>& drawing, MessageList& messages)
{
  std::map<std::string, std::vector<long long>> reasons;
  std::size_t used = 0;
  for (const ListedTolerance& tolerance : drawing)
  {
    if (tolerance.Problem.empty())
    {
      ++used;
    }
    else
    {
      reasons[tolerance.Kind + ": " + tolerance.Problem].push_back(tolerance.Id);
    }
  }
  messages.AddEcho(std::to_string(used) + " of " + FormatCount(drawing.size(), "tolerance", "tolerances") +
    " of the drawing in the file are used");
  for (const auto& [reason, ids] : reasons)
  {
    std::string text;
    for (std::size_t i = 0; i < std::min<std::size_t>(ids.size(), 5); ++i)
    {
      text += (i > 0 ? ", #" : "#") + std::to_string(ids[i]);
    }
    messages.AddEcho(FormatCount(ids.size(), "tolerance", "tolerances") + " of the drawing not used, " +
      text + (ids.size() > 5 ? ", ..." : "") + ": " + reason);
  }
}

/// The minimum is rounded down and the maximum up, to a thousandth of the width or better.
std::string FormatRange(const ToleranceRange& range, const std::string& unit)
{
  const double width = range.Maximum - range.Minimum;
  if (!(width > 0.0) || !std::isfinite(width))
  {
    return "not known";
  }
  const int digits = std::clamp(static_cast<int>(-std::floor(std::log10(1e-4 * width))), 0, 15);
  const double scale = std::pow(10.0, digits);
  return FormatFixed(std::floor(range.Minimum * scale) / scale, digits) + " to " +
    FormatFixed(std::ceil(range.Maximum * scale) / scale, digits) + " " + unit + ", deviation " +
    Short(range.Deviation);
}

void VisitRange(Fields& fields, const char* key, const char* unit, const char* of, ToleranceRange& range)
{
  fields.Note("", of).Begin(key);
  fields.Note(unit, "worst case").Number("minimum", range.Minimum);
  fields.Note(unit, "worst case").Number("maximum", range.Maximum);
  fields.Note(unit, "standard deviation of independent rigid offsets of the faces")
    .Number("deviation", range.Deviation);
  fields.End();
}
}

std::string ReadTolerances(
  const std::string& argument, std::vector<ToleranceFileRule>& rules, double& lower, double& upper)
{
  const double number = ParseNumber(argument);
  if (!std::isnan(number))
  {
    lower = -number;
    upper = number;
    return number >= 0.0 && std::isfinite(number) ? ""
                                                  : argument + " is not a tolerance; give 0.1, for example";
  }
  const std::optional<std::string> text = ReadTextFile(argument);
  if (!text)
  {
    return "the tolerances " + argument + " are neither a number nor a file that can be read";
  }
  std::istringstream file(*text);
  std::string line;
  for (int place = 1; std::getline(file, line); ++place)
  {
    line = Trim(line);
    if (!line.empty() && line[0] != '#')
    {
      const std::string problem = ReadLine(line, rules, lower, upper);
      if (!problem.empty())
      {
        return argument + ", line " + std::to_string(place) + ": " + problem;
      }
    }
  }
  return {};
}

void ToleranceResult::Visit(Fields& fields, const char* key)
{
  fields
    .Note("",
      "with `--face-tolerance` or `--tolerances`: every solid between those with all faces at their lower "
      "and at their "
      "upper limits, and standard deviations of independent rigid offsets")
    .Begin(key);
  VisitRange(fields, "volume", "L^3", "of the volume", this->Volume);
  VisitRange(fields, "mass", "kg", "of the mass", this->Mass);
  fields.Note("", "no coordinate, entry or moment is farther from the nominal one in the worst case")
    .Begin("reach");
  fields.Note("L", "").Number("center_of_mass", this->CenterReach);
  fields.Note("L^5", "").Number("inertia", this->InertiaReach);
  fields.Note("L^5", "").Number("principal_moments", this->PrincipalReach);
  fields.End();
  fields.Note("", "standard deviations").Begin("deviation");
  fields.Note("L", "").Point("center_of_mass", this->CenterDeviation.Value);
  fields.Note("L^5", "about the centre").Matrix("inertia", this->InertiaDeviation.Value);
  fields.Note("L^5", "unknown where moments coincide")
    .Point("principal_moments", this->PrincipalDeviation.Value);
  fields.End();
  fields.Note("", "the five that add most to the worst case")
    .List("faces", this->Faces,
      [&fields](ToleranceEntry& entry)
      {
        fields.Note("", "id of its solid").Text("solid", entry.Solid);
        fields.Note("", "entity number").Count("face", entry.Face);
        fields.Note("L", "offset along the outward normal").Number("lower", entry.Lower);
        fields.Note("L", "offset along the outward normal").Number("upper", entry.Upper);
        fields.Note("L^3", "area times the larger limit without its sign").Number("volume", entry.Volume);
        fields.Note("kg", "the same of the mass").Number("mass", entry.Mass);
      });
  fields.Note("", "with `--tolerances`, in `total`: all tolerances of the drawing in the file")
    .List("drawing", this->Drawing,
      [&fields](ListedTolerance& tolerance)
      {
        fields.Note("", "entity number").Count("id", tolerance.Id);
        fields.Note("", "`surface profile`, `diameter`, `thickness`, ...").Text("kind", tolerance.Kind);
        fields.Note("", "number of faces that it is linked to").Count("faces", tolerance.Faces);
        fields.Note("L", "offset of these; unknown if it is not used").Number("lower", tolerance.Lower);
        fields.Note("L", "offset of these; unknown if it is not used").Number("upper", tolerance.Upper);
        fields.Note("", "why it is not used").Name("problem", tolerance.Problem);
      });
  fields.End();
}

std::string ToleranceResult::FormatRows(const std::string& unit) const
{
  std::string text = Row("within tolerances", "volume " + FormatRange(this->Volume, RaiseUnit(unit, 3)), "");
  text += std::isfinite(this->Mass.Maximum) ? Row("", "mass " + FormatRange(this->Mass, "kg"), "") : "";
  text += std::isfinite(this->CenterReach)
    ? Row("",
        "centre within " + ShortBound(this->CenterReach) + " " + unit + ", principal moments " +
          ShortBound(this->PrincipalReach) + " " + RaiseUnit(unit, 5),
        "")
    : "";
  for (const ToleranceEntry& entry : this->Faces)
  {
    text += Row(&entry == this->Faces.data() ? "  of it, by faces" : "",
      "face #" + std::to_string(entry.Face) + " of solid " + entry.Solid + ": " + Short(entry.Lower) +
        " to " + Short(entry.Upper) + " " + unit + ", " + Short(entry.Volume) + " " + RaiseUnit(unit, 3) +
        (std::isfinite(entry.Mass) ? ", " + Short(entry.Mass) + " kg" : ""),
      "");
  }
  return text;
}

void ToleranceAnalysis::Declare(CLI::App& app)
{
  app.option_defaults()->group("Analyses");
  app
    .add_option("--face-tolerance", this->Tolerance,
      "What tolerances of faces leave open in volume, mass, centre and inertia:\n"
      "all faces may be off by T to either side (0.1, in the unit of the\n"
      "output); or a file of CSV with lines KIND,PATTERN,T or\n"
      "KIND,PATTERN,LOWER,UPPER, KIND being face (#123 or a name), part, colour\n"
      "(#rrggbb), or all without a PATTERN. The first line that fits counts")
    ->type_name("T|FILE")
    ->expected(1);
  app.add_flag("--tolerances", this->FromFile,
    "The same with the tolerances of the drawing in the file (AP242): surface\n"
    "profiles with a datum, plus-minus on diameters and thicknesses. What is not\n"
    "used is listed. Lines of --face-tolerance come before, its T is for all\n"
    "other faces");
  app
    .add_option("--tolerance-distribution", this->Distribution,
      "How offsets are distributed between the limits, for the standard\n"
      "deviations: uniform, or normal with limits at three deviations")
    ->type_name("NAME")
    ->check(CLI::IsMember({ "uniform", "normal" }))
    ->expected(1);
}

std::string ToleranceAnalysis::FindProblem(const CLI::App& app) const
{
  if (!this->IsWanted())
  {
    return app.count("--tolerance-distribution") > 0
      ? "--tolerance-distribution is for --face-tolerance or --tolerances, which are missing"
      : "";
  }
  if (this->Tolerance.empty() || this->IsRead)
  {
    return {};
  }
  const std::string problem = ReadTolerances(this->Tolerance, this->Rules, this->Lower, this->Upper);
  this->IsRead = problem.empty();
  return problem;
}

std::string ToleranceAnalysis::GetInputFile() const
{
  return std::isnan(ParseNumber(this->Tolerance)) ? this->Tolerance : std::string();
}

void ToleranceAnalysis::Run(const AnalysisRun& run) const
{
  std::vector<ListedTolerance> drawing;
  if (this->FromFile)
  {
    drawing = ListDrawing(run.Reader->GetOutputDataObject(0));
    ReportDrawing(drawing, run.Messages);
  }
  vtkNew<vtkMassTolerances> filter;
  SetUpFilter(filter, run.Options);
  SetUpMass(filter, run.Options);
  filter->SetRelativeTolerance(run.Options.Tolerance);
  filter->SetDistribution(
    this->Distribution == "normal" ? vtkMassTolerances::NORMAL : vtkMassTolerances::UNIFORM);
  filter->SetFaceTolerance(this->Lower, this->Upper);
  filter->SetUseDrawing(this->FromFile);
  for (const ToleranceFileRule& rule : this->Rules)
  {
    filter->AddTolerance(rule.Kind.c_str(), rule.Pattern.c_str(), rule.Lower, rule.Upper);
  }
  filter->SetInputConnection(run.Reader->GetOutputPort());
  run.Update(filter);
  auto total = ReadTolerance(filter->GetOutput()->GetFieldData(), 0);
  vtkFieldData* columns = vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetRowData();
  std::vector<std::unique_ptr<ToleranceResult>> solids;
  for (std::size_t i = 0; i < run.File.Solids.size(); ++i)
  {
    solids.push_back(ReadTolerance(columns, static_cast<vtkIdType>(i)));
  }
  vtkTable* faces = vtkTable::SafeDownCast(filter->GetOutputDataObject(3));
  long long exact = 0;
  for (vtkIdType row = 0; row < faces->GetNumberOfRows(); ++row)
  {
    const ToleranceEntry entry = ReadFace(faces->GetRowData(), row);
    exact += entry.Lower == 0.0 && entry.Upper == 0.0 ? 1 : 0;
    const auto solid = static_cast<std::size_t>(GetCount(faces->GetRowData(), row, names::Solid));
    if (std::isfinite(entry.Volume) && entry.Volume > 0.0)
    {
      solids.at(solid)->Faces.push_back(entry);
    }
  }
  if (exact > 0)
  {
    run.Messages.AddEcho(std::to_string(exact) + " of " +
      FormatCount(
        faces->GetNumberOfRows(), "face has no tolerance and counts", "faces have no tolerance and count") +
      " as exact; --face-tolerance T is for all faces without one");
  }
  AddMassShares(solids, *total, run.File);
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    KeepLargest(solids[i]->Faces);
    total->Faces.insert(total->Faces.end(), solids[i]->Faces.begin(), solids[i]->Faces.end());
    run.File.Solids[i].Analyses.Set(run.Index, std::move(solids[i]));
  }
  KeepLargest(total->Faces);
  total->Drawing = drawing;
  run.File.Total.Analyses.Set(run.Index, std::move(total));
  run.Colors = { vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(5)),
    names::VolumeByTolerance, "within the tolerance, " + run.File.FormatUnit(3) };
  AddEffort(filter, run.File, run.Messages);
}
}
