/**
 * @file smStabilityAnalysis.h
 * @brief Static stability of the part under gravity in a direction
 */
#ifndef smStabilityAnalysis_h
#define smStabilityAnalysis_h

#include "smAnalysis.h"

namespace sm
{
/// A side of the support polygon.
struct StabilitySide
{
  std::array<double, 3> From{}, To{};
  double Margin = Unknown, TipAngle = Unknown, Rise = Unknown;
};

class StabilityResult : public AnalysisResultOf<StabilityResult>
{
public:
  std::string Verdict, Support, DecidedBy;
  ScalarQuantity Margin, TipAngle, Rise, CenterHeight, RollingMargin;
  double TipEnergy = Unknown, RollingRadius = Unknown;
  VectorQuantity ProjectedCenter;
  long long ContactFaces = -1, ContactEdges = -1;
  std::vector<StabilitySide> Sides;

  void Visit(Fields& fields, const char* key) override;
  std::string FormatRows(const std::string& unit) const override;
};

/// Results of the total (all solids as one body that rests on its lowest points) and of every solid alone.
class StabilityAnalysis : public Analysis
{
public:
  const char* GetKey() const override { return "stability"; }
  const char* GetOption() const override { return "--stability"; }
  bool IsOfBodies() const override { return true; }
  void Declare(CLI::App& app) override;
  const char* GetMissingModule() const override;
  bool IsWanted() const override { return !this->Direction.empty(); }
  std::unique_ptr<AnalysisResult> MakeResult() const override { return std::make_unique<StabilityResult>(); }
  void Run(const AnalysisRun& run) const override;

private:
  std::string Direction; ///< of gravity, see ParseDirection(); empty: no stability
};
}

#endif
