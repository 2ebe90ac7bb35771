#include "Detail/smPreparedFaces.h"

#include "smParallelFor.h"

#include "vtkTimerLog.h"

#include <algorithm>

namespace sm
{
namespace
{
// Fraction of the progress for the shapes of faces; the deviations take the rest.
constexpr double ShapesShare = 0.2;
// Intended duration of a portion in seconds, and the number of items of the first one.
constexpr double PortionSeconds = 0.1;
constexpr std::size_t FirstFaces = 16;
constexpr std::size_t FirstSubPatches = 256;

std::size_t CountBytes(const SubPatchFace& face)
{
  std::size_t bytes = face.Points.size() * sizeof(face.Points[0]) + face.Deviations.size() * sizeof(double) +
    face.Patches.size() * sizeof(Patch);
  for (const auto& loop : face.Polygons.Loops)
  {
    bytes += loop.size() * sizeof(loop[0]);
  }
  for (const TrimRise& rise : face.Rises)
  {
    bytes += sizeof(rise) + rise.size() * sizeof(rise[0]);
  }
  return bytes;
}

/// Calls `work` for parts of [0, count), from several threads, and `progress` with the fraction done after
/// every portion. A portion has at most twice as many items as the one before, which limits the effect of a
/// wrong clock reading. Returns false as soon as `progress` does.
bool RunPortions(std::size_t count, std::size_t first,
  const std::function<void(std::size_t begin, std::size_t end)>& work, const ProgressCallback& progress)
{
  std::size_t size = first;
  for (std::size_t begin = 0; begin < count;)
  {
    const std::size_t end = begin + std::min(size, count - begin);
    const double start = vtkTimerLog::GetUniversalTime();
    ParallelFor(end - begin, 0, [&](std::size_t from, std::size_t to) { work(begin + from, begin + to); });
    const double seconds = vtkTimerLog::GetUniversalTime() - start;
    const double wanted = static_cast<double>(end - begin) * PortionSeconds / std::max(seconds, 1e-6);
    size = static_cast<std::size_t>(std::max(1.0, std::min(wanted, 2.0 * static_cast<double>(size))));
    begin = end;
    if (!progress(static_cast<double>(end) / static_cast<double>(count)))
    {
      return false;
    }
  }
  return true;
}
}

bool PreparedFaces::Key::operator==(const Key& other) const
{
  const SchemeOptions& a = this->Options;
  const SchemeOptions& b = other.Options;
  return a.Factor == b.Factor && a.TextureFactor == b.TextureFactor && a.Deviation == b.Deviation &&
    a.ChordTolerance == b.ChordTolerance;
}

PreparedFaces::Key PreparedFaces::GetKey(const SchemeTask& task, const SchemeOptions& options)
{
  Key key{ options };
  key.Options.ChordTolerance = task.ChordTolerance;
  return key;
}

std::vector<std::size_t> PreparedFaces::FindMissing(
  const std::vector<SchemeTask>& tasks, const SchemeOptions& options)
{
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    const PreparedFace* known = this->Kept.Find(tasks[i].Source->Id, GetKey(tasks[i], options));
    if (known && (*known)->Source == tasks[i].Source)
    {
      this->Faces[i] = *known;
    }
    else
    {
      missing.push_back(i);
    }
  }
  return missing;
}

bool PreparedFaces::PrepareMissing(const std::vector<SchemeTask>& tasks,
  const std::vector<std::size_t>& missing, const SchemeOptions& options, const ProgressCallback& progress)
{
  std::vector<std::shared_ptr<SubPatchFace>> faces(missing.size());
  const auto prepare = [&](std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      const SchemeTask& task = tasks[missing[i]];
      faces[i] =
        std::make_shared<SubPatchFace>(PrepareSubPatchShape(task.Source, GetKey(task, options).Options));
    }
  };
  if (!RunPortions(missing.size(), FirstFaces, prepare,
        [&progress](double done) { return progress(ShapesShare * done); }))
  {
    return false;
  }
  // The sub-patches of all faces are numbered consecutively; those of face i begin at starts[i].
  std::vector<std::size_t> starts(faces.size() + 1, 0);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    starts[i + 1] = starts[i] + faces[i]->Deviations.size();
  }
  const auto deviate = [&](std::size_t begin, std::size_t end)
  {
    std::size_t i =
      static_cast<std::size_t>(std::upper_bound(starts.begin(), starts.end(), begin) - starts.begin()) - 1;
    for (; i < faces.size() && starts[i] < end; ++i)
    {
      ComputeDeviations(*faces[i], options.Deviation, std::max(begin, starts[i]) - starts[i],
        std::min(end, starts[i + 1]) - starts[i]);
    }
  };
  const std::size_t count = starts.back();
  const auto shouldContinue = [&](double done)
  {
    const auto now = static_cast<std::int64_t>(done * static_cast<double>(count) + 0.5);
    this->MaxPortion = std::max(this->MaxPortion, now - this->Deviations);
    this->Deviations = now;
    return progress(ShapesShare + (1.0 - ShapesShare) * done);
  };
  if (!RunPortions(count, FirstSubPatches, deviate, shouldContinue))
  {
    return false;
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const SchemeTask& task = tasks[missing[i]];
    const PreparedFace face = std::move(faces[i]);
    this->Faces[missing[i]] = face;
    this->Kept.Store(task.Source->Id, GetKey(task, options), face, CountBytes(*face));
  }
  return true;
}

bool PreparedFaces::Prepare(
  const std::vector<SchemeTask>& tasks, const SchemeOptions& options, const ProgressCallback& progress)
{
  this->Deviations = this->MaxPortion = 0;
  this->Faces.assign(tasks.size(), nullptr);
  const bool done = this->PrepareMissing(tasks, this->FindMissing(tasks, options), options, progress);
  this->Kept.EndRun();
  if (!done)
  {
    this->Faces.clear();
  }
  return done;
}
}
