// vtkSurfaceIntegralGPU on several ranks.
#include "vtkSurfaceIntegralGPU.h"

#include "Sharing/smFaceExchange.h"
#include "vtkSurfaceIntegralGPUInternals.h"

#include <algorithm>

namespace
{
/// "a+b": what stands in front first, everything once.
void Join(std::string& all, const std::string& more, const std::string& separator)
{
  const std::string end = separator + more + separator;
  if (!more.empty() && (separator + all + separator).find(end) == std::string::npos)
  {
    all += (all.empty() ? "" : separator) + more;
  }
}
}

void vtkSurfaceIntegralGPU::SetController(vtkMultiProcessController* controller)
{
  if (this->Implementation->Controller != controller)
  {
    this->Implementation->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkSurfaceIntegralGPU::GetController()
{
  return this->Implementation->Controller;
}

int vtkSurfaceIntegralGPU::GetNumberOfRanks() const
{
  return this->Implementation->Last.Ranks;
}

vtkSurfaceIntegralGPU::Internals::Role vtkSurfaceIntegralGPU::Internals::ChooseRole(
  bool canShare, int pieces, bool hasInput, bool hasBodies, int& root)
{
  this->Exchange = nullptr;
  // One that asks for another number of pieces is updated for itself, and others need not be.
  if (!this->Controller || this->Controller->GetNumberOfProcesses() < 2 ||
    this->Controller->GetNumberOfProcesses() != pieces)
  {
    return Role::Owner;
  }
  auto exchange = std::make_unique<sm::ControllerExchange>(this->Controller);
  std::vector<double> all;
  if (!exchange->Share({ hasBodies ? 1.0 : 0.0, hasInput ? 1.0 : 0.0, canShare ? 1.0 : 0.0 }, all))
  {
    this->Last.Messages.push_back("the connection to the other ranks was lost");
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
    this->Last.Messages.push_back(std::to_string(owners) +
      " ranks have bodies: each integrates its own, and there is no sum of all. Read files on one rank.");
  }
  if (owners == 1)
  {
    const bool isOwner = root == exchange->GetRank();
    const bool shares = all[3 * root + 2] != 0.0;
    this->Exchange = shares ? std::move(exchange) : nullptr;
    return isOwner ? Role::Owner : shares ? Role::Worker : Role::Idle;
  }
  // That there is nothing is said once.
  return hasInput || (inputs == 0 && exchange->GetRank() == 0) ? Role::Owner : Role::Idle;
}

sm::RankDevice vtkSurfaceIntegralGPU::Internals::GetDevice() const
{
  sm::RankDevice device;
  device.Backend = this->Last.Backend;
  device.Renderer = this->Last.Renderer;
  device.Note = this->Last.FallbackReason;
  device.DisabledReason = this->Last.Backend != sm::names::BackendNone ? ""
    : this->Last.Messages.empty()                                      ? "nothing can be computed"
                                                                       : this->Last.Messages.back();
  device.CountDispatches = [this]()
  { return static_cast<std::int64_t>(this->Context->GetNumberOfDispatches()); };
  return device;
}

void vtkSurfaceIntegralGPU::Internals::RunAsWorker(vtkSurfaceIntegralGPU* self, int root)
{
  this->ChooseRunner(self);
  this->Integrator.SetExchange(this->Exchange.get(), this->GetDevice());
  this->Configure(self);
  const bool helped = this->Integrator.RunAsWorker(root,
    [self](double fraction)
    {
      self->UpdateProgress(fraction);
      return !self->GetAbortExecute();
    });
  this->Integrator.SetExchange(nullptr, {});
  this->Exchange = nullptr;
  // What was computed here is told by the rank that has the faces.
  const Run last = std::move(this->Last);
  this->Last = Run();
  this->Last.Backend = last.Backend;
  this->Last.Renderer = last.Renderer;
  if (!helped)
  {
    this->Last.Messages.push_back(this->Integrator.GetError());
  }
}

void vtkSurfaceIntegralGPU::Internals::ReportRanks()
{
  Run& last = this->Last;
  const std::vector<sm::RankReport>& ranks = this->Integrator.GetRanks();
  if (ranks.empty())
  {
    return;
  }
  last.Ranks = 0;
  last.Dispatches = 0;
  const std::string ownBackend = last.Backend;
  const std::string ownRenderer = last.Renderer;
  bool differs = false;
  for (std::size_t rank = 0; rank < ranks.size(); ++rank)
  {
    const sm::RankReport& report = ranks[rank];
    const std::string who = "rank " + std::to_string(rank);
    last.Dispatches += report.Dispatches;
    if (!report.FailureReason.empty())
    {
      last.Messages.push_back(who + " integrated nothing, others did its share: " + report.FailureReason);
    }
    if (report.Faces == 0)
    {
      continue;
    }
    ++last.Ranks;
    Join(last.Backend, report.Backend, "+");
    Join(last.Renderer, report.Renderer, " + ");
    differs = differs || report.Backend != ownBackend ||
      (report.Backend == sm::names::BackendOpenGL && report.Renderer != ownRenderer);
    if (report.Backend != ownBackend && !report.Note.empty())
    {
      last.Messages.push_back(who + " computed on the CPU, without OpenGL: " + report.Note);
    }
  }
  if (differs)
  {
    last.Messages.push_back("ranks computed with different devices: values are within their bounds, but not "
                            "the bits of one device");
  }
}
