/**
 * @file smCensusCases.h
 * @brief Small STEP texts and what a census must say of them
 */
#ifndef smCensusCases_h
#define smCensusCases_h

#include <string>
#include <vector>

namespace smtest
{
struct CensusCase
{
  std::string Name;
  /// A whole file.
  std::string Text;
  /// Expected answers of DescribeCounts() and DescribeProblems(…, 2).
  std::string Counts;
  std::string Problems;
};

/// Bodies and geometry; assemblies; units.
std::vector<CensusCase> GetBodyCases();
std::vector<CensusCase> GetAssemblyCases();
std::vector<CensusCase> GetUnitCases();
}

#endif
