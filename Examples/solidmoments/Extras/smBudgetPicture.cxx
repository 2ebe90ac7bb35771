#include "smBudgetPicture.h"

#include "smBodyScene.h"
#include "smFilterSetUp.h"

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
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <cmath>

namespace sm
{
namespace
{
constexpr int BudgetWidth = 800;
constexpr int BudgetHeight = 500;

/// Returns bars for the lines, in kg, one plot of bars with the lines in their order.
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
    names->InsertNextValue(budget.Lines[i].Name + "\n" + FormatBudgetMass(budget.Lines[i].Mass));
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
  chart->SetTitle("Mass in doubt: " + FormatBudgetSum(budget));
  chart->GetTitleProperties()->SetFontSize(20);
  return chart;
}
}

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
