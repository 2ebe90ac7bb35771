#include "smGraphFigures.h"

#include "smPaperRun.h"
#include "smPaperSolid.h"

#include <smFormat.h>
#include <smUnitRoundoff.h>

#include <algorithm>
#include <cmath>

namespace smfigure
{
namespace
{
/// Errors of 0 are drawn as half an ulp of 1, because the axis is logarithmic.
constexpr double Rounding = sm::UnitRoundoff;
constexpr float LineWidth = 2.5f;

const Scheme PaperSchemes[3] = { Scheme::Midpoint, Scheme::Gauss2, Scheme::Gauss3 };

struct Study
{
  /// The reference volume of the errors.
  double Reference;
  PaperRun Adaptive;
  /// The runs, ordered by scheme, then by factor.
  std::vector<std::vector<PaperRun>> Runs;
};

Study MakeStudy(PaperFilter& filter, const std::vector<int>& factors)
{
  Study study;
  study.Adaptive = filter.RunAdaptive();
  study.Reference = study.Adaptive.Volume;
  for (const Scheme scheme : PaperSchemes)
  {
    study.Runs.emplace_back();
    for (const int factor : factors)
    {
      study.Runs.back().push_back(filter.RunScheme(scheme, factor));
    }
  }
  return study;
}

double GetError(const Study& study, const PaperRun& run)
{
  return std::abs(run.Volume / study.Reference - 1.0);
}

FigureTable MakeTable(const Study& study)
{
  FigureTable table;
  table.Columns = { "scheme", "k", "sub_patches", "volume", "normalised_volume", "relative_error", "bound",
    "estimate", "estimate_with_boundary" };
  const auto add = [&](const PaperRun& run)
  {
    const double scale = study.Reference;
    table.Rows.push_back({ GetName(run.Used), std::to_string(run.Factor), std::to_string(run.SubPatches),
      FormatNumber(run.Volume), FormatNumber(run.Volume / scale), FormatNumber(GetError(study, run)),
      FormatNumber(run.Bound / scale), FormatNumber(run.Estimate / scale),
      FormatNumber(run.EstimateWithBoundary / scale) });
  };
  add(study.Adaptive);
  for (const auto& runs : study.Runs)
  {
    std::for_each(runs.begin(), runs.end(), add);
  }
  return table;
}

Series MakeStyle(Scheme scheme)
{
  Series series;
  series.Label = GetName(scheme);
  series.LineWidth = LineWidth;
  // The order of drawing makes each one of several equal values visible.
  switch (scheme)
  {
    case Scheme::Midpoint:
      series.Hue = colors::Orange;
      series.Symbol = Marker::Circle;
      series.MarkerSize = 14.0f;
      break;
    case Scheme::Gauss2:
      series.Hue = colors::Blue;
      series.Symbol = Marker::Square;
      series.MarkerSize = 10.0f;
      break;
    case Scheme::Gauss3:
      series.Hue = colors::Green;
      series.Symbol = Marker::Diamond;
      series.MarkerSize = 7.0f;
      break;
    default:
      break;
  }
  return series;
}

/// Makes a series of a value of every run against its factor.
template <class Value>
Series MakeSeries(const std::vector<PaperRun>& runs, const Value& value)
{
  Series series = MakeStyle(runs.front().Used);
  for (const PaperRun& run : runs)
  {
    series.X.push_back(run.Factor);
    series.Y.push_back(value(run));
  }
  return series;
}

/// Makes a horizontal line for a value that does not depend on k.
Series MakeLevel(const std::string& label, double value, const std::vector<int>& factors, bool dashed)
{
  Series series;
  series.Label = label;
  series.X = { static_cast<double>(factors.front()), static_cast<double>(factors.back()) };
  series.Y = { value, value };
  series.LineWidth = LineWidth;
  series.Dashed = dashed;
  return series;
}

void SetFactorAxis(FigureAxis& axis, const std::string& title, const std::vector<int>& factors)
{
  axis.Title = title;
  axis.Log = true;
  axis.Grid = true;
  // The range leaves room for the outermost markers.
  axis.Minimum = factors.front() / 1.08;
  axis.Maximum = factors.back() * 1.08;
  for (int power = 1; power <= factors.back(); power *= 2)
  {
    axis.Ticks.emplace_back(power, std::to_string(power));
  }
}

/// Sets ticks at round numbers around the values and 1.
void SetVolumeAxis(Figure& figure)
{
  double low = 1.0;
  double high = 1.0;
  for (const Series& series : figure.Content)
  {
    low = std::min(low, *std::min_element(series.Y.begin(), series.Y.end()));
    high = std::max(high, *std::max_element(series.Y.begin(), series.Y.end()));
  }
  const double rough = (high - low) / 5.0;
  const double decade = std::pow(10.0, std::floor(std::log10(rough)));
  const double step = decade * (rough > 5.0 * decade ? 10.0 : rough > 2.0 * decade ? 5.0 : 2.0);
  const int first = static_cast<int>(std::floor((low - 1.0) / step - 0.25));
  const int last = static_cast<int>(std::ceil((high - 1.0) / step + 0.25));
  const int digits = std::max(0, static_cast<int>(-std::floor(std::log10(step))));
  for (int i = first; i <= last; ++i)
  {
    figure.Y.Ticks.emplace_back(1.0 + i * step, sm::FormatFixed(1.0 + i * step, digits));
  }
  figure.Y.Minimum = 1.0 + first * step;
  figure.Y.Maximum = 1.0 + last * step;
  figure.Y.Grid = true;
}

/// Sets ticks at the powers of ten around the values.
void SetErrorAxis(Figure& figure, const std::string& title)
{
  double low = 1.0;
  double high = Rounding;
  for (Series& series : figure.Content)
  {
    for (double& y : series.Y)
    {
      y = std::max(y, Rounding);
      low = std::min(low, y);
      high = std::max(high, y);
    }
  }
  const int first = static_cast<int>(std::floor(std::log10(low) - 0.3));
  const int last = static_cast<int>(std::ceil(std::log10(high)));
  figure.Y.Title = title;
  figure.Y.Log = true;
  figure.Y.Grid = true;
  figure.Y.Ticks = MakeDecadeTicks(first, last, 2);
  figure.Y.Minimum = std::pow(10.0, first);
  figure.Y.Maximum = std::pow(10.0, last);
}

Figure MakeVolumeFigure(const std::string& name, const Study& study, const std::vector<int>& factors,
  const std::string& xTitle, const std::string& yTitle)
{
  Figure figure;
  figure.Name = name;
  figure.Y.Title = yTitle;
  SetFactorAxis(figure.X, xTitle, factors);
  figure.Content.push_back(MakeLevel("ADAPTIVE", study.Adaptive.Volume / study.Reference, factors, false));
  // This line is wider, because the others are drawn on top of it.
  figure.Content.back().LineWidth = 1.8f * LineWidth;
  for (const auto& runs : study.Runs)
  {
    figure.Content.push_back(
      MakeSeries(runs, [&](const PaperRun& run) { return run.Volume / study.Reference; }));
  }
  SetVolumeAxis(figure);
  figure.LegendColumns = 4;
  figure.Table = MakeTable(study);
  return figure;
}

/// Makes a figure of the errors of the schemes.
Figure MakeErrorFigure(
  const std::string& name, const Study& study, const std::vector<int>& factors, const std::string& xTitle)
{
  Figure figure;
  figure.Name = name;
  SetFactorAxis(figure.X, xTitle, factors);
  for (const auto& runs : study.Runs)
  {
    figure.Content.push_back(MakeSeries(runs, [&](const PaperRun& run) { return GetError(study, run); }));
  }
  figure.Table = MakeTable(study);
  return figure;
}

/// Adds the estimate of GAUSS2, as in the paper; the estimates of the other rules are nearly equal. A value
/// of 0, if no sub-patch lies entirely in its face, has no logarithm and is left out.
void AddEstimate(Figure& errors, const Study& study, const char* label, double PaperRun::*estimate)
{
  Series series = MakeStyle(study.Runs[1].front().Used);
  for (const PaperRun& run : study.Runs[1])
  {
    if (run.*estimate > 0.0)
    {
      series.X.push_back(run.Factor);
      series.Y.push_back(run.*estimate / study.Reference);
    }
  }
  series.Label = label;
  series.Hue = colors::Vermillion;
  series.Symbol = Marker::None;
  errors.Content.push_back(series);
}

/// Adds the paper's estimate over the sub-patches that lie entirely in their faces, which is how the paper
/// reads, and that over all sub-patches.
void AddBothEstimates(Figure& errors, const Study& study)
{
  AddEstimate(errors, study, "Eq. 36, whole", &PaperRun::Estimate);
  errors.Content.back().Dashed = true;
  AddEstimate(errors, study, "Eq. 36, all", &PaperRun::EstimateWithBoundary);
}

/// Makes a figure of the errors of the schemes and of ADAPTIVE, for a known exact volume.
Figure MakeExactErrorFigure(
  const std::string& name, const Study& study, const std::vector<int>& factors, const std::string& xTitle)
{
  Figure figure = MakeErrorFigure(name, study, factors, xTitle);
  figure.Content.push_back(MakeLevel("ADAPTIVE", GetError(study, study.Adaptive), factors, false));
  figure.LegendColumns = 3;
  return figure;
}

const char* const KTitle = "sub-patch factor k (every knot interval is divided into k x k)";
const char* const ErrorTitle = "relative error of the volume";
}

std::vector<Figure> MakeFigure7a()
{
  const std::vector<int> factors = { 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64 };
  const PaperSolid solid = MakeQuarterCylinder();
  PaperFilter filter(solid.DataSet);
  Study study = MakeStudy(filter, factors);
  study.Reference = solid.Volume;
  const std::string xTitle = "sub-patches along the arc";
  std::vector<Figure> figures;
  figures.push_back(MakeVolumeFigure("fig7a", study, factors, xTitle, "volume / exact volume"));
  figures.push_back(MakeExactErrorFigure("fig7a_error", study, factors, xTitle));
  // Without trimmed faces both estimates are equal.
  AddEstimate(figures.back(), study, "paper's estimate", &PaperRun::EstimateWithBoundary);
  SetErrorAxis(figures.back(), ErrorTitle);
  return figures;
}

std::vector<Figure> MakeFigure7b()
{
  const std::vector<int> factors = { 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128 };
  const PaperSolid solid = MakeSlantedBlock();
  PaperFilter filter(solid.DataSet);
  Study study = MakeStudy(filter, factors);
  study.Reference = solid.Volume;
  std::vector<Figure> figures;
  figures.push_back(MakeVolumeFigure("fig7b", study, factors, KTitle, "volume / exact volume"));
  figures.push_back(MakeExactErrorFigure("fig7b_error", study, factors, KTitle));
  Figure& errors = figures.back();
  AddBothEstimates(errors, study);
  errors.LegendColumns = 4;
  Series slope;
  slope.Label = "1 / k";
  slope.Hue = colors::Grey;
  slope.LineWidth = LineWidth;
  slope.Dashed = true;
  for (const int factor : factors)
  {
    slope.X.push_back(factor);
    slope.Y.push_back(GetError(study, study.Runs[2].front()) / factor);
  }
  errors.Content.push_back(slope);
  SetErrorAxis(errors, ErrorTitle);
  return figures;
}

std::vector<Figure> MakeFigure8(vtkDataObject* part)
{
  const std::vector<int> factors = { 1, 2, 3, 4, 6, 8, 12, 16, 24, 32 };
  PaperFilter filter(part);
  const Study study = MakeStudy(filter, factors);
  std::vector<Figure> figures;
  if (!std::isfinite(study.Reference))
  {
    return figures;
  }
  figures.push_back(MakeVolumeFigure("fig8", study, factors, KTitle, "volume / volume by ADAPTIVE"));
  figures.push_back(MakeErrorFigure("fig8_error", study, factors, KTitle));
  Figure& errors = figures.back();
  AddBothEstimates(errors, study);
  errors.Content.push_back(
    MakeLevel("bound of ADAPTIVE", study.Adaptive.Bound / study.Reference, factors, true));
  errors.LegendColumns = 3;
  SetErrorAxis(errors, ErrorTitle);
  return figures;
}
}
