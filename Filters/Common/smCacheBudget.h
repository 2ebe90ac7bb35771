/**
 * @file smCacheBudget.h
 * @brief One limit for the bytes that all caches of a process, or of a GL context, keep together
 */
#ifndef smCacheBudget_h
#define smCacheBudget_h

#include "smFiltersCommonModule.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace sm
{
/**
 * Caches join a budget and count their bytes in it. Trim() removes the entries that were used longest ago,
 * whichever cache has them, until the bytes are within the limit; entries that a running computation uses
 * stay. Thread safe: all work on the caches of a budget happens under its mutex.
 */
class SMFILTERSCOMMON_EXPORT CacheBudget
{
public:
  /// Callback by which a cache serves its budget; it is called with the mutex locked.
  class Member
  {
  public:
    virtual ~Member() = default;
    /// When the oldest entry that may be removed was used; the largest number when there is none.
    virtual std::uint64_t GetOldestUse() const = 0;
    /// Removes that entry, and returns its bytes.
    virtual std::size_t RemoveOldest() = 0;
  };

  explicit CacheBudget(std::size_t limit)
    : Limit(limit)
  {
  }

  /// The budget of what is kept in main memory: 1 GiB, unless SetLimit() changes it.
  static CacheBudget& GetProcessBudget();

  void SetLimit(std::size_t bytes);
  std::size_t GetLimit() const { return this->Limit; }
  std::size_t GetBytes() const { return this->Bytes; }

  std::recursive_mutex& GetMutex() { return this->Mutex; }

  ///@{
  /// For members, with the mutex locked.
  void Add(Member* member);
  void Remove(Member* member, std::size_t bytes);
  void CountAdded(std::size_t bytes) { this->Bytes += bytes; }
  void CountRemoved(std::size_t bytes) { this->Bytes -= bytes; }
  /// Uses are numbered in the order in which they happen, over all members.
  std::uint64_t GetNextUse() { return ++this->Use; }
  void Trim();
  ///@}

private:
  std::recursive_mutex Mutex;
  std::vector<Member*> Members;
  std::size_t Limit;
  std::size_t Bytes = 0;
  std::uint64_t Use = 0;
};
}

#endif
