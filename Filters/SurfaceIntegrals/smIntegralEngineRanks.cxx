// Runs of the engine with several ranks: roles of the ranks, and the report.
#include "smIntegralEngine.h"

#include "Sharing/smFaceExchange.h"

#include <algorithm>

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

IntegralEngine::Role IntegralEngine::ChooseRole(
  bool canShare, int pieces, bool hasInput, bool hasBodies, int& root)
{
  this->Exchange = nullptr;
  // If the update has another number of pieces, it concerns this process alone, and other ranks may not take part.
  if (!this->Controller || this->Controller->GetNumberOfProcesses() < 2 ||
    this->Controller->GetNumberOfProcesses() != pieces)
  {
    return Role::Owner;
  }
  auto exchange = std::make_unique<ControllerExchange>(this->Controller);
  std::vector<double> all;
  if (!exchange->Share({ hasBodies ? 1.0 : 0.0, hasInput ? 1.0 : 0.0, canShare ? 1.0 : 0.0 }, all))
  {
    this->Report.Messages.push_back("the connection to the other ranks was lost");
    return Role::Owner;
  }
  int owners = 0;
  int inputs = 0;
  for (int rank = exchange->GetNumberOfRanks() - 1; rank >= 0; --rank)
  {
    owners += all[3 * rank] != 0.0 ? 1 : 0;
    inputs += all[3 * rank + 1] != 0.0 ? 1 : 0;
    root = all[3 * rank] != 0.0 ? rank : root;
  }
  if (owners > 1 && hasBodies)
  {
    this->Report.Messages.push_back(std::to_string(owners) +
      " ranks have bodies: each integrates its own, and there is no sum of all. Read files on one rank.");
  }
  if (owners == 1)
  {
    const bool isOwner = root == exchange->GetRank();
    const bool shares = all[3 * root + 2] != 0.0;
    this->Exchange = shares ? std::move(exchange) : nullptr;
    return isOwner ? Role::Owner : shares ? Role::Worker : Role::Idle;
  }
  // Only one rank reports that there are no bodies.
  return hasInput || (inputs == 0 && exchange->GetRank() == 0) ? Role::Owner : Role::Idle;
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
