/**
 * @file smIntegralAnalysis.h
 * @brief Further integrals: moments and expressions of the user
 */
#ifndef smIntegralAnalysis_h
#define smIntegralAnalysis_h

#include "smAnalysis.h"

namespace sm
{
class IntegralResult : public AnalysisResultOf<IntegralResult>
{
public:
  struct Entry
  {
    std::string Name;
    ScalarQuantity Value;
  };
  std::vector<Entry> Entries;

  void Set(const std::string& name, double value, double bound);
  void Visit(Fields& fields, const char* key) override;
  void AddColumns(Columns& columns) const override;
  std::string FormatRows(const std::string& unit) const override;
};

/// Computes integrals of the file and of each solid: {NAME: {"value", "bound"}}.
class IntegralAnalysis : public Analysis
{
public:
  const char* GetKey() const override { return "integrals"; }
  bool RunsLast() const override { return true; } // a shader compiler may crash on an expression
  void Declare(CLI::App& app) override;
  std::string FindProblem(const CLI::App& app) const override;
  bool IsWanted() const override { return this->MomentDegree >= 0 || !this->Integrals.empty(); }
  std::unique_ptr<AnalysisResult> MakeResult() const override;
  void Run(const AnalysisRun& run) const override;

private:
  int MomentDegree = -1;              ///< volume moments up to this degree; negative: none
  std::vector<std::string> Integrals; ///< expressions, "NAME=EXPR"
};
}

#endif
