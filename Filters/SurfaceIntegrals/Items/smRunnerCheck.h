/**
 * @file smRunnerCheck.h
 * @brief Compares what a runner makes of a few items with what the CPU makes of them; not installed
 */
#ifndef smRunnerCheck_h
#define smRunnerCheck_h

#include "smItemRunner.h"

#include <string>
#include <vector>

namespace sm
{
/**
 * Evaluates items by a runner and by a CPUItemRunner, and returns a sentence about the first value that
 * differs by more than the roundings of both; empty if none does. A driver may compile an operation that the
 * start-up probe tests rightly there and wrongly elsewhere.
 *
 * `faces` are those of the last Acquire() and `batch` those of the last BeginBatch() of the runner, to whose
 * slots the items refer. Integrands that the CPU cannot evaluate are not compared. The runner's rows are
 * lost.
 */
std::string FindRunnerDifference(ItemRunner& runner, const ItemRunner::Setup& setup,
  const std::vector<CutFacePointer>& faces, const std::vector<ItemRunner::BatchFace>& batch, WorkItems items);
}

#endif
