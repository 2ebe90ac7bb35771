/**
 * @file smBudgetAnalysis.h
 * @brief The mass in doubt as the sum of named lines, as numbers and as bars
 */
#ifndef smBudgetAnalysis_h
#define smBudgetAnalysis_h

#include "smAnalysis.h"

#include <string>
#include <vector>

namespace sm
{
struct Quantities;

/// A share of the mass in doubt in kg: how far the mass may be off for one reason.
struct BudgetLine
{
  std::string Name;
  double Mass = Unknown;
};

class BudgetResult : public AnalysisResultOf<BudgetResult>
{
public:
  /// Sets Mass to the sum of the lines.
  void Sum();

  /// The sum of the lines; not known if one of them is not.
  double Mass = Unknown;
  std::vector<BudgetLine> Lines;

  void Visit(Fields& fields, const char* key) override;
  std::string FormatRows(const std::string& unit) const override;
};

/// Returns the budget of a body: numerical, closing, density; overridden masses, if materials state some; and
/// tolerance, if its faces have tolerances.
BudgetResult MakeBudget(const Quantities& body, const AnalysisResults& analyses);

/// Returns a mass in kg, or that it is not known.
std::string FormatBudgetMass(double mass);
/// Returns the sum of the lines; where some are not known, which, and the sum of the others.
std::string FormatBudgetSum(const BudgetResult& budget);

class BudgetAnalysis : public Analysis
{
public:
  const char* GetKey() const override { return "budget"; }
  const char* GetOption() const override { return "--budget"; }
  bool IsOfBodies() const override { return true; }
  /// After all that it sums up; drawing may crash a driver.
  bool RunsLast() const override { return true; }
  void Declare(CLI::App& app) override;
  std::string FindProblem(const CLI::App& app) const override;
  bool IsWanted() const override { return !this->PictureName.empty(); }
  std::string GetOutputFile() const override { return this->PictureName; }
  std::unique_ptr<AnalysisResult> MakeResult() const override { return std::make_unique<BudgetResult>(); }
  void Run(const AnalysisRun& run) const override;

private:
  std::string PictureName;
};
}

#endif
