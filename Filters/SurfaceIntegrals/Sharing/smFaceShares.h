/**
 * @file smFaceShares.h
 * @brief Assignment of faces to ranks, and the messages that send them
 *
 * A face is assigned to the rank that had it last, where it is already cut, planned and perhaps integrated.
 * New faces are assigned in the order of descending cost to the rank with the smallest new work. A face is
 * sent once: ranks keep the faces of the last runs.
 */
#ifndef smFaceShares_h
#define smFaceShares_h

#include "smBytes.h"
#include "smFaceCache.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smSurfaceIntegrator.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace sm
{
/// Returns the approximate cost of cutting, planning and integrating a face in arbitrary units, from the
/// number and degree of its items.
SMFILTERSSURFACEINTEGRALS_EXPORT double EstimateCost(const Face& face);

/// Assignment of faces, on the rank that has the faces.
class SMFILTERSSURFACEINTEGRALS_EXPORT FaceShares
{
public:
  /// Returns a rank for every task, among those with `fit` true, of which there must be one at least. If
  /// these are not the ranks of the last run, all faces are assigned anew and sent again: a rank that was not
  /// fit may have lost its faces, or has none.
  std::vector<int> Divide(const std::vector<FaceTask>& tasks, const std::vector<bool>& fit);
  /// Writes the message by which another rank receives the tasks assigned to it. It must be called once after
  /// each Divide() for every such rank.
  void Pack(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& own, ByteWriter& to);
  /// Removes the faces that were not in the last 8 runs.
  void EndRun();
  /// The number of the session, for all faces that were sent since the last Forget(); 0 before the first.
  std::uint64_t GetSession() const { return this->Session; }
  /// Lets the faces of a rank that has lost some of them be sent again.
  void ForgetSent(int rank);
  /// Starts a new session, in which all faces are sent again and ranks discard the faces that they have,
  /// since their state is unknown.
  void Forget();

private:
  struct Home
  {
    int Rank = -1;
    std::uint64_t LastRun = 0;
    /// True if the face was sent to the rank.
    bool IsThere = false;
  };
  std::unordered_map<std::uint64_t, Home> Homes;
  std::vector<bool> Fit;
  std::uint64_t Session = 0;
  std::uint64_t Run = 0;
};

/// The faces received by another rank, within the budget of all caches.
class SMFILTERSSURFACEINTEGRALS_EXPORT ReceivedFaces
{
public:
  explicit ReceivedFaces(CacheBudget& budget = CacheBudget::GetProcessBudget());

  /// Reads the tasks of a message. Returns false if the message is invalid or refers to a face that was not
  /// received.
  bool Unpack(int sender, ByteReader& from, std::vector<FaceTask>& tasks);
  /// Returns the session of the sender whose faces are all here. Returns 0 if they are of another session or
  /// rank, or if the budget has removed some of them: the sender then sends them again with its next message.
  std::uint64_t FindSession(int sender);
  std::size_t GetNumberOfFaces() const { return this->Faces.GetNumberOfFaces(); }
  void Clear();

private:
  bool ReadTasks(ByteReader& from, std::vector<FaceTask>& tasks);

  /// Faces by the sender's ids; the faces themselves have ids of this process.
  FaceCache<NoKey, FacePointer> Faces;
  int Sender = -1;
  std::uint64_t Session = 0;
  /// Numbers of evictions of which the sender knows, and at the last FindSession().
  std::uint64_t KnownEvictions = 0;
  std::uint64_t ToldEvictions = 0;
};
}

#endif
