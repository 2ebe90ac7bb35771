// Caches of one budget: the entry used longest ago is removed first, whichever cache has it; what a run uses
// stays until its end.
#include "smFaceCache.h"
#include "smTesting.h"

#include <memory>
#include <optional>
#include <string>

namespace
{
using namespace smtest;
using Cache = sm::FaceCache<std::string, std::shared_ptr<const int>>;

/// Bytes of an entry in addition to those that Store() is given.
std::size_t GetOverhead()
{
  sm::CacheBudget budget(1000000);
  Cache cache(budget);
  cache.Store(1, "", std::make_shared<const int>(0), 0);
  return cache.GetBytes();
}

void Store(Cache& cache, std::uint64_t face, const std::string& key, int value, std::size_t bytes)
{
  cache.Store(face, key, std::make_shared<const int>(value), bytes - GetOverhead());
}

bool Has(Cache& cache, std::uint64_t face, const std::string& key, int value)
{
  const auto* found = cache.Find(face, key);
  return found && **found == value;
}

void CheckKeys()
{
  sm::CacheBudget budget(1000000);
  Cache cache(budget);
  CheckTrue("nothing yet", !cache.Find(1, "a"));
  Store(cache, 1, "a", 10, 1000);
  Store(cache, 1, "b", 11, 1000);
  Store(cache, 2, "a", 20, 1000);
  CheckTrue(
    "found by face and key", Has(cache, 1, "a", 10) && Has(cache, 1, "b", 11) && Has(cache, 2, "a", 20));
  CheckTrue("and by nothing else", !cache.Find(2, "b") && !cache.Find(3, "a"));
  Store(cache, 1, "a", 12, 2000);
  CheckTrue("replaced", Has(cache, 1, "a", 12) && Has(cache, 1, "b", 11));
  CheckEqual("faces", 2, static_cast<long long>(cache.GetNumberOfFaces()));
  CheckEqual("bytes", 4000, static_cast<long long>(cache.GetBytes()));
  CheckEqual("bytes of the budget", 4000, static_cast<long long>(budget.GetBytes()));
  cache.RemoveIf([](const std::shared_ptr<const int>& value) { return *value == 11; });
  CheckTrue("removed by its value", !cache.Find(1, "b") && Has(cache, 1, "a", 12));
  cache.Clear();
  CheckEqual("nothing left", 0, static_cast<long long>(cache.GetNumberOfFaces() + budget.GetBytes()));
}

void CheckAges()
{
  sm::CacheBudget budget(1000000);
  Cache cache(budget, 2);
  Store(cache, 1, "", 1, 1000);
  Store(cache, 2, "", 2, 1000);
  cache.EndRun();
  CheckTrue("used in every run", Has(cache, 1, "", 1));
  cache.EndRun();
  CheckTrue("one run without it", Has(cache, 1, "", 1) && cache.GetNumberOfFaces() == 2);
  cache.EndRun();
  CheckTrue("two", Has(cache, 1, "", 1) && !cache.Find(2, ""));
  CheckEqual("its bytes went with it", 1000, static_cast<long long>(budget.GetBytes()));
}

void CheckSharedBudget()
{
  sm::CacheBudget budget(5000);
  Cache first(budget);
  std::optional<Cache> second(std::in_place, budget);
  Store(first, 1, "", 1, 1000);
  Store(*second, 2, "", 2, 1000);
  Store(first, 3, "", 3, 1000);
  CheckTrue("within the limit", budget.GetBytes() == 3000 && first.GetBytes() == 2000);
  Store(*second, 4, "", 4, 3000);
  CheckEqual("what the runs use stays above the limit", 6000, static_cast<long long>(budget.GetBytes()));
  second->EndRun();
  CheckTrue("at its end the oldest of the second goes",
    !second->Find(2, "") && Has(*second, 4, "", 4) && budget.GetBytes() == 5000);
  budget.SetLimit(4500);
  CheckEqual("nothing else is free", 5000, static_cast<long long>(budget.GetBytes()));
  first.EndRun();
  CheckTrue(
    "then the oldest of the first", !first.Find(1, "") && Has(first, 3, "", 3) && budget.GetBytes() == 4000);
  first.EndRun();
  second->EndRun();
  budget.SetLimit(3500);
  CheckTrue("the one used longest ago, whichever cache has it", !second->Find(4, "") && Has(first, 3, "", 3));
  Store(*second, 5, "", 5, 1000);
  second.reset();
  CheckEqual("a cache takes its bytes with it", 1000, static_cast<long long>(budget.GetBytes()));
}
}

int TestFaceCache(int, char*[])
{
  CheckKeys();
  CheckAges();
  CheckSharedBudget();
  return Finish();
}
