// Runs of the engine with several ranks: roles of the ranks, and the report.
#include "smIntegralEngine.h"

#include "Sharing/smFaceExchange.h"
#include "Sharing/smSharedStructure.h"
#include "smFailureReason.h"

namespace sm
{
namespace
{
/// Appends "+more" to a list such as "a+b", unless it already contains it.
void Join(std::string& all, const std::string& more, const std::string& separator)
{
  const std::string end = separator + more + separator;
  if (!more.empty() && (separator + all + separator).find(end) == std::string::npos)
  {
    all += (all.empty() ? "" : separator) + more;
  }
}
}

void IntegralEngine::SetController(vtkMultiProcessController* controller)
{
  // Allocated here and not in a run, which must not fail before its first collective call.
  this->Exchange = controller ? std::make_unique<ControllerExchange>(controller) : nullptr;
}

vtkMultiProcessController* IntegralEngine::GetController() const
{
  return this->Exchange ? this->Exchange->GetController() : nullptr;
}

bool IntegralEngine::IsSharedUpdate(int pieces) const
{
  // If the update has another number of pieces, it concerns this process alone, and other ranks may not take
  // part.
  return this->Exchange && pieces > 1 && this->Exchange->GetNumberOfRanks() == pieces;
}

void IntegralEngine::ShareStructure(int pieces, vtkPartitionedDataSetCollection* meshes)
{
  if (this->IsSharedUpdate(pieces) && !sm::ShareStructure(*this->Exchange, *meshes))
  {
    this->Report.Messages.push_back("the meshes are missing: a rank has not enough memory, or is lost");
  }
}

IntegralEngine::Role IntegralEngine::ChooseRole(bool canShare, int pieces, bool hasInput, bool hasBodies)
{
  if (!this->IsSharedUpdate(pieces))
  {
    return Role::Owner;
  }
  const int own = this->Exchange->GetRank();
  RankNumbers sums = { hasBodies ? 1.0 : 0.0, hasInput ? 1.0 : 0.0, hasBodies && canShare ? 1.0 : 0.0,
    hasBodies ? static_cast<double>(own) : 0.0, hasBodies && this->PrefersOpenGL ? 1.0 : 0.0 };
  if (!this->Exchange->Sum(sums))
  {
    this->Report.Messages.push_back("the connection to the other ranks was lost");
    return Role::Owner;
  }
  const int owners = static_cast<int>(sums[0]);
  const bool isAnyInput = sums[1] != 0.0;
  if (owners > 1 && hasBodies)
  {
    this->Report.Messages.push_back(std::to_string(owners) +
      " ranks have bodies: each integrates its own, and there is no sum of all. Read files on one rank.");
  }
  if (owners == 1)
  {
    const bool isShared = sums[2] != 0.0;
    if (isShared)
    {
      // A single rank has bodies: the sums are its number, and its choice of a backend, which all make so
      // that results have the same bits.
      this->PrefersOpenGL = sums[4] != 0.0;
      this->Integrator.BeginSharing(*this->Exchange, static_cast<int>(sums[3]));
    }
    return hasBodies ? Role::Owner : isShared ? Role::Worker : Role::Idle;
  }
  // Only one rank reports that there are no bodies.
  return hasInput || (!isAnyInput && own == 0) ? Role::Owner : Role::Idle;
}

void IntegralEngine::FinishSharing(const std::exception_ptr& failure) noexcept
{
  this->Integrator.FinishSharing(failure ? GetReason(failure) : "");
}

void IntegralEngine::RunAsWorker(const IntegralRequest& request, const IntegralLimits& limits)
{
  // The faces, and with them the weights, are those of another rank.
  this->MinimumWeight = 0.0;
  this->ChooseRunner(request, limits.Backend);
  this->Configure(request, limits);
  this->Integrator.SetDevice(this->GetDevice());
  const bool done = this->Integrator.RunAsWorker(limits.Progress);
  // The rank that has the faces reports what was computed here.
  RunReport own;
  own.Backend = this->Report.Backend;
  own.Renderer = this->Report.Renderer;
  this->Report = own;
  if (!done)
  {
    this->Report.Messages.push_back(this->Integrator.GetError());
  }
}

RankDevice IntegralEngine::GetDevice() const
{
  RankDevice device;
  device.Backend = this->Report.Backend;
  device.Renderer = this->Report.Renderer;
  device.Note = this->Report.FallbackReason;
  device.DisabledReason = this->Report.Backend != names::BackendNone ? ""
    : this->Report.Messages.empty()                                  ? "nothing can be computed"
                                                                     : this->Report.Messages.back();
  device.CountDispatches = [this]()
  { return static_cast<std::int64_t>(this->Context->GetNumberOfDispatches()); };
  return device;
}

void IntegralEngine::ReportRanks()
{
  const std::vector<RankReport>& ranks = this->Integrator.GetRanks();
  if (ranks.empty())
  {
    return;
  }
  this->Report.Ranks = 0;
  this->Report.Dispatches = 0;
  const std::string ownBackend = this->Report.Backend;
  const std::string ownRenderer = this->Report.Renderer;
  bool differs = false;
  for (std::size_t rank = 0; rank < ranks.size(); ++rank)
  {
    const RankReport& report = ranks[rank];
    const std::string who = "rank " + std::to_string(rank);
    this->Report.Dispatches += report.Dispatches;
    if (!report.FailureReason.empty())
    {
      this->Report.Messages.push_back(
        who + " integrated nothing, others did its share: " + report.FailureReason);
    }
    if (report.Faces == 0)
    {
      continue;
    }
    ++this->Report.Ranks;
    Join(this->Report.Backend, report.Backend, "+");
    Join(this->Report.Renderer, report.Renderer, " + ");
    differs = differs || report.Backend != ownBackend ||
      (report.Backend == names::BackendOpenGL && report.Renderer != ownRenderer);
    if (report.Backend != ownBackend && !report.Note.empty())
    {
      this->Report.Messages.push_back(who + " computed on the CPU, without OpenGL: " + report.Note);
    }
  }
  if (differs)
  {
    this->Report.Messages.push_back(
      "ranks computed with different devices: values are within their bounds, but "
      "may differ in rounding from those of one device");
  }
}
}
