/**
 * @file smSchemeRunner.h
 * @brief Interface of the GPU and CPU runners, which evaluate tiles of the paper's schemes and sum their
 * results
 */
#ifndef smSchemeRunner_h
#define smSchemeRunner_h

#include "smProgressCallback.h"
#include "smSchemeBatch.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace sm
{
/**
 * Every batch has three steps: the trim curves are drawn into the texture of each tile, the rows of the
 * texture are swept, and the sub-patches are evaluated and weighted by their texels (glsl/smTrimTexture.glsl,
 * glsl/smSubPatch.glsl). The sums of a tile depend only on the tile: they are bitwise the same in any batch,
 * for any number of threads or dispatches.
 *
 * Methods return false if they fail, with GetError(), or if `shouldContinue` returned false. Not thread safe.
 */
class SchemeRunner
{
public:
  virtual ~SchemeRunner() = default;

  struct Setup
  {
    /// n: 1, 2 or 3 Gauss points in each direction.
    int Points = 2;
    /// Factor applied to every sample, for tests.
    double Perturbation = 1.0;
    /// If true, the results include the texels.
    bool KeepTexels = false;
  };

  struct Results
  {
    /// NumberOfSchemeColumns sums for every tile.
    std::vector<double> Sums;
    /// Texels of all tiles, at the positions of their first texels; empty unless KeepTexels is set.
    std::vector<std::int32_t> Texels;
    std::int64_t Evaluations = 0;
  };

  /// Returns the largest size in bytes of a list of a batch.
  virtual std::size_t GetMaximumBytes() const { return std::numeric_limits<std::uint32_t>::max(); }
  /// Builds the programs of these kernels.
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

  /// Returns the approximate cost of one sub-patch in bicubic evaluations.
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
