#include "smControllerExchange.h"

#include "smFailureReason.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <array>
#include <new>

namespace sm
{
namespace
{
// MPI guarantees tags up to 32767 only.
constexpr int SizeTag = 22513;
constexpr int ContentTag = 22514;
// Size of the pieces of a message. A buffer of this size is on the stack.
constexpr std::size_t PieceSize = 32768;
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

bool ControllerExchange::Sum(RankNumbers& numbers)
{
  const RankNumbers mine = numbers;
  return this->Controller->AllReduce(
           mine.data(), numbers.data(), static_cast<vtkIdType>(mine.size()), vtkCommunicator::SUM_OP) != 0;
}

bool ControllerExchange::Send(int to, const Bytes& message)
{
  const auto size = static_cast<long long>(message.size());
  bool ok = this->Controller->Send(&size, 1, to, SizeTag) != 0;
  for (std::size_t at = 0; at < message.size() && ok; at += PieceSize)
  {
    const auto count = static_cast<vtkIdType>(std::min(PieceSize, message.size() - at));
    ok = this->Controller->Send(message.data() + at, count, to, ContentTag) != 0;
  }
  return ok;
}

bool ControllerExchange::Receive(int from, Bytes* message, bool& isDropped)
{
  long long length = 0;
  if (!this->Controller->Receive(&length, 1, from, SizeTag) || length < 0)
  {
    return false;
  }
  const auto size = static_cast<std::size_t>(length);
  const bool hasRoom = message && HasMemoryFor([&]() { message->resize(size); });
  isDropped = isDropped || !hasRoom;
  std::array<char, PieceSize> dropped;
  bool ok = true;
  for (std::size_t at = 0; at < size && ok; at += PieceSize)
  {
    const auto count = static_cast<vtkIdType>(std::min(PieceSize, size - at));
    ok = this->Controller->Receive(
           hasRoom ? message->data() + at : dropped.data(), count, from, ContentTag) != 0;
  }
  return ok;
}

bool ControllerExchange::Gather(int root, const Bytes& mine, std::vector<Bytes>& all)
{
  const int own = this->GetRank();
  if (own != root)
  {
    return this->Send(root, mine);
  }
  const int ranks = this->GetNumberOfRanks();
  const bool hasRoom = HasMemoryFor(
    [&]()
    {
      all.assign(static_cast<std::size_t>(ranks), Bytes());
      all[own] = mine;
    });
  bool isDropped = !hasRoom;
  bool ok = true;
  for (int rank = 0; rank < ranks && ok; ++rank)
  {
    ok = rank == own || this->Receive(rank, hasRoom ? &all[rank] : nullptr, isDropped);
  }
  if (ok && isDropped)
  {
    throw std::bad_alloc();
  }
  return ok;
}

bool ControllerExchange::Scatter(int root, const std::vector<Bytes>& all, Bytes& mine)
{
  const int own = this->GetRank();
  bool ok = true;
  if (own != root)
  {
    bool isDropped = false;
    ok = this->Receive(root, &mine, isDropped);
    if (ok && isDropped)
    {
      throw std::bad_alloc();
    }
    return ok;
  }
  const Bytes nothing;
  const auto getMessage = [&](int rank) -> const Bytes&
  { return static_cast<std::size_t>(rank) < all.size() ? all[rank] : nothing; };
  for (int rank = 0; rank < this->GetNumberOfRanks() && ok; ++rank)
  {
    ok = rank == own || this->Send(rank, getMessage(rank));
  }
  mine = getMessage(own);
  return ok;
}
}
