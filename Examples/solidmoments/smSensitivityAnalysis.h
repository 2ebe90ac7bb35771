/**
 * @file smSensitivityAnalysis.h
 * @brief How mass properties of solids change if one face is moved along its normals
 */
#ifndef smSensitivityAnalysis_h
#define smSensitivityAnalysis_h

#include "smAnalysis.h"

#include <string>
#include <vector>

namespace sm
{
/// The derivatives of properties of its solid by an outward offset of a face.
struct SensitivityEntry
{
  std::string Solid;
  long long Face = -1;
  ScalarQuantity Volume, Mass, Area;
  VectorQuantity Center, PrincipalMoments;
};

/// The faces of a solid in their order; of a file those of all solids that change the volume most, at most
/// five.
class SensitivityResult : public AnalysisResultOf<SensitivityResult>
{
public:
  static constexpr std::size_t MaxFacesOfFile = 5;

  std::vector<SensitivityEntry> Faces;

  void Visit(Fields& fields, const char* key) override;
  std::string FormatRows(const std::string& unit) const override;
};

class SensitivityAnalysis : public Analysis
{
public:
  const char* GetKey() const override { return "sensitivity"; }
  const char* GetOption() const override { return "--sensitivity"; }
  void Declare(CLI::App& app) override;
  bool IsWanted() const override { return this->Wanted; }
  std::unique_ptr<AnalysisResult> MakeResult() const override;
  void Run(const AnalysisRun& run) const override;

private:
  bool Wanted = false;
};
}

#endif
