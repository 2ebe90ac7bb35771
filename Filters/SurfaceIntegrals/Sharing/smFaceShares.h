/**
 * @file smFaceShares.h
 * @brief Which rank integrates which face, and what it needs to be sent for it
 *
 * A face goes to the rank that had it last, where it is cut, planned and perhaps integrated already; new ones go to the rank
 * that has the least new work, the dearest first. A face travels once: ranks keep the faces of the last runs.
 */
#ifndef smFaceShares_h
#define smFaceShares_h

#include "smBytes.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smSurfaceIntegrator.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace sm
{
/// About how long a face takes to be cut, planned and integrated, in no unit: its items by what they evaluate.
SMFILTERSSURFACEINTEGRALS_EXPORT double EstimateCost(const Face& face);

/// Of the rank that has the faces.
class SMFILTERSSURFACEINTEGRALS_EXPORT FaceShares
{
public:
  /// A rank for every task, of those that are fit (one at least is).
  std::vector<int> Divide(const std::vector<FaceTask>& tasks, const std::vector<bool>& fit);
  /// The message that makes another rank know the tasks that are its own. Once after a Divide() for every such rank.
  void Pack(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& own, ByteWriter& to);
  /// Forgets what was not asked for in the last 8 runs.
  void EndRun();
  /// Sends all faces anew; ranks forget what they have, for it may not be what is believed.
  void Forget();

private:
  struct Home
  {
    int Rank = -1;
    std::uint64_t LastRun = 0;
    /// It was sent there.
    bool IsThere = false;
  };
  std::unordered_map<std::uint64_t, Home> Homes;
  std::uint64_t Session = 0;
  std::uint64_t Run = 0;
};

/// Of another rank: the faces that it was sent.
class SMFILTERSSURFACEINTEGRALS_EXPORT ReceivedFaces
{
public:
  /// False when the message makes no sense, or names a face that is not here.
  bool Unpack(int sender, ByteReader& from, std::vector<FaceTask>& tasks);
  std::size_t GetNumberOfFaces() const { return this->Faces.size(); }

private:
  struct Entry
  {
    FacePointer Face;
    std::uint64_t LastRun = 0;
  };
  /// By the sender's ids; the faces have ids of this process.
  std::unordered_map<std::uint64_t, Entry> Faces;
  int Sender = -1;
  std::uint64_t Session = 0;
  std::uint64_t Run = 0;
};
}

#endif
