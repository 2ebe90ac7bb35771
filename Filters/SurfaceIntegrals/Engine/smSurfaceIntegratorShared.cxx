// Sharing of faces among ranks. A shared run is a fixed sequence of collective calls (smSharedRun.h): all
// ranks send their capabilities to the root and receive their shares; they agree once after cutting, once for
// every plan of the orders, once when the faces are acquired, and once after every batch, until some rank is
// stopped or none has any batch left; then they send their results to the root. A rank that fails leaves the
// sequence, and FinishSharing() completes it.
#include "Sharing/smIntegralBytes.h"
#include "smFailureReason.h"
#include "smSurfaceIntegratorInternals.h"

#include "vtkTimerLog.h"

#include <algorithm>
#include <limits>
#include <new>
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

/// Reads the reason for a failure, with which the messages of the ranks begin. A message without bytes is
/// that of a rank without memory for one.
std::string GetFailure(const Bytes& message, ByteReader& from)
{
  return message.empty() ? InsufficientMemory : from.GetText();
}

/// Header of the root's message to a rank, before the faces.
struct ShareHeader
{
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
  this->Error = "the connection to the other ranks was lost";
  return false;
}

bool SurfaceIntegrator::Internals::Agree(double& number, bool isBatch)
{
  if (!this->Sharing.HasSteps())
  {
    return !this->Aborted;
  }
  SharedRun::Step step{ this->Aborted, this->TimedOut, isBatch, number };
  if (!this->Sharing.Agree(step))
  {
    return this->OnConnectionLost();
  }
  this->Aborted = this->Aborted || step.IsStopped;
  this->TimedOut = this->TimedOut || step.IsTimedOut;
  number = step.Number;
  return !this->Aborted || this->Fail("aborted");
}

Bytes SurfaceIntegrator::Internals::MakeCapabilities()
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
  message.Put(this->Received.FindSession(this->Sharing.GetRoot()));
  return std::move(message.GetBytes());
}

