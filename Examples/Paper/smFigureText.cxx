#include "smFigureText.h"

#include <vtkBrush.h>
#include <vtkChart.h>
#include <vtkContext2D.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkPlotPoints.h>
#include <vtkTextProperty.h>

namespace smfigure
{
namespace
{
constexpr float RowHeight = 25.0f;
constexpr float SymbolWidth = 36.0f;
/// Distance from the plot to the middle of a title.
constexpr float TitleBelow = 47.0f;

/// Paints the symbol of the legend as in the plot; the marker of vtkPlot's own symbol has a fixed size.
void PaintSymbol(vtkContext2D* painter, vtkPlotPoints* plot, float x, float y, float width)
{
  if (vtkPlotLine::SafeDownCast(plot))
  {
    painter->ApplyPen(plot->GetPen());
    painter->DrawLine(x, y, x + width, y);
  }
  if (plot->GetMarkerStyle() != vtkPlotPoints::NONE)
  {
    painter->ApplyPen(plot->GetPen());
    painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
    painter->GetPen()->SetWidth(plot->GetMarkerSize());
    painter->ApplyBrush(plot->GetBrush());
    painter->GetBrush()->SetColor(plot->GetPen()->GetColorObject());
    float middle[2] = { x + 0.5f * width, y };
    painter->DrawMarkers(plot->GetMarkerStyle(), false, middle, 1);
  }
}
}

vtkStandardNewMacro(FigureText);

void FigureText::Set(vtkChart* chart, const Figure& figure, float scale)
{
  this->Chart = chart;
  this->Scale = scale;
  this->Columns = figure.LegendColumns;
  this->TitleLeft = scale * figure.TitleLeft;
  this->Titles[0] = figure.X.Title;
  this->Titles[1] = figure.Y.Title;
  // The legend is above the labels of an opposite axis.
  this->Gap = scale * (figure.X.OppositeTicks.empty() ? 8.0f : 40.0f);
  for (int i = 0; i < 4; ++i)
  {
    this->Plot[i] = scale * figure.GetPlot()[i];
  }
}

bool FigureText::Paint(vtkContext2D* painter)
{
  vtkTextProperty* text = painter->GetTextProp();
  text->SetColor(0.0, 0.0, 0.0);
  text->SetVerticalJustificationToCentered();
  this->PaintTitles(painter);
  text->SetOrientation(0.0);
  this->PaintLegend(painter);
  return true;
}

void FigureText::PaintTitles(vtkContext2D* painter) const
{
  vtkTextProperty* text = painter->GetTextProp();
  text->SetFontSize(static_cast<int>(TitleSize * this->Scale));
  text->SetJustificationToCentered();
  text->SetOrientation(0.0);
  painter->DrawString(this->Plot[0] + 0.5f * this->Plot[2], this->Plot[1] - TitleBelow * this->Scale,
    vtkStdString(this->Titles[0]));
  text->SetOrientation(90.0);
  painter->DrawString(
    this->Plot[0] - this->TitleLeft, this->Plot[1] + 0.5f * this->Plot[3], vtkStdString(this->Titles[1]));
}

void FigureText::PaintLegend(vtkContext2D* painter) const
{
  if (!this->Chart || this->Columns < 1)
  {
    return;
  }
  std::vector<vtkPlotPoints*> plots;
  for (vtkIdType i = 0; i < this->Chart->GetNumberOfPlots(); ++i)
  {
    auto* plot = vtkPlotPoints::SafeDownCast(this->Chart->GetPlot(i));
    if (plot && plot->GetLegendVisibility())
    {
      plots.push_back(plot);
    }
  }
  painter->GetTextProp()->SetFontSize(static_cast<int>(LabelSize * this->Scale));
  painter->GetTextProp()->SetJustificationToLeft();
  const int count = static_cast<int>(plots.size());
  const int rows = (count + this->Columns - 1) / this->Columns;
  const float height = RowHeight * this->Scale;
  const float width = SymbolWidth * this->Scale;
  for (int i = 0; i < count; ++i)
  {
    const float x = this->Plot[0] + this->Plot[2] / this->Columns * (i % this->Columns);
    const float y = this->Plot[1] + this->Plot[3] + this->Gap + height * (rows - 1 - i / this->Columns);
    PaintSymbol(painter, plots[i], x, y + 0.5f * height, width);
    painter->DrawString(x + 1.2f * width, y + 0.5f * height, plots[i]->GetLabel());
  }
}
}
