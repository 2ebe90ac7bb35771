#include "smControllerExchange.h"

#include "vtkMultiProcessController.h"

namespace sm
{
namespace
{
constexpr int SizeTag = 551301;
constexpr int ContentTag = 551302;
}

ControllerExchange::ControllerExchange(vtkMultiProcessController* controller)
  : Controller(controller)
{
}

ControllerExchange::~ControllerExchange() = default;

int ControllerExchange::GetNumberOfRanks() const
{
  return this->Controller->GetNumberOfProcesses();
}

int ControllerExchange::GetRank() const
{
  return this->Controller->GetLocalProcessId();
}

bool ControllerExchange::Share(const std::vector<double>& mine, std::vector<double>& all)
{
  all.assign(mine.size() * static_cast<std::size_t>(this->GetNumberOfRanks()), 0.0);
  return this->Controller->AllGather(mine.data(), all.data(), static_cast<vtkIdType>(mine.size())) != 0;
}

bool ControllerExchange::Send(int to, const Bytes& message)
{
  const auto size = static_cast<long long>(message.size());
  return this->Controller->Send(&size, 1, to, SizeTag) != 0 &&
    (size == 0 || this->Controller->Send(message.data(), static_cast<vtkIdType>(size), to, ContentTag) != 0);
}

bool ControllerExchange::Receive(int from, Bytes& message)
{
  long long size = 0;
  if (!this->Controller->Receive(&size, 1, from, SizeTag) || size < 0)
  {
    return false;
  }
  message.resize(static_cast<std::size_t>(size));
  return size == 0 ||
    this->Controller->Receive(message.data(), static_cast<vtkIdType>(size), from, ContentTag) != 0;
}

bool ControllerExchange::Gather(int root, const Bytes& mine, std::vector<Bytes>& all)
{
  if (this->GetRank() != root)
  {
    return this->Send(root, mine);
  }
  all.assign(static_cast<std::size_t>(this->GetNumberOfRanks()), Bytes());
  bool ok = true;
  for (int rank = 0; rank < this->GetNumberOfRanks() && ok; ++rank)
  {
    if (rank == root)
    {
      all[rank] = mine;
    }
    else
    {
      ok = this->Receive(rank, all[rank]);
    }
  }
  return ok;
}

bool ControllerExchange::Scatter(int root, const std::vector<Bytes>& all, Bytes& mine)
{
  if (this->GetRank() != root)
  {
    return this->Receive(root, mine);
  }
  bool ok = true;
  for (int rank = 0; rank < this->GetNumberOfRanks() && ok; ++rank)
  {
    ok = rank == root || this->Send(rank, all[rank]);
  }
  mine = all[root];
  return ok;
}
}
