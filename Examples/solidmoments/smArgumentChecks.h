/**
 * @file smArgumentChecks.h
 * @brief Checks of single values on the command line: each returns an error message, empty for a value that
 * can be taken
 */
#ifndef smArgumentChecks_h
#define smArgumentChecks_h

#include <string>
#include <vector>

namespace sm
{
std::string CheckBackend(const std::string& name);
std::string CheckCollision(const std::string& word);
std::string CheckRepair(const std::string& word);
std::string CheckHidden(const std::string& word);
std::string CheckUnit(const std::string& name);
std::string CheckInputUnit(const std::string& name);
std::string CheckTolerance(const std::string& text);
std::string CheckGapLimit(const std::string& text);
std::string CheckValidationLimit(const std::string& text);
std::string CheckQuantityTolerance(const std::string& text);
std::string CheckFactor(const std::string& what, int maximum, const std::string& text);
std::string CheckEvaluations(const std::string& text);
std::string CheckSeconds(const std::string& text);
std::string CheckDensity(const std::string& text);
std::string CheckShare(const std::string& text);
std::string CheckFrame(const std::string& text);
std::string CheckFailOn(const std::string& text);
std::string CheckRequire(const std::string& text);
}

#endif
