/**
 * @file smSectionAnalysis.h
 * @brief Sections with planes, and what lies on either side
 */
#ifndef smSectionAnalysis_h
#define smSectionAnalysis_h

#include "smAnalysis.h"

#include <array>

namespace sm
{
struct SectionEntry
{
  std::array<double, 6> Plane{}; ///< point and normal
  ScalarQuantity Area;
  VectorQuantity Centroid;
  TensorQuantity SecondMoments;
  Quantity<2> PrincipalMoments;
  Quantity<6> PrincipalDirections; ///< two vectors
  ScalarQuantity VolumeBelow, VolumeAbove, MassBelow, MassAbove;
  VectorQuantity CenterBelow, CenterAbove;
};

class SectionResult : public AnalysisResultOf<SectionResult>
{
public:
  std::vector<SectionEntry> Sections;

  void Visit(Fields& fields, const char* key) override;
  void AddColumns(Columns& columns) const override;
  std::string FormatRows(const std::string& unit) const override;
};

/// A point, in the unit of the results, and a normal that is not 0, each.
using SectionPlanes = std::vector<std::array<double, 6>>;

class SectionAnalysis : public Analysis
{
public:
  const char* GetKey() const override { return "sections"; }
  const char* GetStage() const override { return "section"; }
  const char* GetOption() const override { return "--section"; }
  void Declare(CLI::App& app) override;
  const char* GetMissingModule() const override;
  bool IsWanted() const override { return !this->Planes.empty(); }
  std::unique_ptr<AnalysisResult> MakeResult() const override;
  void Run(const AnalysisRun& run) const override;

private:
  SectionPlanes Planes;
};
}

#endif
