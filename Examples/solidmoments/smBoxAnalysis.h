/**
 * @file smBoxAnalysis.h
 * @brief Bounding boxes of the trimmed surfaces
 */
#ifndef smBoxAnalysis_h
#define smBoxAnalysis_h

#include "smAnalysis.h"

namespace sm
{
/// Sets the corners of every solid (BodyResult) and of all together.
class BoxAnalysis : public Analysis
{
public:
  const char* GetKey() const override { return "bounding_box"; }
  const char* GetOption() const override { return "--box"; }
  bool IsOfBodies() const override { return true; }
  void Declare(CLI::App& app) override;
  const char* GetMissingModule() const override;
  bool IsWanted() const override { return this->Wanted; }
  void Run(const AnalysisRun& run) const override;

private:
  bool Wanted = false;
};
}

#endif
