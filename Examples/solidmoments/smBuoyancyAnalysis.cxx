#include "smBuoyancyAnalysis.h"

#include "smColumns.h"
#include "smOptionValues.h"
#include "smOptions.h"
#include "smReportRows.h"
#include "smTableText.h"

#include <cmath>

namespace sm
{
namespace
{
std::string CheckHeight(const std::string& text)
{
  return std::isfinite(ParseNumber(text)) ? "" : "the height of a waterline must be a finite number";
}
}

void WaterlineResult::Visit(Fields& fields, const char* key)
{
  fields.Note("", "with `--waterline`")
    .List(key, this->Waterlines,
      [&](WaterlineEntry& waterline)
      {
        fields.Note("L", "").Number("height", waterline.Height);
        fields.Note("1", "").Point("up", this->Up);
        fields.Note("L^3", "below the waterline").Number("volume", waterline.Volume);
        fields.Note("L", "centre of buoyancy").Point("center", waterline.Center.Value);
        fields.Note("", "of the quantities with the same names").Begin("bounds");
        fields.Number("volume", waterline.Volume.Bound);
        fields.Number("center", waterline.Center.Bound);
        fields.End();
      });
}

void WaterlineResult::AddColumns(Columns& columns) const
{
  for (std::size_t i = 0; i < this->Waterlines.size(); ++i)
  {
    const WaterlineEntry& waterline = this->Waterlines[i];
    const std::string stem = "waterline" + std::to_string(i + 1);
    columns.Note("of the first waterline, `waterline2_height` and so on of the next");
    columns.Add(stem + "_height", waterline.Height);
    columns.Add(stem + "_volume", waterline.Volume.Get());
    columns.Add(stem + "_volume_bound", waterline.Volume.Bound);
    columns.AddPoint(stem + "_center", waterline.Center.Value);
    columns.Add(stem + "_center_bound", waterline.Center.Bound);
  }
}

std::string WaterlineResult::FormatRows(const std::string& unit) const
{
  std::string text;
  for (const WaterlineEntry& waterline : this->Waterlines)
  {
    text +=
      MeasuredRow("below " + Short(waterline.Height) + " " + unit, waterline.Volume, RaiseUnit(unit, 3));
    text += MeasuredRow("  its centre", waterline.Center, unit);
  }
  return text;
}

void BuoyancyAnalysis::Declare(CLI::App& app)
{
  app.option_defaults()->group("Buoyancy");
  AddRepeatedOption(app, "--waterline",
    "Volume below a waterline, and its centre, the centre of buoyancy: the\n"
    "plane at HEIGHT along --up from the origin, in the unit of the results;\n"
    "may be given several times",
    [this](const std::string& text) { this->Waterlines.push_back(ParseNumber(text)); })
    ->type_name("HEIGHT")
    ->check(CheckHeight);
  app
    .add_option_function<std::string>(
      "--up", [this](const std::string& text) { ParseDirection(text, this->Up); },
      "Upward normal of the waterlines, of any length (default 0,0,1)")
    ->type_name("X,Y,Z")
    ->check(CheckDirection);
}

std::string BuoyancyAnalysis::FindProblem(const CLI::App& app) const
{
  return app.count("--up") > 0 && !this->IsWanted() ? "--up is for --waterline: add a height" : "";
}

std::unique_ptr<AnalysisResult> BuoyancyAnalysis::MakeResult() const
{
  auto result = std::make_unique<WaterlineResult>();
  result->Up = this->Up;
  for (const double height : this->Waterlines)
  {
    result->Waterlines.push_back({ height, {}, {} });
  }
  return result;
}
}
