#include "smIntegralAnalysis.h"

#include "smColumns.h"
#include "smFileJob.h"
#include "smFilterSetUp.h"
#include "smMassPropertyNames.h"
#include "smOptionValues.h"
#include "smOptions.h"
#include "smReportRows.h"
#include "smResults.h"
#include "smTableText.h"
#include "smUserExpression.h"

#include "vtkCADReader.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkSurfaceIntegralGPU.h"
#include "vtkTable.h"

#include <algorithm>
#include <set>

namespace sm
{
namespace
{
/// Highest degree of moments that the options accept.
constexpr int MaxMomentDegree = 16;

/// Splits "NAME=EXPR"; returns false if a part is missing.
bool ParseIntegral(const std::string& text, std::string& name, std::string& expression)
{
  const std::string::size_type equals = text.find('=');
  if (equals == std::string::npos)
  {
    return false;
  }
  name = text.substr(0, equals);
  expression = text.substr(equals + 1);
  return !name.empty() && expression.find_first_not_of(" \t\n") != std::string::npos;
}

std::string CheckDegree(const std::string& text)
{
  const double value = ParseNumber(text);
  return value >= 0.0 && value <= MaxMomentDegree && value == std::floor(value)
    ? ""
    : "the degree of moments must be a whole number from 0 to " + std::to_string(MaxMomentDegree);
}

std::string CheckIntegral(const std::string& text)
{
  std::string name;
  std::string expression;
  return ParseIntegral(text, name, expression)
    ? ""
    : text + " is not an integral; write NAME=EXPRESSION, for example 'area=dA'";
}

double Component(vtkDataSetAttributes* columns, vtkIdType row, const std::string& name)
{
  vtkDataArray* array = columns->GetArray(name.c_str());
  return array && row < array->GetNumberOfTuples() ? array->GetComponent(row, 0) : Unknown;
}

// The time to compile a shader grows faster than its number of integrals: 969 integrals take more than 15
// minutes (llvmpipe).
constexpr int MomentsPerFilter = 40;

template <typename AddMoment>
void ListMoments(int degree, const AddMoment& add)
{
  for (int total = 0; total <= degree; ++total)
  {
    for (int i = total; i >= 0; --i)
    {
      for (int j = total - i; j >= 0; --j)
      {
        const int k = total - i - j;
        add("moment_" + std::to_string(i) + "_" + std::to_string(j) + "_" + std::to_string(k), i, j, k);
      }
    }
  }
}

/// Makes filters with the integrands of the options. Moments get filters without expressions, because an
/// expression would make their bounds estimates.
std::vector<vtkSmartPointer<vtkSurfaceIntegralGPU>> MakeFilters(
  int degree, const std::vector<std::string>& integrals)
{
  std::vector<vtkSmartPointer<vtkSurfaceIntegralGPU>> filters;
  ListMoments(degree,
    [&filters](const std::string& name, int i, int j, int k)
    {
      if (filters.empty() || filters.back()->GetNumberOfIntegrands() == MomentsPerFilter)
      {
        filters.push_back(vtkSmartPointer<vtkSurfaceIntegralGPU>::New());
        if (filters.size() > 1)
        {
          // The volume, from which each filter knows shells that are inside out.
          filters.back()->AddVolumeMoment("moment_0_0_0", 0, 0, 0);
        }
      }
      filters.back()->AddVolumeMoment(name, i, j, k);
    });
  const auto expressions = vtkSmartPointer<vtkSurfaceIntegralGPU>::New();
  filters.push_back(expressions);
  for (const std::string& text : integrals)
  {
    std::string name;
    std::string expression;
    if (ParseIntegral(text, name, expression))
    {
      expressions->AddIntegrand(name, expression);
    }
  }
  return filters;
}

/// Returns a name that two integrals, or an integral and another column of the results, would share; empty if
/// there is none.
std::string FindClash(int degree, const std::vector<std::string>& integrals)
{
  std::set<std::string> taken(std::begin(names::ReservedColumnNames), std::end(names::ReservedColumnNames));
  ListMoments(degree, [&taken](const std::string& name, int, int, int) { taken.insert(name); });
  std::string name;
  std::string expression;
  for (const std::string& text : integrals)
  {
    if (ParseIntegral(text, name, expression) && !taken.insert(name).second)
    {
      return name;
    }
  }
  for (const std::string& text : integrals)
  {
    if (ParseIntegral(text, name, expression) && taken.count(name + names::BoundSuffix) > 0)
    {
      return name + names::BoundSuffix;
    }
  }
  return {};
}
}

void IntegralResult::Set(const std::string& name, double value, double bound)
{
  for (Entry& entry : this->Entries)
  {
    if (entry.Name == name)
    {
      entry.Value.Value[0] = value;
      entry.Value.Bound = bound;
    }
  }
}

void IntegralResult::Visit(Fields& fields, const char* key)
{
  fields.Note("", "with `--moments` and `--integral`: by name, `value` and `bound`").Begin(key);
  for (Entry& entry : this->Entries)
  {
    fields.Begin(entry.Name.c_str());
    fields.Number("value", entry.Value);
    fields.Number("bound", entry.Value.Bound);
    fields.End();
  }
  fields.End();
}

void IntegralResult::AddColumns(Columns& columns) const
{
  for (const Entry& entry : this->Entries)
  {
    // An integral of the user may have the name of a column.
    const bool isTaken = columns.Has(entry.Name) || columns.Has(entry.Name + "_bound");
    const std::string stem = (isTaken ? "integral_" : "") + entry.Name;
    columns.Add(stem, entry.Value.Get());
    columns.Add(stem + "_bound", entry.Value.Bound);
  }
}

std::string IntegralResult::FormatRows(const std::string&) const
{
  constexpr std::size_t maximum = 40;
  std::string text;
  for (std::size_t i = 0; i < std::min(this->Entries.size(), maximum); ++i)
  {
    text += MeasuredRow(this->Entries[i].Name, this->Entries[i].Value, "");
  }
  return this->Entries.size() > maximum ? text + "  ... and " +
      Count(static_cast<long long>(this->Entries.size() - maximum), "more integral", "more integrals") +
      ", see --json\n"
                                        : text;
}

void IntegralAnalysis::Declare(CLI::App& app)
{
  app.option_defaults()->group("Other integrals");
  app
    .add_option("--moments", this->MomentDegree,
      "Integrals of x^i y^j z^k over the volume, i + j + k up to DEGREE:\n"
      "moment_i_j_k")
    ->type_name("DEGREE")
    ->check(CheckDegree);
  AddRepeatedOption(app, "--integral",
    "Integral over the faces of an expression (GLSL) of position, normal (of\n"
    "the length of the area element dA), unitNormal, u, v, du, dv, duu, duv,\n"
    "dvv, meanCurvature, gaussianCurvature; with OpenGL only; may be given\n"
    "several times: --integral 'willmore=pow(meanCurvature, 2) * dA'",
    [this](const std::string& text) { this->Integrals.push_back(text); })
    ->type_name("NAME=EXPR")
    ->check(CheckIntegral);
}

std::string IntegralAnalysis::FindProblem(const CLI::App&) const
{
  const std::string clash = FindClash(this->MomentDegree, this->Integrals);
  if (!clash.empty())
  {
    return "two results would be called " + clash + ": give an integral another name";
  }
  for (const std::string& text : this->Integrals)
  {
    std::string name;
    std::string expression;
    ParseIntegral(text, name, expression);
    const std::string error = UserExpression(expression, {}).GetError();
    if (!error.empty())
    {
      return "the integral " + name + " cannot be computed: " + error;
    }
  }
  return {};
}

std::unique_ptr<AnalysisResult> IntegralAnalysis::MakeResult() const
{
  auto result = std::make_unique<IntegralResult>();
  const auto add = [&result](const std::string& name) { result->Entries.push_back({ name, {} }); };
  ListMoments(this->MomentDegree, [&add](const std::string& name, int, int, int) { add(name); });
  for (const std::string& text : this->Integrals)
  {
    add(text.substr(0, text.find('=')));
  }
  return result;
}

void IntegralAnalysis::Run(const AnalysisRun& run) const
{
  const auto filters = MakeFilters(this->MomentDegree, this->Integrals);
  for (vtkSurfaceIntegralGPU* filter : filters)
  {
    if (filter->GetNumberOfIntegrands() == 0)
    {
      continue;
    }
    SetUpFilter(filter, run.Options);
    filter->SetRelativeTolerance(run.Options.Tolerance);
    filter->SetInputConnection(run.Reader->GetOutputPort());
    run.Update(filter);
    vtkDataSetAttributes* columns = vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetRowData();
    for (int i = 0; i < filter->GetNumberOfIntegrands(); ++i)
    {
      const std::string name = filter->GetIntegrandName(i);
      run.File.Analyses.Find<IntegralResult>()->Set(
        name, filter->GetIntegral(name), filter->GetIntegralBound(name));
      vtkIdType row = 0;
      for (SolidResult& solid : run.File.Solids)
      {
        solid.Analyses.Find<IntegralResult>()->Set(
          name, Component(columns, row, name), Component(columns, row, name + names::BoundSuffix));
        ++row;
      }
    }
    AddEffort(filter, run.File, run.Messages);
    if (filter == filters.back() && run.File.Total.FlippedShells > 0)
    {
      AddStatus(names::StatusSuspect, run.File);
      run.Messages.AddEcho("integrals of expressions take shells that are inside out as the file orients "
                           "them: correct the file");
    }
  }
}
}
