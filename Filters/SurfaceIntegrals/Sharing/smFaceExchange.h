/**
 * @file smFaceExchange.h
 * @brief How the ranks of a parallel run talk while they share the faces of one of them
 */
#ifndef smFaceExchange_h
#define smFaceExchange_h

#include "smBytes.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace sm
{
/**
 * Every method is collective: all ranks call it, in the same order, and it returns when a rank has what is meant for it. False:
 * the connection is gone, for good. Ranks are numbered from 0; they are machines of one kind (smBytes.h).
 */
class FaceExchange
{
public:
  virtual ~FaceExchange() = default;

  virtual int GetNumberOfRanks() const = 0;
  virtual int GetRank() const = 0;

  /// `all` gets what every rank gave, in the order of the ranks. As many numbers on all ranks.
  virtual bool Share(const std::vector<double>& mine, std::vector<double>& all) = 0;
  /// `all`, on `root` alone, gets a message of every rank.
  virtual bool Gather(int root, const Bytes& mine, std::vector<Bytes>& all) = 0;
  /// `mine` gets the rank's message of `all`, which counts on `root` alone.
  virtual bool Scatter(int root, const std::vector<Bytes>& all, Bytes& mine) = 0;
};

/// What a rank computes with.
struct RankDevice
{
  std::string Backend;
  std::string Renderer;
  /// Why it is not the backend that was preferred; or empty.
  std::string Note;
  /// Not empty: nothing can be computed on this rank.
  std::string DisabledReason;
  /// Counts dispatches; may be empty.
  std::function<std::int64_t()> CountDispatches;
};

/// What a rank did in a shared run.
struct RankReport
{
  std::string Backend;
  std::string Renderer;
  std::string Note;
  /// Faces that were in its share and whose results are from there.
  std::size_t Faces = 0;
  std::int64_t Evaluations = 0;
  std::int64_t Dispatches = 0;
  /// Not empty: why it took no share, or why the share was done by the rank that has the faces.
  std::string FailureReason;
};
}

#endif
