/**
 * @file smBudgetPicture.h
 * @brief Draws the mass in doubt as bars
 */
#ifndef smBudgetPicture_h
#define smBudgetPicture_h

#include "smBudgetAnalysis.h"
#include "smFileJob.h"

#include <string>

namespace sm
{
/// Draws the bars into a PNG file. Returns an error message, empty when it is written.
std::string WriteBudget(const BudgetResult& budget, const JobOptions& options, const std::string& fileName);
}

#endif