std::vector<bool> SurfaceIntegrator::Internals::ReadCapabilities(const std::vector<Bytes>& capabilities)
{
  const int root = this->Sharing.GetRoot();
  std::vector<std::pair<std::uint64_t, std::string>> signatures;
  for (const Bytes& message : capabilities)
  {
    ByteReader from(message);
    RankReport report;
    report.FailureReason = GetFailure(message, from);
    report.Backend = from.GetText();
    report.Renderer = from.GetText();
    report.Note = from.GetText();
    const auto digest = from.Get<std::uint64_t>();
    signatures.emplace_back(digest, from.GetText());
    if (from.Get<std::uint64_t>() != this->Shares.GetSession())
    {
      this->Shares.ForgetSent(static_cast<int>(this->Ranks.size()));
    }
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

std::vector<Bytes> SurfaceIntegrator::Internals::PackShares(
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
  const int root = this->Sharing.GetRoot();
  std::vector<Bytes> messages(shares.size());
  for (std::size_t rank = 0; rank < shares.size(); ++rank)
  {
    ShareHeader header;
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
  return messages;
}

bool SurfaceIntegrator::Internals::ReadResults(const Bytes& message, const std::vector<std::size_t>& share,
  RankReport& report, std::vector<FaceIntegrals>& results)
{
  ByteReader from(message);
  const std::string failure = GetFailure(message, from);
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
  std::vector<Bytes> messages;
  if (!this->Sharing.GatherCapabilities(this->MakeCapabilities(), messages))
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
  messages = this->PackShares(tasks, shares);
  bool isShared = true;
  Bytes own;
  if (!this->Sharing.Decide(isShared) || !this->Sharing.ScatterShares(messages, own))
  {
    return this->OnConnectionLost();
  }
  std::vector<std::size_t> left;
  const bool ran = this->GatherResults(tasks, shares, results, left);
  this->Shares.EndRun();
  if (!left.empty())
  {
    // A rank that failed may have lost the faces that it was sent.
    this->Shares.Forget();
  }
  return ran && (left.empty() || this->RecomputeLocally(tasks, left, results));
}

bool SurfaceIntegrator::Internals::GatherResults(const std::vector<FaceTask>& tasks,
  const std::vector<std::vector<std::size_t>>& shares, std::vector<FaceIntegrals>& results,
  std::vector<std::size_t>& left)
{
  const int root = this->Sharing.GetRoot();
  std::vector<FaceTask> own;
  for (const std::size_t i : shares[root])
  {
    own.push_back(tasks[i]);
  }
  std::vector<FaceIntegrals> ownResults;
  const std::int64_t dispatches = this->CountDispatches();
  const bool ran = this->Run(own, ownResults);
  if (this->Sharing.HasSteps())
  {
    // This rank failed before the others had completed their steps.
    return false;
  }
  std::vector<Bytes> messages;
  if (this->Sharing.IsLost() || !this->Sharing.GatherResults(Bytes(), messages))
  {
    return this->OnConnectionLost();
  }
  RankReport& report = this->Ranks[root];
  report.Faces = own.size();
  report.Evaluations = this->Evaluations;
  report.Dispatches = this->CountDispatches() - dispatches;
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    results[shares[root][i]] = std::move(ownResults[i]);
  }
  for (std::size_t rank = 0; rank < shares.size(); ++rank)
  {
    if (static_cast<int>(rank) != root &&
      !this->ReadResults(messages[rank], shares[rank], this->Ranks[rank], results))
    {
      left.insert(left.end(), shares[rank].begin(), shares[rank].end());
    }
  }
  return ran;
}

Bytes SurfaceIntegrator::Internals::MakeResults(
  const std::string& failure, const std::vector<FaceIntegrals>& results, std::int64_t dispatches) const
{
  ByteWriter to;
  to.PutText(failure);
  to.Put(this->Evaluations);
  to.Put(dispatches);
  to.Put(static_cast<std::uint64_t>(results.size()));
  for (const FaceIntegrals& result : results)
  {
    PutIntegrals(to, result);
  }
  return std::move(to.GetBytes());
}

void SurfaceIntegrator::SetDevice(const RankDevice& device)
{
  this->Implementation->Device = device;
}

void SurfaceIntegrator::BeginSharing(FaceExchange& exchange, int root)
{
  this->Implementation->Sharing = exchange.GetNumberOfRanks() > 1 ? SharedRun(exchange, root) : SharedRun();
}

void SurfaceIntegrator::FinishSharing(const char* failure) noexcept
{
  Bytes message;
  try
  {
    ByteWriter to;
    to.PutText(failure);
    message = std::move(to.GetBytes());
  }
  catch (const std::bad_alloc&)
  {
    // A message without bytes says the same.
  }
  this->Implementation->Sharing.Finish(message);
}

const std::vector<RankReport>& SurfaceIntegrator::GetRanks() const
{
  return this->Implementation->Ranks;
}

bool SurfaceIntegrator::RunAsWorker(const ProgressCallback& progress)
{
  Internals& self = *this->Implementation;
  if (!self.Sharing.IsOpen())
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
  bool isShared = false;
  bool ok = self.Sharing.GatherCapabilities(self.MakeCapabilities(), nobody) && self.Sharing.Decide(isShared);
  ok = ok && (!isShared || (self.Sharing.ScatterShares(nobody, message) && self.RunShare(message)));
  self.Progress = nullptr;
  return ok || self.OnConnectionLost();
}

bool SurfaceIntegrator::Internals::RunShare(const Bytes& message)
{
  ByteReader from(message);
  const auto header = from.Get<ShareHeader>();
  this->Start = vtkTimerLog::GetUniversalTime();
  this->Seconds = header.Seconds;
  this->RunMaximum = header.RunMaximum;
  this->Allowance = header.Allowance;
  std::vector<FaceTask> tasks;
  if (!this->Received.Unpack(this->Sharing.GetRoot(), from, tasks))
  {
    this->Sharing.Finish(this->MakeResults("the faces did not arrive", {}, 0));
    return !this->Sharing.IsLost();
  }
  if (this->Planned != header.Planned)
  {
    // A rank that cannot compute the same integrands has an empty share, so that its own configuration does
    // not matter.
    this->Planned = header.Planned;
    this->Configured = false;
  }
  std::vector<FaceIntegrals> results;
  const std::int64_t before = this->CountDispatches();
  this->Run(tasks, results);
  this->Results.EndRun();
  const std::int64_t dispatches = this->CountDispatches() - before;
  if (this->Sharing.HasSteps())
  {
    // This rank failed before the others had completed their steps; they compute its share.
    this->Sharing.Finish(this->MakeResults(this->Error, {}, dispatches));
    return !this->Sharing.IsLost();
  }
  std::vector<Bytes> nobody;
  return !this->Sharing.IsLost() &&
    this->Sharing.GatherResults(this->MakeResults("", results, dispatches), nobody);
}
}
