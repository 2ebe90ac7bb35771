/**
 * @file smCompactnessAnalysis.h
 * @brief An analysis to start from: how compact a solid is, 36 pi V^2 / A^3, 1 for a ball and less for any
 * other solid
 *
 * It is not registered in the program; a test adds it to the list. The page "Add an analysis" of the
 * developer guide explains it.
 */
#ifndef smCompactnessAnalysis_h
#define smCompactnessAnalysis_h

#include "smAnalysis.h"
#include "smColumns.h"
#include "smOptions.h"
#include "smReportRows.h"
#include "smResults.h"

// [result]
/// The result for all solids together, or for one of them.
class CompactnessResult : public sm::AnalysisResultOf<CompactnessResult>
{
public:
  sm::ScalarQuantity Compactness;

  /// The keys in JSON, which are also what goes through the pipe between the two processes of the program.
  void Visit(sm::Fields& fields, const char* key) override
  {
    fields.Begin(key);
    fields.Number("value", this->Compactness);
    fields.Number("bound", this->Compactness.Bound);
    fields.End();
  }

  /// The columns of the CSV, which --print and --fields know, too.
  void AddColumns(sm::Columns& columns) const override
  {
    columns.Add("compactness", this->Compactness.Get());
    columns.Add("compactness_bound", this->Compactness.Bound);
  }

  /// The rows of the table.
  std::string FormatRows(const std::string&) const override
  {
    return sm::MeasuredRow("compactness", this->Compactness, "");
  }
};
// [result]

// [analysis]
class CompactnessAnalysis : public sm::Analysis
{
public:
  /// The key in JSON; the stage, which progress and messages about a crash name, has the same name.
  const char* GetKey() const override { return "compactness"; }

  /// The options with their help.
  void Declare(CLI::App& app) override
  {
    app.option_defaults()->group("Shape");
    app.add_flag("--compactness", this->Wanted, "How compact the solids are, 36 pi V^2 / A^3: 1 for a ball");
  }

  bool IsWanted() const override { return this->Wanted; }

  /// The result of which nothing is known, which also a file that cannot be read has.
  std::unique_ptr<sm::AnalysisResult> MakeResult() const override
  {
    return std::make_unique<CompactnessResult>();
  }

  /// Computes it for the file and for each solid. An analysis that needs a filter runs it by run.Update().
  void Run(const sm::AnalysisRun& run) const override
  {
    Compute(run.File.Total, *run.File.Analyses.Find<CompactnessResult>());
    for (sm::SolidResult& solid : run.File.Solids)
    {
      Compute(solid, *solid.Analyses.Find<CompactnessResult>());
    }
  }

private:
  /// The bound holds for every volume and area within their bounds: the quotient grows with the volume and
  /// falls with the area. 10 operations round by 2^-53 each. Without a bound of the volume or the area there
  /// is none, as for an area that may be 0.
  static void Compute(const sm::Quantities& body, CompactnessResult& result)
  {
    const auto evaluate = [](double volume, double area)
    { return 36.0 * 3.14159265358979323846 * volume * volume / (area * area * area); };
    const sm::ScalarQuantity& volume = body.Volume;
    const sm::ScalarQuantity& area = body.Area;
    const double value = evaluate(volume.Get(), area.Get());
    const double maximum = evaluate(volume.Get() + volume.Bound, area.Get() - area.Bound);
    const double minimum = evaluate(std::max(volume.Get() - volume.Bound, 0.0), area.Get() + area.Bound);
    result.Compactness.Value = { value };
    result.Compactness.Bound = area.Get() > area.Bound ? maximum - minimum + 4e-15 * maximum : sm::Unknown;
  }

  bool Wanted = false;
};
// [analysis]

#endif
