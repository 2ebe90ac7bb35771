#include "smFaceResultCache.h"

#include <algorithm>

namespace sm
{
namespace
{
constexpr std::uint64_t RunsKept = 8;
}

const FaceIntegrals* FaceResultCache::Find(std::uint64_t face, const FaceResultKey& question)
{
  const auto found = this->Faces.find(face);
  if (found == this->Faces.end())
  {
    return nullptr;
  }
  for (Entry& entry : found->second)
  {
    if (entry.Question == question)
    {
      entry.LastRun = this->Run;
      return &entry.Result;
    }
  }
  return nullptr;
}

void FaceResultCache::Store(std::uint64_t face, const FaceResultKey& question, const FaceIntegrals& result)
{
  if (!this->Find(face, question))
  {
    this->Faces[face].push_back({ question, result, this->Run });
  }
}

void FaceResultCache::EndRun()
{
  ++this->Run;
  for (auto face = this->Faces.begin(); face != this->Faces.end();)
  {
    std::vector<Entry>& entries = face->second;
    entries.erase(std::remove_if(entries.begin(), entries.end(),
                    [this](const Entry& entry) { return entry.LastRun + RunsKept < this->Run; }),
      entries.end());
    face = entries.empty() ? this->Faces.erase(face) : std::next(face);
  }
}

void FaceResultCache::Forget()
{
  this->Faces.clear();
}
}
