#include "smFaceShares.h"

#include "Items/smBackendCost.h"
#include "smFaceBytes.h"

#include <algorithm>
#include <iterator>

namespace sm
{
namespace
{
constexpr std::uint64_t RunsKept = 8;
// Receivers keep faces longer than senders assume.
constexpr std::uint64_t RunsKeptByReceivers = 2 * RunsKept;
}

double EstimateCost(const Face& face)
{
  const double points = (1.0 + face.Surface.Degree[0]) * (1.0 + face.Surface.Degree[1]);
  // An item takes about as many points as a patch has coefficients, and each point costs as many products;
  // the constant is the cost of planning an item.
  return CountItems(face) * (20.0 + points * points);
}

std::vector<int> FaceShares::Divide(const std::vector<FaceTask>& tasks, const std::vector<bool>& fit)
{
  if (this->Session == 0 || this->Fit != fit)
  {
    this->Forget();
    this->Fit = fit;
  }
  const auto hasHome = [&fit](const Home& home) { return home.Rank >= 0 && fit[home.Rank]; };
  std::vector<int> ranks(tasks.size(), -1);
  std::vector<std::size_t> fresh;
  std::vector<double> costs(tasks.size(), 0.0);
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    Home& home = this->Homes[tasks[i].Source->Id];
    home.LastRun = this->Run;
    if (hasHome(home))
    {
      ranks[i] = home.Rank;
      continue;
    }
    costs[i] = EstimateCost(*tasks[i].Source);
    fresh.push_back(i);
  }
  std::stable_sort(
    fresh.begin(), fresh.end(), [&costs](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });
  std::vector<double> loads(fit.size(), 0.0);
  for (const std::size_t i : fresh)
  {
    Home& home = this->Homes[tasks[i].Source->Id];
    // Another task of this run may have assigned the face already.
    if (!hasHome(home))
    {
      int minimum = -1;
      for (int rank = 0; rank < static_cast<int>(fit.size()); ++rank)
      {
        minimum = fit[rank] && (minimum < 0 || loads[rank] < loads[minimum]) ? rank : minimum;
      }
      home = { minimum, this->Run, false };
    }
    ranks[i] = home.Rank;
    loads[home.Rank] += costs[i];
  }
  return ranks;
}

void FaceShares::Pack(const std::vector<FaceTask>& tasks, const std::vector<std::size_t>& own, ByteWriter& to)
{
  to.Put(this->Session);
  to.Put(static_cast<std::uint64_t>(own.size()));
  FaceWriter faces(to);
  const FaceTask* last = nullptr;
  for (const std::size_t i : own)
  {
    const FaceTask& task = tasks[i];
    // Faces of one body have the same tolerances and placement.
    const bool isSame = last && last->Tolerances == task.Tolerances && last->Placement == task.Placement &&
      last->PlacementBound == task.PlacementBound;
    to.Put(isSame);
    if (!isSame)
    {
      to.PutAll(task.Tolerances);
      to.Put(task.Placement);
      to.Put(task.PlacementBound);
    }
    last = &task;
    Home& home = this->Homes.at(task.Source->Id);
    to.Put(task.Source->Id);
    to.Put(!home.IsThere);
    if (!home.IsThere)
    {
      faces.Put(*task.Source);
      home.IsThere = true;
    }
  }
}

void FaceShares::EndRun()
{
  ++this->Run;
  for (auto home = this->Homes.begin(); home != this->Homes.end();)
  {
    home = home->second.LastRun + RunsKept < this->Run ? this->Homes.erase(home) : std::next(home);
  }
}

void FaceShares::Forget()
{
  this->Homes.clear();
  this->Session = NewId();
}

void FaceShares::ForgetSent(int rank)
{
  for (auto& [id, home] : this->Homes)
  {
    home.IsThere = home.IsThere && home.Rank != rank;
  }
}

ReceivedFaces::ReceivedFaces(CacheBudget& budget)
  : Faces(budget, RunsKeptByReceivers)
{
}

void ReceivedFaces::Clear()
{
  this->Faces.Clear();
  this->Sender = -1;
  this->Session = 0;
}

std::uint64_t ReceivedFaces::FindSession(int sender)
{
  this->ToldEvictions = this->Faces.GetNumberOfEvictions();
  return sender == this->Sender && this->ToldEvictions == this->KnownEvictions ? this->Session : 0;
}

bool ReceivedFaces::Unpack(int sender, ByteReader& from, std::vector<FaceTask>& tasks)
{
  const auto session = from.Get<std::uint64_t>();
  if (sender != this->Sender || session != this->Session)
  {
    this->Faces.Clear();
    this->Sender = sender;
    this->Session = session;
  }
  this->KnownEvictions = this->ToldEvictions;
  tasks.clear();
  const bool isRead = this->ReadTasks(from, tasks);
  this->Faces.EndRun();
  return isRead && from.IsGood();
}

bool ReceivedFaces::ReadTasks(ByteReader& from, std::vector<FaceTask>& tasks)
{
  const std::size_t count = from.GetCount(2 + sizeof(std::uint64_t));
  FaceReader faces(from);
  FaceTask task;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!from.Get<bool>())
    {
      task.Tolerances = from.GetAll<double>();
      task.Placement = from.Get<std::array<double, 12>>();
      task.PlacementBound = from.Get<PlacementError>();
    }
    const auto id = from.Get<std::uint64_t>();
    const FacePointer* known = this->Faces.Find(id, {});
    if (from.Get<bool>())
    {
      const std::size_t begin = from.GetPosition();
      const FacePointer face = faces.Get();
      if (!face)
      {
        return false;
      }
      // A face that is sent again, although it is here, keeps its id and what is kept by it.
      if (!known)
      {
        // In memory it takes about as many bytes as in the message.
        this->Faces.Store(id, {}, face, from.GetPosition() - begin);
        known = this->Faces.Find(id, {});
      }
    }
    if (!from.IsGood() || !known)
    {
      return false;
    }
    task.Source = *known;
    tasks.push_back(task);
  }
  return true;
}
}
