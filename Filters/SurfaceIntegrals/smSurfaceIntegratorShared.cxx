// Sharing of faces among ranks. A shared run is a fixed sequence of collective calls, the same on every rank in all cases: all
// ranks send their capabilities to the root and receive their shares; they agree once after cutting, once for every plan of the
// orders, once when the faces are acquired, and once after every batch, until some rank is stopped or none has any batch left;
// then they send their results to the root. A rank that fails continues without work, so that no rank waits for it.
#include "Sharing/smFaceBytes.h"
#include "smSurfaceIntegratorInternals.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace sm
{
namespace
{
/// FNV-1a hash.
std::uint64_t Digest(const Bytes& bytes)
{
  std::uint64_t hash = 14695981039346656037u;
  for (const char byte : bytes)
  {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211u;
  }
  return hash;
}

/// Header of the root's message to a rank, before the faces.
struct ShareHeader
{
  bool Go = false;
  bool Planned = false;
  /// Limit of the run time in seconds; 0: no limit.
  double Seconds = 0.0;
  /// Largest numbers of evaluations of all ranks together, and of this rank.
  std::int64_t RunMaximum = 0;
  std::int64_t Allowance = 0;
};
}

bool SurfaceIntegrator::Internals::OnConnectionLost()
{
  this->Aborted = true;
  this->IsShared = false;
  this->Error = "the connection to the other ranks was lost";
  return false;
}

bool SurfaceIntegrator::Internals::Agree(double& number)
{
  if (!this->IsShared)
  {
    return !this->Aborted;
  }
  const std::vector<double> mine{ this->Aborted ? 1.0 : 0.0, this->TimedOut ? 1.0 : 0.0, number };
  std::vector<double> all;
  if (!this->Exchange->Share(mine, all))
  {
    return this->OnConnectionLost();
  }
  number = 0.0;
  for (std::size_t i = 0; i < all.size(); i += mine.size())
  {
    this->Aborted = this->Aborted || all[i] != 0.0;
    this->TimedOut = this->TimedOut || all[i + 1] != 0.0;
    number += all[i + 2];
  }
  return !this->Aborted || this->Fail("aborted");
}

Bytes SurfaceIntegrator::Internals::MakeCapabilities() const
{
  // Settings on which results depend, in addition to the faces and their tasks.
  ByteWriter settings;
  settings.Put(this->UsePlacements);
  settings.Put(this->Perturbation);
  for (const Integrand& integrand : this->Integrands)
  {
    settings.PutText(integrand.Name);
    settings.PutText(integrand.Expression);
    settings.PutText(integrand.Source ? integrand.Source->MakeFunction("", false) : std::string());
    settings.Put(integrand.ClosedChain);
    settings.Put(integrand.ScalePower);
  }
  std::string obstacles;
  for (const std::string& obstacle : this->Obstacles)
  {
    obstacles += obstacle.empty() ? '0' : '1';
  }
  ByteWriter message;
  message.PutText(this->Device.DisabledReason);
  message.PutText(this->Device.Backend);
  message.PutText(this->Device.Renderer);
  message.PutText(this->Device.Note);
  message.Put(Digest(settings.GetBytes()));
  message.PutText(obstacles);
  return std::move(message.GetBytes());
}

std::vector<bool> SurfaceIntegrator::Internals::ReadCapabilities(const std::vector<Bytes>& capabilities)
{
  const int root = this->Exchange->GetRank();
  std::vector<std::pair<std::uint64_t, std::string>> signatures;
  for (const Bytes& message : capabilities)
  {
    ByteReader from(message);
    RankReport report;
    report.FailureReason = from.GetText();
    report.Backend = from.GetText();
    report.Renderer = from.GetText();
    report.Note = from.GetText();
    const auto digest = from.Get<std::uint64_t>();
    signatures.emplace_back(digest, from.GetText());
    this->Ranks.push_back(report);
  }
  std::vector<bool> fit;
  for (std::size_t rank = 0; rank < capabilities.size(); ++rank)
  {
    RankReport& report = this->Ranks[rank];
    if (report.FailureReason.empty() && signatures[rank].first != signatures[root].first)
    {
      report.FailureReason = "its integrands are not the same";
    }
    else if (report.FailureReason.empty() && signatures[rank].second != signatures[root].second)
    {
      report.FailureReason = "it cannot compute the same integrands";
    }
    fit.push_back(report.FailureReason.empty());
  }
  return fit;
}

bool SurfaceIntegrator::Internals::ReleaseWorkers()
{
  std::vector<Bytes> messages;
  Bytes own;
  if (!this->Exchange->Gather(this->Exchange->GetRank(), Bytes(), messages))
  {
    return this->OnConnectionLost();
  }
  ByteWriter to;
  to.Put(ShareHeader());
  messages.assign(messages.size(), to.GetBytes());
  return this->Exchange->Scatter(this->Exchange->GetRank(), messages, own) || this->OnConnectionLost();
}

bool SurfaceIntegrator::Internals::SendShares(
  const std::vector<FaceTask>& tasks, const std::vector<std::vector<std::size_t>>& shares)
{
  std::vector<double> costs;
  double total = 0.0;
  for (const std::vector<std::size_t>& share : shares)
  {
    costs.push_back(0.0);
    for (const std::size_t i : share)
    {
      costs.back() += EstimateCost(*tasks[i].Source);
    }
    total += costs.back();
  }
  const int root = this->Exchange->GetRank();
  std::vector<Bytes> messages(shares.size());
  for (std::size_t rank = 0; rank < shares.size(); ++rank)
  {
    ShareHeader header;
    header.Go = true;
    header.Planned = this->Planned;
    const double spent = vtkTimerLog::GetUniversalTime() - this->Start;
    header.Seconds = this->Seconds > 0.0 ? std::max(this->Seconds - spent, 1e-9) : 0.0;
    header.Allowance = shares[rank].size() == tasks.size()
      ? this->RunMaximum
      : static_cast<std::int64_t>(costs[rank] / total * static_cast<double>(this->RunMaximum));
    header.RunMaximum = this->RunMaximum;
    if (static_cast<int>(rank) == root)
    {
      this->Allowance = header.Allowance;
      continue;
    }
    ByteWriter to;
    to.Put(header);
    this->Shares.Pack(tasks, shares[rank], to);
    messages[rank] = std::move(to.GetBytes());
  }
  Bytes own;
  return this->Exchange->Scatter(root, messages, own) || this->OnConnectionLost();
}

bool SurfaceIntegrator::Internals::ReadResults(const Bytes& message, const std::vector<std::size_t>& share,
  RankReport& report, std::vector<FaceIntegrals>& results)
{
  ByteReader from(message);
  const std::string failure = from.GetText();
  report.Evaluations = from.Get<std::int64_t>();
  report.Dispatches = from.Get<std::int64_t>();
  const std::size_t count = from.GetCount(sizeof(std::uint64_t));
  std::vector<FaceIntegrals> received;
  for (std::size_t i = 0; i < count; ++i)
  {
    received.push_back(GetIntegrals(from));
  }
  this->Evaluations += report.Evaluations;
  if (failure.empty() && from.IsGood() && received.size() == share.size())
  {
    for (std::size_t i = 0; i < share.size(); ++i)
    {
      results[share[i]] = std::move(received[i]);
    }
    report.Faces = share.size();
    return true;
  }
  if (report.FailureReason.empty())
  {
    report.FailureReason = failure.empty() ? "its results are invalid" : failure;
  }
  return share.empty();
}

bool SurfaceIntegrator::Internals::RecomputeLocally(const std::vector<FaceTask>& tasks,
  const std::vector<std::size_t>& share, std::vector<FaceIntegrals>& results)
{
  std::vector<FaceTask> again;
  for (const std::size_t i : share)
  {
    again.push_back(tasks[i]);
  }
  std::vector<FaceIntegrals> found;
  // The tolerances that all ranks agreed on are used, so that results are bitwise the same.
  this->ForcedLoosenings = this->Planned ? this->Plans.GetLoosenings() : -1;
  this->Allowance = this->RunMaximum;
  const bool ran = !this->Aborted && this->Run(again, found);
  if (!ran && !this->Aborted)
  {
    return false;
  }
  FaceIntegrals unknown = this->MakeZeroResult();
  unknown.Skipped = true;
  for (const std::size_t k : this->Chosen)
  {
    unknown.QuadratureError[k] = std::numeric_limits<double>::infinity();
  }
  for (std::size_t i = 0; i < share.size(); ++i)
  {
    results[share[i]] = ran ? std::move(found[i]) : unknown;
  }
  return true;
}

bool SurfaceIntegrator::Internals::IntegrateShared(
  const std::vector<FaceTask>& tasks, std::vector<FaceIntegrals>& results)
{
  const int root = this->Exchange->GetRank();
  std::vector<Bytes> messages;
  if (!this->Exchange->Gather(root, this->MakeCapabilities(), messages))
  {
    return this->OnConnectionLost();
  }
  const std::vector<bool> fit = this->ReadCapabilities(messages);
  const std::vector<int> ranks = this->Shares.Divide(tasks, fit);
  std::vector<std::vector<std::size_t>> shares(fit.size());
  for (std::size_t i = 0; i < tasks.size(); ++i)
  {
    shares[ranks[i]].push_back(i);
  }
  if (!this->SendShares(tasks, shares))
  {
    return false;
  }
  std::vector<FaceTask> own;
  for (const std::size_t i : shares[root])
  {
    own.push_back(tasks[i]);
  }
  this->IsShared = true;
  std::vector<FaceIntegrals> ownResults;
  const std::int64_t dispatches = this->Device.CountDispatches ? this->Device.CountDispatches() : 0;
  const bool ran = this->Run(own, ownResults);
  const bool isLost = !this->IsShared;
  this->IsShared = false;
  if (isLost || !this->Exchange->Gather(root, Bytes(), messages))
  {
    return this->OnConnectionLost();
  }
  RankReport& report = this->Ranks[root];
  report.Faces = own.size();
  report.Evaluations = this->Evaluations;
  report.Dispatches = (this->Device.CountDispatches ? this->Device.CountDispatches() : 0) - dispatches;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    results[shares[root][i]] = std::move(ownResults[i]);
  }
  std::vector<std::size_t> left;
  for (std::size_t rank = 0; rank < shares.size(); ++rank)
  {
    if (static_cast<int>(rank) != root &&
      !this->ReadResults(messages[rank], shares[rank], this->Ranks[rank], results))
    {
      left.insert(left.end(), shares[rank].begin(), shares[rank].end());
    }
  }
  this->Shares.EndRun();
  if (!left.empty())
  {
    // A rank that failed may have lost the faces that it was sent.
    this->Shares.Forget();
  }
  if (!ran || !this->Failure.empty())
  {
    return this->Fail(this->Failure.empty() ? this->Error : this->Failure);
  }
  return left.empty() || this->RecomputeLocally(tasks, left, results);
}

