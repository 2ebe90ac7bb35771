#include "smCacheBudget.h"

#include <algorithm>
#include <limits>

namespace sm
{
CacheBudget& CacheBudget::GetProcessBudget()
{
  // The object is never destroyed, because filters may outlive static objects.
  static auto* const budget = new CacheBudget(std::size_t{ 1 } << 30);
  return *budget;
}

void CacheBudget::SetLimit(std::size_t bytes)
{
  const std::lock_guard<std::recursive_mutex> lock(this->Mutex);
  this->Limit = bytes;
  this->Trim();
}

void CacheBudget::Add(Member* member)
{
  this->Members.push_back(member);
}

void CacheBudget::Remove(Member* member, std::size_t bytes)
{
  this->Members.erase(std::remove(this->Members.begin(), this->Members.end(), member), this->Members.end());
  this->CountRemoved(bytes);
}

void CacheBudget::Trim()
{
  while (this->Bytes > this->Limit)
  {
    const auto oldest = std::min_element(this->Members.begin(), this->Members.end(),
      [](const Member* a, const Member* b) { return a->GetOldestUse() < b->GetOldestUse(); });
    if (oldest == this->Members.end() ||
      (*oldest)->GetOldestUse() == std::numeric_limits<std::uint64_t>::max())
    {
      return;
    }
    this->CountRemoved((*oldest)->RemoveOldest());
  }
}
}
