// The chunks that all items of integration share (smWork, smFinish), compiled as C++: rules, the error made
// of differences of orders, and how an item ends: compared, stored, discarded.
#include "smGaussLegendre.h"
#include "smTesting.h"
#include "smUnitRoundoff.h"

#include "smPortableCxx.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

namespace
{
using namespace smtest;

constexpr double Infinity = std::numeric_limits<double>::infinity();
#define SM_INTEGRANDS 2
#define SM_PLACEMENT IsPlaced
#define SM_MIN_ERROR_SHARE 1e-3

/// Two integrands that share a rounding. Rows: three columns of gaps, values, errors, rounding, differences.
class Chunk
{
public:
#include "glsl/smWorkRecord.glsl"

#include "glsl/smFinish.glsl"
#include "glsl/smWork.glsl"

  bool IsPlaced = true;
  double smValues[2] = { 0.0, 0.0 };
  double smRoundings[1] = { 0.0 };
  int smRoundingOf[2] = { 0, 0 };
  uint smValueColumn = 3;
  uint smErrorColumn = 5;
  uint smRoundingColumn = 7;
  uint smDifferenceColumn = 8;
  uint smStride = 10;
  uint smIntegrandCount = 2;
  uint smRoundingCount = 1;
  uint smToleranceOffset = 0;
  uint smPlacementOffset = 0;
  std::vector<double> Parameters = sm::GetRuleTable();
  std::vector<double> Rows = std::vector<double>(20, 0.0);
  bool Converged = false;

  double smResult(uint k)
  {
    return this->smValues[k];
  }
  double smNoise(uint k)
  {
    return smUnitRoundoff * this->smRoundings[k];
  }
  double smParameter(uint at)
  {
    return this->Parameters.at(at);
  }
  double smGetRow(uint at)
  {
    return this->Rows.at(at);
  }
  void smSetRow(uint at, double value)
  {
    this->Rows.at(at) = value;
  }
  void smSetStatus(uint, bool converged)
  {
    this->Converged = converged;
  }

  /// Ends an item of row 1 and face 1 with these sums; `scale` is that of its tolerances, 1 and 2.
  bool Finish(double a, double b, double rounding, uint flags, float scale = 1.0f)
  {
    this->smToleranceOffset = static_cast<uint>(sm::GetRuleTable().size());
    this->Parameters = sm::GetRuleTable();
    for (const double tolerance : { 1e300, 1e300, 1.0, 2.0 })
    {
      this->Parameters.push_back(tolerance);
    }
    this->smValues[0] = a;
    this->smValues[1] = b;
    this->smRoundings[0] = rounding;
    std::uint32_t bits;
    std::memcpy(&bits, &scale, sizeof(bits));
    return this->smFinish(
      0u, { uvec4(0u, 0u, 1u, 1u), uvec4(flags << 24 | 77u, 0u, 0u, bits), dvec4(0.0, 1.0, 0.0, 1.0) });
  }
  double GetError(int k) const
  {
    return this->Rows[10 + 5 + k];
  }
  double GetDifference(int k) const
  {
    return this->Rows[10 + 8 + k];
  }
};

void CheckRules()
{
  Chunk chunk;
  for (const int count : { 1, 2, 7, 32 })
  {
    // Exact to degree 2 n - 1: the integral of x^(2n-1) is 1 / (2n).
    double weights = 0.0;
    double power = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const dvec2 rule = chunk.smRule(count, i);
      weights += rule.y;
      power += rule.y * std::pow(rule.x, 2 * count - 1);
    }
    const std::string name = "rule of " + std::to_string(count) + " points: ";
    Check(name + "weights", 1.0, weights, 2 * count * sm::UnitRoundoff, "rounding of a sum");
    Check(name + "highest power", 0.5 / count, power, 4 * count * sm::UnitRoundoff, "rounding of powers");
  }
}

void CheckEstimate()
{
  Chunk chunk;
  Check("nothing before: ten times", 10.0, chunk.smEstimate(1.0, -1.0), 0.0);
  Check("falling fast: the difference", 1.0, chunk.smEstimate(1.0, 100.0), 0.0);
  Check("falling by less than ten: its tail", 5.0, chunk.smEstimate(1.0, 2.0), 1e-15);
  Check("rising: ten times", 30.0, chunk.smEstimate(3.0, 2.0), 1e-14);
  Check("small by chance: a thousandth of the one before", 5.0, chunk.smEstimate(1e-9, 5000.0), 1e-12);
  Check("no difference at all", 0.0, chunk.smEstimate(0.0, 0.0), 0.0);
}

