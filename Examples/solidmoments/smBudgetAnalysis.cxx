#include "smBudgetAnalysis.h"

#include "smExtras.h"
#include "smFileJob.h"
#include "smFormat.h"
#include "smMessageList.h"
#include "smOptions.h"
#include "smQuantities.h"
#include "smReportRows.h"
#include "smResults.h"
#include "smText.h"
#include "smToleranceAnalysis.h"

#include <cmath>
#include <memory>
#include <utility>

namespace sm
{
namespace
{
/// Relative excess of a sum over its rounding.
constexpr double BudgetExcess = 1.0 + 1e-12;
}

std::string FormatBudgetMass(double mass)
{
  return std::isfinite(mass) ? ShortBound(mass) + " kg" : "not known";
}

std::string FormatBudgetSum(const BudgetResult& budget)
{
  BudgetResult known;
  std::string unknown;
  for (const BudgetLine& line : budget.Lines)
  {
    if (std::isfinite(line.Mass))
    {
      known.Lines.push_back(line);
    }
    else
    {
      unknown += (unknown.empty() ? "" : ", ") + line.Name;
    }
  }
  known.Sum();
  return unknown.empty()
    ? FormatBudgetMass(budget.Mass)
    : "not known, as is " + unknown + "; the other lines " + FormatBudgetMass(known.Mass);
}

BudgetResult MakeBudget(const Quantities& body, const AnalysisResults& analyses)
{
  BudgetResult budget;
  const auto& [sum, density, gaps, numerical, overridden, tolerance] = body.MassUncertainty;
  budget.Lines = { { "numerical", numerical }, { "closing", gaps }, { "density", density } };
  if (body.OverriddenMass > 0.0)
  {
    budget.Lines.push_back({ "overridden masses", overridden });
  }
  if (analyses.Find<ToleranceResult>())
  {
    budget.Lines.push_back({ "tolerance", tolerance });
  }
  budget.Sum();
  return budget;
}

void BudgetResult::Sum()
{
  this->Mass = 0.0;
  for (const BudgetLine& line : this->Lines)
  {
    this->Mass += BudgetExcess * line.Mass;
  }
}

void BudgetResult::Visit(Fields& fields, const char* key)
{
  fields.Note("", "with `--budget`: the mass in doubt as the sum of its lines").Begin(key);
  fields.Note("kg", "sum of the lines").Number("mass", this->Mass);
  fields
    .Note("",
      "`numerical`, `closing`, `density`, where materials state masses `overridden masses`, and with "
      "tolerances of faces `tolerance`")
    .List("lines", this->Lines,
      [&fields](BudgetLine& line)
      {
        fields.Note("", "").Text("name", line.Name);
        fields.Note("kg", "how far the mass may be off for this reason").Number("mass", line.Mass);
      });
  fields.End();
}

std::string BudgetResult::FormatRows(const std::string&) const
{
  std::string text = Row("mass in doubt",
    FormatBudgetSum(*this) + (std::isfinite(this->Mass) ? ", which is the sum of" : " in all"), "");
  for (const BudgetLine& line : this->Lines)
  {
    text += Row("  " + line.Name, FormatBudgetMass(line.Mass), "");
  }
  return text;
}

void BudgetAnalysis::Declare(CLI::App& app)
{
  app.option_defaults()->group("Analyses");
  app
    .add_option("--budget", this->PictureName,
      "The mass in doubt as the sum of named lines (numerical, closing, density,\n"
      "overridden masses, and with --face-tolerance or --tolerances those of the\n"
      "faces), in the table, in JSON, and as bars in a picture, of one file with\n"
      "densities")
    ->type_name("FILE.png")
    ->expected(1);
}

std::string BudgetAnalysis::FindProblem(const CLI::App& app) const
{
  if (app.count("--budget") == 0)
  {
    return {};
  }
  const std::string& name = this->PictureName;
  if (name.size() < 5 || name.compare(name.size() - 4, 4, ".png") != 0)
  {
    return "--budget writes PNG files only: the name must end in .png, and " + name + " does not";
  }
  return app.count("FILE") > 1 ? "--budget is for one file; give one at a time" : "";
}

void BudgetAnalysis::Run(const AnalysisRun& run) const
{
  for (SolidResult& solid : run.File.Solids)
  {
    solid.Analyses.Set(run.Index, std::make_unique<BudgetResult>(MakeBudget(solid, solid.Analyses)));
  }
  auto result = std::make_unique<BudgetResult>(MakeBudget(run.File.Total, run.File.Total.Analyses));
  const BudgetResult total = *result;
  run.File.Total.Analyses.Set(run.Index, std::move(result));
  const std::string problem = run.File.Total.Mass.IsKnown()
    ? CallExtra(&ExtraFunctions::WriteBudget, total, run.Options, this->PictureName)
    : "the mass is not known, for there is no density; --density gives one";
  run.ReportOutput(problem);
}
}
