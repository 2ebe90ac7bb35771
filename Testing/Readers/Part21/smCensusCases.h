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

/// A ball of one face in one product; some of its numbers: #6 context, #24 sphere, #28 bound, #29 face, #30 shell, #31 solid, #32
/// representation, #44 product definition, #46 shape definition.
std::string GetBallText();
/// `data` between header and end.
std::string MakeStepText(const std::string& data);
/// `text` with the first `from` replaced; throws std::logic_error when there is none.
std::string Replace(std::string text, const std::string& from, const std::string& to);

/// Bodies and geometry; assemblies; units.
std::vector<CensusCase> GetBodyCases();
std::vector<CensusCase> GetAssemblyCases();
std::vector<CensusCase> GetUnitCases();

/// A ball in `levels` levels of assemblies, each with two of the one below.
std::string MakeBomb(int levels);
}

#endif