void CheckComparison()
{
  Chunk chunk;
  chunk.Rows.assign(20, 7.0);
  CheckTrue("first order: kept", chunk.Finish(3.0, -4.0, 2.0, Chunk::smFlagFirst | Chunk::smFlagFlip));
  CheckTrue("nothing to compare with is converged", chunk.Converged);
  const std::vector<double> expected = { 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 3, -4, 0, 0,
    2 * sm::UnitRoundoff, -1, -1 };
  CheckTrue("its own row is written, but the gaps", chunk.Rows == expected);

  CheckTrue("second order: kept", chunk.Finish(3.0625, -4.0, 2.0, 0u));
  CheckTrue("0.625 is below the tolerance 1", chunk.Converged);
  Check("error", 0.625, chunk.GetError(0), 0.0);
  Check("difference", 0.0625, chunk.GetDifference(0), 0.0);
  // The largest difference of the two orders counts, relative to the tolerance.
  CheckRange("no difference, the other's error", 1.2, chunk.GetError(1), 1.25);
  chunk.Finish(3.0625, -5.0, 2.0, 0u);
  CheckTrue("10 is above the tolerance 2", !chunk.Converged);

  // Third order: 0.0625, then 0.015625: 0.015625 * 10 / 4.
  chunk.Finish(3.0, 0.0, 0.0, Chunk::smFlagFirst);
  chunk.Finish(3.0625, 0.0, 0.0, 0u);
  chunk.Finish(3.078125, 0.0, 0.0, 0u);
  Check("error of the third order", 0.0390625, chunk.GetError(0), 1e-17);

  for (const bool isHalf : { false, true })
  {
    chunk.Finish(0.0, 0.0, 0.0, Chunk::smFlagFirst);
    chunk.Finish(0.0625, 0.0, 0.0, 0u, isHalf ? 0.5f : 0.75f);
    CheckTrue(isHalf ? "0.625 is above half the tolerance" : "0.625 is below three quarters of it",
      chunk.Converged != isHalf);
  }
  // Differences of the size of rounding say nothing: 10 * 2^-53 * 1e17 = 111.
  chunk.Finish(0.0, 0.0, 1e17, Chunk::smFlagFirst);
  chunk.Finish(0.0, 11.0, 1e17, 0u);
  CheckTrue("110 is below the tolerance and ten roundings", chunk.Converged);
  chunk.Finish(0.0, 0.0, 1e17, Chunk::smFlagFirst);
  chunk.Finish(0.0, 11.5, 1e17, 0u);
  CheckTrue("115 is above them", !chunk.Converged);
}

void CheckDiscarded()
{
  Chunk chunk;
  chunk.Finish(1.0, 1.0, 1.0, Chunk::smFlagFirst);
  chunk.Rows[10] = 9.0;
  CheckTrue("unconverged and to be bisected: not kept", !chunk.Finish(2.0, 1.0, 1.0, Chunk::smFlagDiscard));
  CheckTrue("it says so", !chunk.Converged);
  const std::vector<double> expected = { 9, 0, 0, 0, 0, 0, 0, 0, 0, 0 };
  CheckTrue("zeros but in the gaps", std::equal(expected.begin(), expected.end(), chunk.Rows.begin() + 10));
  chunk.Finish(1.0, 1.0, 1.0, Chunk::smFlagFirst);
  CheckTrue("converged: kept for all that", chunk.Finish(1.0, 1.0, 1.0, Chunk::smFlagDiscard));
  Check("with its value", 1.0, chunk.Rows[13], 0.0);
}

void CheckNoNumbers()
{
  Chunk chunk;
  chunk.Finish(std::nan(""), -Infinity, 1.0, Chunk::smFlagFirst);
  CheckTrue("NaN is an error that is NaN", std::isnan(chunk.GetError(0)) && std::isnan(chunk.Rows[13]));
  CheckTrue("infinity an infinite one", chunk.GetError(1) == Infinity && chunk.Rows[14] == -Infinity);
  chunk.Finish(std::nan(""), -Infinity, 1.0, Chunk::smFlagDiscard);
  CheckTrue("no order will mend them: converged", chunk.Converged && std::isnan(chunk.GetError(0)));
  CheckTrue("and no difference makes less of them", chunk.GetError(1) == Infinity);
  chunk.Finish(std::nan(""), 0.0, 1.0, Chunk::smFlagFirst);
  chunk.Finish(std::nan(""), 1.0, 1.0, 0u);
  CheckTrue("but the other integrand counts", !chunk.Converged);
  chunk.Finish(std::nan(""), 0.0, 1.0, Chunk::smFlagFirst);
  chunk.Finish(1.0, 0.0, 1.0, 0u);
  CheckTrue("an order that misses the point does not mend it",
    chunk.Converged && std::isnan(chunk.Rows[13]) && std::isnan(chunk.GetError(0)));
  chunk.Finish(Infinity, 0.0, 1.0, Chunk::smFlagFirst);
  CheckTrue("nor do the parts of an item that is discarded",
    !chunk.Finish(1.0, 5.0, 1.0, Chunk::smFlagDiscard) && chunk.Rows[13] == Infinity &&
      chunk.GetError(0) == Infinity && chunk.Rows[14] == 0.0 && chunk.GetError(1) == 0.0);
}

void CheckPlacement()
{
  Chunk chunk;
  chunk.smPlacementOffset = 5;
  chunk.Parameters.assign(5 + 24, std::nan(""));
  const double rows[12] = { 0, -1, 0, 3, 1, 0, 0, 5, 0, 0, 2, -2 };
  std::copy_n(rows, 12, chunk.Parameters.begin() + 5 + 12);
  dvec3 position(1.0, 2.0, 4.0);
  dvec3 normal(0.5, 0.25, 8.0);
  chunk.smPlace(1u, position, normal);
  CheckTrue("position", position == dvec3(1.0, 6.0, 6.0));
  CheckTrue("normal", normal == dvec3(-0.25, 0.5, 16.0));
  chunk.IsPlaced = false;
  chunk.smPlace(0u, position, normal);
  CheckTrue("nothing where faces are not placed", position == dvec3(1.0, 6.0, 6.0));
}
}

int TestWorkChunk(int, char*[])
{
  CheckRules();
  CheckEstimate();
  CheckComparison();
  CheckDiscarded();
  CheckNoNumbers();
  CheckPlacement();
  return Finish();
}
