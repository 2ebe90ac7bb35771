#include "smExtras.h"
#include "smFilterSetUp.h"
#include "smMassPropertyNames.h"
#include "smMessageList.h"
#include "smResults.h"
#include "smSectionAnalysis.h"

namespace sm
{
const char* SectionAnalysis::GetMissingModule() const
{
  return nullptr;
}

void SectionAnalysis::Run(const AnalysisRun& run) const
{
  std::string problem;
  if (const ExtraFunctions* functions = GetExtras(problem))
  {
    functions->RunSections(this->Planes, run);
    return;
  }
  run.Messages.AddEcho("no section was computed: " + problem);
  AddStatus(names::StatusNotComputed, run.File);
}
}
