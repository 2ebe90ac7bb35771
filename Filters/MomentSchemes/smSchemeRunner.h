/**
 * @file smSchemeRunner.h
 * @brief What evaluates tiles of the paper's schemes and sums their results: the GPU or the CPU
 */
#ifndef smSchemeRunner_h
#define smSchemeRunner_h

#include "smProgressCallback.h"
#include "smSchemeBatch.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace sm
{
/**
 * Three steps for every batch: the trim curves are drawn into the texture of each tile, its rows are swept, and
 * the sub-patches are evaluated and weighed by their texels (glsl/smTrimTexture.glsl, glsl/smSubPatch.glsl). The sums of a tile
 * depend on nothing but the tile: the same bits in any batch, for any number of threads or dispatches.
 *
 * Methods return false when they fail, with GetError(), or when `shouldContinue` said so. Not thread safe.
 */
class SchemeRunner
{
public:
  virtual ~SchemeRunner() = default;

  struct Setup
  {
    /// n: 1, 2 or 3 Gauss points in each direction.
    int Points = 2;
    /// A factor of every sample, for tests.
    double Perturbation = 1.0;
    /// Hand out the texels.
    bool KeepTexels = false;
  };

  struct Results
  {
    /// NumberOfSchemeColumns for every tile.
    std::vector<double> Sums;
    /// Of all tiles, as their first texels say; empty unless they are to be kept.
    std::vector<std::int32_t> Texels;
    std::int64_t Evaluations = 0;
  };

  /// Bytes that a list of a batch may have.
  virtual std::size_t GetMaximumBytes() const { return std::numeric_limits<std::uint32_t>::max(); }
  /// Builds what these kernels need.
  virtual bool Prepare(const std::set<SchemeKernel>&) { return true; }
  virtual bool Run(const SchemeBatch& batch, const Setup& setup, Results& results,
    const ContinueCallback& shouldContinue) = 0;

  const std::string& GetError() const { return this->Error; }

protected:
  bool Fail(const std::string& what)
  {
    this->Error = what;
    return false;
  }

  /// Work of one sub-patch, about, in bicubic evaluations.
  static std::int64_t GetCost(const SchemeBatch::Part& part, int points)
  {
    const std::int64_t across = part.Degree[0] + 1;
    const std::int64_t along = part.Degree[1] + 1;
    return 1 + points * across * along / 8 + points * points * across / 4;
  }

private:
  std::string Error;
};
}

#endif
