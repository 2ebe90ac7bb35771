/**
 * @file smSharedRun.h
 * @brief The collective calls of a run on several ranks, in their order
 */
#ifndef smSharedRun_h
#define smSharedRun_h

#include "smFaceExchange.h"
#include "smFiltersSurfaceIntegralsModule.h"

#include <vector>

namespace sm
{
/**
 * The collective calls of one run, of which every rank makes all, in this order:
 *  1. GatherCapabilities(): all ranks send their capabilities to the root, the rank that has the faces;
 *  2. Decide(): the root decides whether it shares the run; if not, this is the last call;
 *  3. ScatterShares(): the root sends the faces;
 *  4. Agree() after every step, until some rank is stopped or no rank has any work left;
 *  5. GatherResults(): all ranks send their results to the root.
 * A rank that fails, by an exception or otherwise, leaves this order wherever it is. Finish() then makes the
 * calls that are left, so that no rank waits for it: if the root fails, it stops the run of all ranks; if
 * another one fails, the others complete the run.
 *
 * The calls return false if the connection to the other ranks is lost, after which there are no further
 * calls. A call that throws has been made.
 */
class SMFILTERSSURFACEINTEGRALS_EXPORT SharedRun
{
public:
  /// No run.
  SharedRun() = default;
  /// The exchange must outlive the run.
  SharedRun(FaceExchange& exchange, int root)
    : Exchange(&exchange)
    , Root(root)
    , Next(Call::GatherCapabilities)
  {
  }

  /// Returns true if calls are left.
  bool IsOpen() const { return this->Next != Call::None; }
  /// Returns true if the next call is Agree().
  bool HasSteps() const { return this->Next == Call::Agree; }
  bool IsLost() const { return this->Lost; }
  bool IsRoot() const { return this->Exchange && this->Exchange->GetRank() == this->Root; }
  int GetRoot() const { return this->Root; }

  bool GatherCapabilities(const Bytes& mine, std::vector<Bytes>& all);
  /// `shares` is the root's, and is then the same on all ranks.
  bool Decide(bool& shares);
  bool ScatterShares(const std::vector<Bytes>& all, Bytes& mine);

  struct Step
  {
    /// True if the rank, and then if any rank, was stopped, and if by the time limit.
    bool IsStopped = false;
    bool IsTimedOut = false;
    /// True if the step was a batch, and the number that of the batches left, whose sum 0 ends the steps.
    bool IsBatch = false;
    /// A number of this rank, and then the sum over all.
    double Number = 0.0;
  };
  bool Agree(Step& step);
  bool GatherResults(const Bytes& mine, std::vector<Bytes>& all);

  /// Makes the calls that are left, without work. `failure` is this rank's message with the reason; without
  /// bytes, it says that memory was insufficient. Allocates no memory that it needs.
  void Finish(const Bytes& failure) noexcept;

private:
  enum class Call
  {
    None,
    GatherCapabilities,
    Decide,
    ScatterShares,
    Agree,
    GatherResults
  };
  bool Check(bool isConnected);

  FaceExchange* Exchange = nullptr;
  int Root = 0;
  Call Next = Call::None;
  bool Lost = false;
};
}

#endif
