/**
 * @file smFaceExchange.h
 * @brief Interface for the communication of the ranks of a parallel run that share the faces of one rank
 */
#ifndef smFaceExchange_h
#define smFaceExchange_h

#include "smBytes.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace sm
{
/// Numbers that are added up over all ranks.
using RankNumbers = std::array<double, 5>;

/**
 * Every method is collective: all ranks call it, in the same order, and it returns as soon as the calling
 * rank has its data. It returns false if the connection is permanently lost. Ranks are numbered from 0 and
 * run on machines of one kind (smBytes.h).
 *
 * Other ranks do not wait for one whose memory is insufficient. Sum() needs no memory; Gather() and Scatter()
 * take part to the end, without keeping what they receive, and then throw std::bad_alloc.
 */
class FaceExchange
{
public:
  virtual ~FaceExchange() = default;

  virtual int GetNumberOfRanks() const = 0;
  virtual int GetRank() const = 0;

  /// Replaces the numbers by their sums over all ranks, which are the same on every rank.
  virtual bool Sum(RankNumbers& numbers) = 0;
  /// Sets `all` to one message of every rank, on `root` only.
  virtual bool Gather(int root, const Bytes& mine, std::vector<Bytes>& all) = 0;
  /// Sets `mine` to the rank's message in `all`, which is read on `root` only; messages that `all` lacks are
  /// empty.
  virtual bool Scatter(int root, const std::vector<Bytes>& all, Bytes& mine) = 0;
};

/// The device with which a rank computes.
struct RankDevice
{
  std::string Backend;
  std::string Renderer;
  /// Reason why it is not the preferred backend; empty if it is.
  std::string Note;
  /// Reason why nothing can be computed on this rank; empty if it can compute.
  std::string DisabledReason;
  /// Returns the number of dispatches; may be an empty function.
  std::function<std::int64_t()> CountDispatches;
};

/// Contribution of one rank to a shared run.
struct RankReport
{
  std::string Backend;
  std::string Renderer;
  std::string Note;
  /// Number of faces in its share whose results it computed.
  std::size_t Faces = 0;
  std::int64_t Evaluations = 0;
  std::int64_t Dispatches = 0;
  /// Reason why it had no share, or why the rank that has the faces computed its share; empty otherwise.
  std::string FailureReason;
};
}

#endif
