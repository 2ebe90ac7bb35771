#include "smBoxAnalysis.h"
#include "smBudgetAnalysis.h"
#include "smBuoyancyAnalysis.h"
#include "smIntegralAnalysis.h"
#include "smSectionAnalysis.h"
#include "smSensitivityAnalysis.h"
#include "smStabilityAnalysis.h"
#include "smToleranceAnalysis.h"

namespace sm
{
AnalysisList MakeAnalyses()
{
  // In the order of the help, of the columns and, after those of bodies, of the rows of the table.
  return { std::make_shared<IntegralAnalysis>(), std::make_shared<BuoyancyAnalysis>(),
    std::make_shared<SectionAnalysis>(), std::make_shared<SensitivityAnalysis>(),
    std::make_shared<ToleranceAnalysis>(), std::make_shared<BoxAnalysis>(),
    std::make_shared<StabilityAnalysis>(), std::make_shared<BudgetAnalysis>() };
}
}
