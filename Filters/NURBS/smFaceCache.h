/**
 * @file smFaceCache.h
 * @brief A cache of results of faces from run to run: by face id and key, within a budget of bytes
 */
#ifndef smFaceCache_h
#define smFaceCache_h

#include "smCacheBudget.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <list>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

namespace sm
{
/// The key of a cache that keeps one entry per face.
struct NoKey
{
  bool operator==(const NoKey&) const { return true; }
};

/**
 * Maps (face id, Key) to a Value, which is cheap to copy, as a shared pointer is. Entries go when the budget
 * is spent, the one used longest ago first, and when RunsKept runs have not used them. Entries that were used
 * since the last EndRun() stay until then. Keys need ==. The budget outlives the cache. Safe to use together
 * with other caches of the budget in other threads; one cache is for one thread.
 */
template <typename Key, typename Value>
class FaceCache final : private CacheBudget::Member
{
public:
  explicit FaceCache(CacheBudget& budget = CacheBudget::GetProcessBudget(), std::uint64_t runsKept = 8)
    : Budget(budget)
    , RunsKept(runsKept)
  {
    const Lock lock(this->Budget.GetMutex());
    this->Budget.Add(this);
  }
  ~FaceCache() override
  {
    const Lock lock(this->Budget.GetMutex());
    this->Budget.Remove(this, this->Bytes);
  }
  FaceCache(const FaceCache&) = delete;
  FaceCache& operator=(const FaceCache&) = delete;

  /// Returns the value of the entry, or null if there is none. The pointer is valid until the cache changes.
  const Value* Find(std::uint64_t face, const Key& key)
  {
    const Lock lock(this->Budget.GetMutex());
    const auto found = this->Places.find(face);
    if (found == this->Places.end())
    {
      return nullptr;
    }
    for (const auto entry : found->second)
    {
      if (entry->EntryKey == key)
      {
        this->MarkUsed(entry);
        return &entry->EntryValue;
      }
    }
    return nullptr;
  }

  /// Adds an entry, or replaces the one with this key; `bytes` is the size of the value.
  void Store(std::uint64_t face, Key key, Value value, std::size_t bytes)
  {
    const Lock lock(this->Budget.GetMutex());
    this->Erase(face, key);
    // The place is reserved first: an exception for lack of memory leaves no entry without one.
    std::vector<Position>& places = this->Places[face];
    places.reserve(places.size() + 1);
    this->Entries.push_back({ face, std::move(key), std::move(value), bytes + sizeof(Entry), 0, 0 });
    const auto entry = std::prev(this->Entries.end());
    places.push_back(entry);
    this->MarkUsed(entry);
    this->Bytes += entry->Bytes;
    this->Budget.CountAdded(entry->Bytes);
    this->Budget.Trim();
  }

  /// Removes the entries for which `isDead(value)`.
  template <typename Test>
  void RemoveIf(Test&& isDead)
  {
    const Lock lock(this->Budget.GetMutex());
    for (auto entry = this->Entries.begin(); entry != this->Entries.end();)
    {
      const auto next = std::next(entry);
      if (isDead(entry->EntryValue))
      {
        this->Budget.CountRemoved(this->Remove(entry));
      }
      entry = next;
    }
  }

  /// Ends a run: from now on the budget may remove the entries that the run used. Entries that RunsKept runs
  /// have not used are removed.
  void EndRun()
  {
    const Lock lock(this->Budget.GetMutex());
    ++this->Run;
    while (!this->Entries.empty() && this->Entries.front().LastRun + this->RunsKept < this->Run)
    {
      this->Budget.CountRemoved(this->Remove(this->Entries.begin()));
    }
    this->Budget.Trim();
  }

  void Clear()
  {
    const Lock lock(this->Budget.GetMutex());
    this->Budget.CountRemoved(this->Bytes);
    this->Bytes = 0;
    this->Places.clear();
    this->Entries.clear();
  }

  std::size_t GetNumberOfFaces() const { return this->Places.size(); }
  std::size_t GetBytes() const { return this->Bytes; }
  /// Number of entries that the budget removed since construction.
  std::uint64_t GetNumberOfEvictions() const
  {
    const Lock lock(this->Budget.GetMutex());
    return this->Evictions;
  }

private:
  using Lock = std::lock_guard<std::recursive_mutex>;

  struct Entry
  {
    std::uint64_t Face;
    Key EntryKey;
    Value EntryValue;
    std::size_t Bytes;
    std::uint64_t LastUse;
    std::uint64_t LastRun;
  };
  /// In the order of their last use.
  using EntryList = std::list<Entry>;
  using Position = typename EntryList::iterator;

  std::uint64_t GetOldestUse() const override
  {
    const bool isFree = !this->Entries.empty() && this->Entries.front().LastRun != this->Run;
    return isFree ? this->Entries.front().LastUse : std::numeric_limits<std::uint64_t>::max();
  }

  std::size_t RemoveOldest() override
  {
    ++this->Evictions;
    return this->Remove(this->Entries.begin());
  }

  std::size_t Remove(Position entry)
  {
    const auto places = this->Places.find(entry->Face);
    std::vector<Position>& entries = places->second;
    for (auto place = entries.begin(); place != entries.end(); ++place)
    {
      if (*place == entry)
      {
        entries.erase(place);
        break;
      }
    }
    if (entries.empty())
    {
      this->Places.erase(places);
    }
    const std::size_t bytes = entry->Bytes;
    this->Bytes -= bytes;
    this->Entries.erase(entry);
    return bytes;
  }

  void Erase(std::uint64_t face, const Key& key)
  {
    const auto found = this->Places.find(face);
    if (found == this->Places.end())
    {
      return;
    }
    for (const auto entry : found->second)
    {
      if (entry->EntryKey == key)
      {
        this->Budget.CountRemoved(this->Remove(entry));
        return;
      }
    }
  }

  void MarkUsed(Position entry)
  {
    entry->LastUse = this->Budget.GetNextUse();
    entry->LastRun = this->Run;
    this->Entries.splice(this->Entries.end(), this->Entries, entry);
  }

  CacheBudget& Budget;
  std::uint64_t RunsKept;
  EntryList Entries;
  std::unordered_map<std::uint64_t, std::vector<Position>> Places;
  std::size_t Bytes = 0;
  std::uint64_t Run = 1;
  std::uint64_t Evictions = 0;
};
}

#endif
