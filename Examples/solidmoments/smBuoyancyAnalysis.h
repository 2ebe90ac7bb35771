/**
 * @file smBuoyancyAnalysis.h
 * @brief Volume and centre below waterlines
 */
#ifndef smBuoyancyAnalysis_h
#define smBuoyancyAnalysis_h

#include "smAnalysis.h"

#include <array>

namespace sm
{
struct WaterlineEntry
{
  double Height = 0.0;
  ScalarQuantity Volume;
  VectorQuantity Center;
};

class WaterlineResult : public AnalysisResultOf<WaterlineResult>
{
public:
  std::array<double, 3> Up{};
  std::vector<WaterlineEntry> Waterlines;

  void Visit(Fields& fields, const char* key) override;
  void AddColumns(Columns& columns) const override;
  std::string FormatRows(const std::string& unit) const override;
};

class BuoyancyAnalysis : public Analysis
{
public:
  const char* GetKey() const override { return "waterlines"; }
  const char* GetStage() const override { return "buoyancy"; }
  const char* GetOption() const override { return "--waterline"; }
  void Declare(CLI::App& app) override;
  std::string FindProblem(const CLI::App& app) const override;
  const char* GetMissingModule() const override;
  bool IsWanted() const override { return !this->Waterlines.empty(); }
  std::unique_ptr<AnalysisResult> MakeResult() const override;
  void Run(const AnalysisRun& run) const override;
  const std::vector<double>& GetWaterlines() const { return this->Waterlines; }
  const std::array<double, 3>& GetUp() const { return this->Up; }

private:
  /// Heights of waterlines along Up, in the unit of the results; Up is not 0.
  std::vector<double> Waterlines;
  std::array<double, 3> Up{ 0.0, 0.0, 1.0 };
};
}

#endif
