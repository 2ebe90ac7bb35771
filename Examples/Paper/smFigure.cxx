#include "smFigure.h"

#include "smBodyScene.h"
#include "smFigureText.h"

#include <smFormat.h>
#include <smSafeFile.h>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkContextView.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSVGExporter.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace smfigure
{
namespace
{
/// The PNG is drawn larger by this factor and averaged, which smooths letters and markers on every driver.
constexpr int Oversampling = 3;

/// One axis of the plot as pixels of the window. The charts get pixels as their data, so that their transform
/// is the identity: vtkSVGExporter applies a transform to clip paths, line widths and markers as well.
class PixelScale
{
public:
  PixelScale(const FigureAxis& axis, float start, float length)
    : Log(axis.Log)
    , Start(start)
    , Low(this->Linear(axis.Minimum))
    , PixelsPerUnit(length / (this->Linear(axis.Maximum) - this->Low))
  {
  }
  double ToPixel(double value) const
  {
    return this->Start + (this->Linear(value) - this->Low) * this->PixelsPerUnit;
  }

private:
  double Linear(double value) const { return this->Log ? std::log10(value) : value; }

  bool Log;
  double Start;
  double Low;
  double PixelsPerUnit;
};

struct PlotScale
{
  float Factor;
  PixelScale X;
  PixelScale Y;

  PlotScale(const Figure& figure, float factor)
    : PlotScale(figure, figure.GetPlot(), factor)
  {
  }

private:
  PlotScale(const Figure& figure, const std::array<float, 4>& plot, float factor)
    : Factor(factor)
    , X(figure.X, factor * plot[0], factor * plot[2])
    , Y(figure.Y, factor * plot[1], factor * plot[3])
  {
  }
};

int GetMarkerStyle(Marker marker)
{
  switch (marker)
  {
    case Marker::Circle:
      return vtkPlotPoints::CIRCLE;
    case Marker::Square:
      return vtkPlotPoints::SQUARE;
    case Marker::Diamond:
      return vtkPlotPoints::DIAMOND;
    case Marker::Plus:
      return vtkPlotPoints::PLUS;
    case Marker::Cross:
      return vtkPlotPoints::CROSS;
    default:
      return vtkPlotPoints::NONE;
  }
}

void AddSeries(vtkChartXY* chart, const Series& series, const PlotScale& scale)
{
  vtkNew<vtkTable> table;
  vtkNew<vtkDoubleArray> x;
  x->SetName("x");
  vtkNew<vtkDoubleArray> y;
  y->SetName("y");
  for (std::size_t i = 0; i < series.X.size(); ++i)
  {
    x->InsertNextValue(scale.X.ToPixel(series.X[i]));
    y->InsertNextValue(scale.Y.ToPixel(series.Y[i]));
  }
  table->AddColumn(x);
  table->AddColumn(y);
  const bool line = series.LineWidth > 0.0f;
  auto* plot = vtkPlotPoints::SafeDownCast(chart->AddPlot(line ? vtkChart::LINE : vtkChart::POINTS));
  plot->SetInputData(table, 0, 1);
  plot->SetLabel(series.Label);
  // A series without a label has no entry of its own in the legend.
  plot->SetLegendVisibility(!series.Label.empty());
  plot->SetColor(series.Hue[0], series.Hue[1], series.Hue[2], 255);
  plot->SetWidth(scale.Factor * (line ? series.LineWidth : 2.0f));
  plot->GetPen()->SetLineType(series.Dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
  plot->SetMarkerStyle(GetMarkerStyle(series.Symbol));
  plot->SetMarkerSize(scale.Factor * series.MarkerSize);
}

void SetTicks(vtkAxis* axis, const FigureAxis& source,
  const std::vector<std::pair<double, std::string>>& ticks, const PixelScale& pixels, float scale)
{
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const auto& tick : ticks)
  {
    positions->InsertNextValue(pixels.ToPixel(tick.first));
    labels->InsertNextValue(tick.second);
  }
  axis->SetTitle("");
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(pixels.ToPixel(source.Minimum), pixels.ToPixel(source.Maximum));
  axis->SetCustomTickPositions(positions, labels);
  axis->SetTickLength(5.0f * scale);
  axis->SetLabelOffset(8.0f * scale);
  axis->GetLabelProperties()->SetFontSize(static_cast<int>(LabelSize * scale));
  axis->GetLabelProperties()->SetColor(0.0, 0.0, 0.0);
  axis->GetPen()->SetColor(60, 60, 60);
  axis->GetPen()->SetWidth(1.3f * scale);
}

void SetAxis(
  vtkChartXY* chart, int near, int far, const FigureAxis& source, const PixelScale& pixels, float scale)
{
  vtkAxis* axis = chart->GetAxis(near);
  SetTicks(axis, source, source.Ticks, pixels, scale);
  axis->SetGridVisible(source.Grid);
  axis->GetGridPen()->SetColor(source.GridGrey, source.GridGrey, source.GridGrey);
  axis->GetGridPen()->SetWidth(scale);
  // The opposite axis closes the frame.
  vtkAxis* opposite = chart->GetAxis(far);
  SetTicks(opposite, source, source.OppositeTicks, pixels, scale);
  opposite->SetVisible(true);
  opposite->SetGridVisible(false);
  opposite->SetTicksVisible(false);
}

void BuildChart(vtkChartXY* chart, const Figure& figure, float scale)
{
  chart->SetAutoSize(false);
  chart->SetAutoAxes(false);
  chart->SetShowLegend(false);
  chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  const std::array<float, 4> plot = figure.GetPlot();
  chart->SetSize(vtkRectf(scale * plot[0], scale * plot[1], scale * plot[2], scale * plot[3]));
  const PlotScale pixels(figure, scale);
  SetAxis(chart, vtkAxis::BOTTOM, vtkAxis::TOP, figure.X, pixels.X, scale);
  SetAxis(chart, vtkAxis::LEFT, vtkAxis::RIGHT, figure.Y, pixels.Y, scale);
  for (const Series& series : figure.Content)
  {
    AddSeries(chart, series, pixels);
  }
}

/// Shows a figure in `window` from construction to destruction.
class Drawing
{
public:
  Drawing(const Figure& figure, vtkRenderWindow* window, int scale)
    : Window(window)
  {
    this->View->SetRenderWindow(window);
    this->View->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
    window->SetMultiSamples(0);
    window->SetSize(scale * figure.Width, scale * figure.Height);
    BuildChart(this->Chart, figure, static_cast<float>(scale));
    this->Text->Set(this->Chart, figure, static_cast<float>(scale));
    this->View->GetScene()->AddItem(this->Chart);
    this->View->GetScene()->AddItem(this->Text);
    window->Render();
  }
  ~Drawing() { this->Window->RemoveRenderer(this->View->GetRenderer()); }
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

private:
  vtkRenderWindow* Window;
  vtkNew<vtkContextView> View;
  vtkNew<vtkChartXY> Chart;
  vtkNew<FigureText> Text;
};

std::string WritePng(const Figure& figure, const std::string& path, vtkRenderWindow* window)
{
  const Drawing drawing(figure, window, Oversampling);
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> average;
  average->SetInputConnection(grab->GetOutputPort());
  average->SetShrinkFactors(Oversampling, Oversampling, 1);
  average->AveragingOn();
  average->Update();
  return sm::WriteImage(average->GetOutput(), path);
}

std::string WriteSvg(const Figure& figure, const std::string& path, vtkRenderWindow* window)
{
  const Drawing drawing(figure, window, 1);
  vtkNew<vtkSVGExporter> svg;
  svg->SetTitle(figure.Name.c_str());
  svg->SetRenderWindow(window);
  // The exporter reports no error and writes to files only.
  const std::string own = path + ".exported";
  svg->SetFileName(own.c_str());
  svg->Write();
  std::ostringstream text;
  text << std::ifstream(own, std::ios::binary).rdbuf();
  std::remove(own.c_str());
  const std::string problem = text.str().empty() ? "nothing was exported" : sm::SaveFile(path, text.str());
  return problem.empty() ? "" : path + " could not be written: " + problem;
}
}

std::string FormatNumber(double value)
{
  return sm::FormatDigits(value, 17);
}

std::vector<std::pair<double, std::string>> MakeDecadeTicks(int low, int high, int step)
{
  std::vector<std::pair<double, std::string>> ticks;
  for (int power = high; power >= low; power -= step)
  {
    ticks.emplace_back(std::pow(10.0, power), power == 0 ? "1" : "1e" + std::to_string(power));
  }
  return ticks;
}

std::string WriteTable(const FigureTable& table, const std::string& path)
{
  std::ostringstream file;
  const auto writeRow = [&file](const std::vector<std::string>& row)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      file << (i ? "," : "") << row[i];
    }
    file << "\n";
  };
  writeRow(table.Columns);
  for (const auto& row : table.Rows)
  {
    writeRow(row);
  }
  const std::string problem = sm::SaveFile(path, file.str());
  return problem.empty() ? "" : path + " could not be written: " + problem;
}

std::string WriteFigure(const Figure& figure, const std::string& folder, vtkRenderWindow* window)
{
  const std::string path = folder + "/" + figure.Name;
  std::string error = WritePng(figure, path + ".png", window);
  error = error.empty() ? WriteSvg(figure, path + ".svg", window) : error;
  return error.empty() ? WriteTable(figure.Table, path + ".csv") : error;
}
}
