/**
 * @file smReduction.h
 * @brief Deterministic segmented sums, minima and maxima of rows of doubles on the GPU
 */
#ifndef smReduction_h
#define smReduction_h

#include "smComputeBuffer.h"
#include "smComputeProgram.h"
#include "smRenderingComputeModule.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkComputeContext;

namespace sm
{
struct ContextResources;

/**
 * Reduces ranges of rows ("segments") column by column over a fixed tree: blocks of 64 consecutive rows,
 * counted from the segment's begin, each reduced in order by one invocation; then blocks of 64 of
 * those results, until one is left. The tree depends on the length of its own segment only, so the same rows
 * give the same bits however segments are batched, ordered and placed.
 *
 * SUM accumulates the rounding errors of all additions and adds them at the end (TwoSum; Ogita, Rump, Oishi,
 * "Accurate sum and dot product", SIAM J. Sci. Comput. 26, 2005, Algorithm 4.4), so |result - exact| <= eps
 * |exact| + g^2 sum|x| with g = 2 n eps / (1 - 2 n eps), eps = 2^-53, for the n rows of the segment; no bound
 * where the sum overflows.
 *
 * A NaN in a column makes the result of the column NaN, for every operation. A sum that overflows is
 * infinite. An empty segment gives 0, +infinity or -infinity for SUM, MINIMUM, MAXIMUM.
 */
class SMRENDERINGCOMPUTE_EXPORT Reduction
{
public:
  enum class Operation
  {
    SUM = 0,
    MINIMUM = 1,
    MAXIMUM = 2
  };

  /** Rows of one block of the tree. */
  static constexpr unsigned int BlockSize = 64;

  explicit Reduction(vtkComputeContext* context);

  /** Reduces the first `columns` of the `stride` doubles of each row in [begin, end) of each segment.
   * `result` gets segments.size() x columns values, [segment][column]. Segments may overlap and be in any
   * order. `rows` may be larger than a shader storage block. May be called outside a ContextScope. False,
   * with GetError(), when a segment is not inside `rows` or the context is not usable; `result` is empty
   * then. */
  bool Reduce(ComputeBuffer& rows, unsigned int stride, unsigned int columns,
    const std::vector<std::pair<unsigned int, unsigned int>>& segments, Operation operation,
    std::vector<double>& result);

  /** Frees the buffers that are kept on the GPU between calls. */
  void Free();

  const std::string& GetError() const { return this->Error; }

private:
  struct Level;
  bool Fail(const std::string& what);
  /**
   * Computes the number of blocks of the first level. Returns false if a segment is not inside the rows, or
   * if there are too many blocks.
   */
  bool CountBlocks(std::uint64_t available,
    const std::vector<std::pair<unsigned int, unsigned int>>& segments, std::uint64_t& total);
  bool PrepareProgram(unsigned int columns, Operation operation);
  bool ReduceLevel(ComputeBuffer& input, const Level& level, ComputeBuffer& output);

  std::shared_ptr<ContextResources> Resources;
  ComputeProgram Program;
  ComputeBuffer Blocks;
  ComputeBuffer Scratch[2];
  std::string Error;
};
}

#endif
