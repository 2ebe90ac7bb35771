#include "smBudgetAnalysis.h"

#include "smBodyScene.h"
#include "smFileJob.h"
#include "smFilterSetUp.h"
#include "smFormat.h"
#include "smMessageList.h"
#include "smOptions.h"
#include "smQuantities.h"
#include "smReportRows.h"
#include "smResults.h"
#include "smText.h"
#include "smToleranceAnalysis.h"

#include "vtkAxis.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMassPropertiesGPU.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlot.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <cmath>
#include <memory>
#include <utility>

namespace sm
{
namespace
{
constexpr int BudgetWidth = 800;
constexpr int BudgetHeight = 500;
/// Relative excess of a sum over its rounding.
constexpr double BudgetExcess = 1.0 + 1e-12;

std::string FormatMass(double mass)
{
  return std::isfinite(mass) ? ShortBound(mass) + " kg" : "not known";
}

/// Returns the sum of the lines; where some are not known, which, and the sum of the others.
std::string FormatSum(const BudgetResult& budget)
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
  return unknown.empty() ? FormatMass(budget.Mass)
                         : "not known, as is " + unknown + "; the other lines " + FormatMass(known.Mass);
}

/// Draws the bars into a PNG file. Returns an error message, empty when it is written.
std::string WriteBudget(const BudgetResult& budget, const JobOptions& options, const std::string& fileName)
{
  vtkNew<vtkMassPropertiesGPU> filter;
  SetUpFilter(filter, options);
  std::string error;
  vtkOpenGLRenderWindow* window = StartWindow(filter, error);
  if (!window)
  {
    return error;
  }
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(MakeBudgetChart(budget));
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  actor->GetScene()->SetRenderer(renderer);
  window->SetOffScreenRendering(1);
  window->SetSize(BudgetWidth, BudgetHeight);
  window->AddRenderer(renderer);
  window->Render();
  error = WriteImage(GrabImage(window), fileName);
  window->RemoveRenderer(renderer);
  return error;
}
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
    FormatSum(*this) + (std::isfinite(this->Mass) ? ", which is the sum of" : " in all"), "");
  for (const BudgetLine& line : this->Lines)
  {
    text += Row("  " + line.Name, FormatMass(line.Mass), "");
  }
  return text;
}

vtkSmartPointer<vtkChartXY> MakeBudgetChart(const BudgetResult& budget)
{
  auto chart = vtkSmartPointer<vtkChartXY>::New();
  vtkNew<vtkTable> table;
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkDoubleArray> masses;
  vtkNew<vtkStringArray> names;
  places->SetName("Place");
  masses->SetName("Mass in doubt, kg");
  for (std::size_t i = 0; i < budget.Lines.size(); ++i)
  {
    places->InsertNextValue(static_cast<double>(i));
    masses->InsertNextValue(std::isfinite(budget.Lines[i].Mass) ? budget.Lines[i].Mass : 0.0);
    names->InsertNextValue(budget.Lines[i].Name + "\n" + FormatMass(budget.Lines[i].Mass));
  }
  table->AddColumn(places);
  table->AddColumn(masses);
  vtkPlot* bars = chart->AddPlot(vtkChart::BAR);
  bars->SetInputData(table, 0, 1);
  bars->SetColor(60, 110, 180, 255);
  vtkAxis* bottom = chart->GetAxis(vtkAxis::BOTTOM);
  bottom->SetCustomTickPositions(places, names);
  bottom->SetBehavior(vtkAxis::FIXED);
  bottom->SetRange(-0.75, static_cast<double>(budget.Lines.size()) - 0.25);
  bottom->SetTitle("");
  bottom->SetGridVisible(false);
  chart->GetAxis(vtkAxis::LEFT)->SetTitle("kg");
  chart->GetAxis(vtkAxis::LEFT)->SetMinimumLimit(0.0);
  for (vtkAxis* axis : { bottom, chart->GetAxis(vtkAxis::LEFT) })
  {
    axis->GetLabelProperties()->SetFontSize(16);
    axis->GetTitleProperties()->SetFontSize(16);
  }
  chart->SetTitle("Mass in doubt: " + FormatSum(budget));
  chart->GetTitleProperties()->SetFontSize(20);
  return chart;
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
    ? WriteBudget(total, run.Options, this->PictureName)
    : "the mass is not known, for there is no density; --density gives one";
  run.ReportOutput(problem);
}
}