Bytes SurfaceIntegrator::Internals::MakeResults(
  const std::vector<FaceIntegrals>& results, std::int64_t dispatches) const
{
  ByteWriter to;
  to.PutText(this->Failure);
  to.Put(this->Evaluations);
  to.Put(dispatches);
  const bool hasResults = this->Failure.empty();
  to.Put(static_cast<std::uint64_t>(hasResults ? results.size() : 0));
  for (std::size_t i = 0; i < results.size() && hasResults; ++i)
  {
    PutIntegrals(to, results[i]);
  }
  return std::move(to.GetBytes());
}

void SurfaceIntegrator::SetExchange(FaceExchange* exchange, const RankDevice& device)
{
  this->Implementation->Exchange = exchange && exchange->GetNumberOfRanks() > 1 ? exchange : nullptr;
  this->Implementation->Device = device;
}

bool SurfaceIntegrator::ReleaseWorkers()
{
  return !this->Implementation->Exchange || this->Implementation->ReleaseWorkers();
}

const std::vector<RankReport>& SurfaceIntegrator::GetRanks() const
{
  return this->Implementation->Ranks;
}

bool SurfaceIntegrator::RunAsWorker(int root, const ProgressCallback& progress)
{
  Internals& self = *this->Implementation;
  if (!self.Exchange)
  {
    return true;
  }
  self.Begin(progress);
  if (self.Device.DisabledReason.empty())
  {
    self.Configure();
  }
  std::vector<Bytes> nobody;
  Bytes message;
  if (!self.Exchange->Gather(root, self.MakeCapabilities(), nobody) ||
    !self.Exchange->Scatter(root, nobody, message))
  {
    return self.OnConnectionLost();
  }
  ByteReader from(message);
  const auto header = from.Get<ShareHeader>();
  if (!header.Go)
  {
    return true;
  }
  self.Start = vtkTimerLog::GetUniversalTime();
  self.Seconds = header.Seconds;
  self.RunMaximum = header.RunMaximum;
  self.Allowance = header.Allowance;
  std::vector<FaceTask> tasks;
  self.IsShared = true;
  if (!self.Guard(
        [&]() { return self.Received.Unpack(root, from, tasks) || self.Fail("the faces did not arrive"); }))
  {
    self.Failure = self.Error;
    tasks.clear();
  }
  if (self.Planned != header.Planned)
  {
    // A rank that cannot compute the same integrands has an empty share, so that its own configuration does not matter.
    self.Planned = header.Planned;
    self.Configured = false;
  }
  std::vector<FaceIntegrals> results;
  const std::int64_t dispatches = self.Device.CountDispatches ? self.Device.CountDispatches() : 0;
  self.Run(tasks, results);
  const bool isLost = !self.IsShared;
  self.IsShared = false;
  self.Results.EndRun();
  self.Progress = nullptr;
  const std::int64_t more = (self.Device.CountDispatches ? self.Device.CountDispatches() : 0) - dispatches;
  return (!isLost && self.Exchange->Gather(root, self.MakeResults(results, more), nobody)) ||
    self.OnConnectionLost();
}
}
