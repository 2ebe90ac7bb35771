/**
 * @file smToleranceAnalysis.h
 * @brief What tolerances of faces leave open in the mass properties
 */
#ifndef smToleranceAnalysis_h
#define smToleranceAnalysis_h

#include "smAnalysis.h"

#include <string>
#include <vector>

namespace sm
{
/// A face with the range of its offsets, and what these add to the worst case of volume and mass.
struct ToleranceEntry
{
  std::string Solid;
  long long Face = -1;
  double Lower = Unknown, Upper = Unknown, Volume = Unknown, Mass = Unknown;
};

/// Of a quantity with two ends: worst case and standard deviation.
struct ToleranceRange
{
  double Minimum = Unknown, Maximum = Unknown, Deviation = Unknown;
};

/// A tolerance of the drawing in the file; limits are in the length unit of the results.
struct ListedTolerance
{
  long long Id = -1, Faces = -1;
  std::string Kind, Problem;
  double Lower = Unknown, Upper = Unknown;
};

class ToleranceResult : public AnalysisResultOf<ToleranceResult>
{
public:
  static constexpr std::size_t MaxFaces = 5;

  ToleranceRange Volume, Mass;
  double CenterReach = Unknown, InertiaReach = Unknown, PrincipalReach = Unknown;
  VectorQuantity CenterDeviation, PrincipalDeviation;
  TensorQuantity InertiaDeviation;
  /// At most five, those that add most to the worst case.
  std::vector<ToleranceEntry> Faces;
  /// All of the file, only in the total.
  std::vector<ListedTolerance> Drawing;

  void Visit(Fields& fields, const char* key) override;
  std::string FormatRows(const std::string& unit) const override;
};

/// A row of a table of tolerances.
struct ToleranceFileRule
{
  std::string Kind, Pattern;
  double Lower = 0.0, Upper = 0.0;
};

/// Reads a tolerance: a number, or the name of a file of CSV with lines KIND,PATTERN,TOLERANCE or
/// KIND,PATTERN,LOWER,UPPER. KIND is face, part or colour, or all without a PATTERN for what no other line
/// fits; lines that begin with # are skipped. Returns an error message; empty if all is well.
std::string ReadTolerances(
  const std::string& argument, std::vector<ToleranceFileRule>& rules, double& lower, double& upper);

/// Results of the total and of every solid.
class ToleranceAnalysis : public Analysis
{
public:
  const char* GetKey() const override { return "tolerance"; }
  const char* GetOption() const override { return "--face-tolerance"; }
  bool IsOfBodies() const override { return true; }
  void Declare(CLI::App& app) override;
  std::string FindProblem(const CLI::App& app) const override;
  bool IsWanted() const override { return !this->Tolerance.empty() || this->FromFile; }
  std::string GetInputFile() const override;
  std::unique_ptr<AnalysisResult> MakeResult() const override { return std::make_unique<ToleranceResult>(); }
  void Run(const AnalysisRun& run) const override;

private:
  /// A number or the name of a file.
  std::string Tolerance;
  std::string Distribution = "uniform";
  /// True if the tolerances of the drawing in the file count.
  bool FromFile = false;
  /// What FindProblem() read of Tolerance, which may be a pipe that can be read once.
  mutable bool IsRead = false;
  mutable std::vector<ToleranceFileRule> Rules;
  mutable double Lower = 0.0, Upper = 0.0;
};
}

#endif
