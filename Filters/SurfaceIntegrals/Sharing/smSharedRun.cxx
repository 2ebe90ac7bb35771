#include "smSharedRun.h"

namespace sm
{
bool SharedRun::Check(bool isConnected)
{
  if (!isConnected)
  {
    this->Lost = true;
    this->Next = Call::None;
  }
  return isConnected;
}

bool SharedRun::GatherCapabilities(const Bytes& mine, std::vector<Bytes>& all)
{
  this->Next = Call::Decide;
  return this->Check(this->Exchange->Gather(this->Root, mine, all));
}

bool SharedRun::Decide(bool& shares)
{
  RankNumbers numbers = { this->IsRoot() && shares ? 1.0 : 0.0 };
  const bool isConnected = this->Exchange->Sum(numbers);
  shares = numbers[0] != 0.0;
  this->Next = shares ? Call::ScatterShares : Call::None;
  return this->Check(isConnected);
}

bool SharedRun::ScatterShares(const std::vector<Bytes>& all, Bytes& mine)
{
  this->Next = Call::Agree;
  return this->Check(this->Exchange->Scatter(this->Root, all, mine));
}

bool SharedRun::Agree(Step& step)
{
  RankNumbers numbers = { step.IsStopped ? 1.0 : 0.0, step.IsTimedOut ? 1.0 : 0.0, step.IsBatch ? 1.0 : 0.0,
    step.Number };
  const bool isConnected = this->Exchange->Sum(numbers);
  step = { numbers[0] != 0.0, numbers[1] != 0.0, numbers[2] != 0.0, numbers[3] };
  if (step.IsStopped || (step.IsBatch && step.Number == 0.0))
  {
    this->Next = Call::GatherResults;
  }
  return this->Check(isConnected);
}

bool SharedRun::GatherResults(const Bytes& mine, std::vector<Bytes>& all)
{
  this->Next = Call::None;
  return this->Check(this->Exchange->Gather(this->Root, mine, all));
}

void SharedRun::Finish(const Bytes& failure) noexcept
{
  const Bytes nothing;
  std::vector<Bytes> dropped;
  Bytes share;
  while (this->IsOpen())
  {
    try
    {
      bool shares = false;
      Step step;
      step.IsStopped = this->IsRoot();
      switch (this->Next)
      {
        case Call::GatherCapabilities:
          this->GatherCapabilities(this->IsRoot() ? nothing : failure, dropped);
          break;
        case Call::Decide:
          this->Decide(shares);
          break;
        case Call::ScatterShares:
          this->ScatterShares(dropped, share);
          break;
        case Call::Agree:
          this->Agree(step);
          break;
        case Call::GatherResults:
          this->GatherResults(this->IsRoot() ? nothing : failure, dropped);
          break;
        case Call::None:
          break;
      }
    }
    catch (...)
    {
      // The call has been made, and nothing that it received is needed.
    }
  }
}
}
