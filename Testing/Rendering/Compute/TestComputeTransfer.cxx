// Uploads through mapped memory, as GPUs get them: every byte arrives, however large and many they are, and a
// dispatch that reads a buffer sees what it held when the dispatch was made.
#include "smComputeTesting.h"
#include "smContextResources.h"
#include "smTestSumCS.h"

#include <algorithm>
#include <cstdint>
#include <random>

using namespace smtest;

namespace
{
void TestBytes(vtkComputeContext* context)
{
  std::mt19937 random(5);
  sm::ComputeBuffer buffers[] = { sm::ComputeBuffer(context), sm::ComputeBuffer(context) };
  const std::size_t maximum = sm::TransferStage::MaximumBytes;
  std::vector<std::uint8_t> bytes(maximum + maximum / 2);
  std::generate(bytes.begin(), bytes.end(), random);
  bool isRight = true;
  int count = 0;
  for (const std::size_t size :
    { std::size_t{ 1 }, std::size_t{ 1000 }, maximum / 8, maximum, maximum + 1, bytes.size() })
  {
    for (int i = 0; i < 20; ++i, ++count)
    {
      // Parts of the memory are used many times, for two buffers in turn.
      const std::size_t part = size - (size > 100 ? random() % 100 : 0);
      const std::size_t from = random() % (bytes.size() - part + 1);
      const std::vector<std::uint8_t> sent(bytes.begin() + from, bytes.begin() + from + part);
      std::vector<std::uint8_t> received(part);
      sm::ComputeBuffer& buffer = buffers[i % 2];
      isRight = isRight && buffer.Upload(sent) && buffer.Read(received.data(), part) && received == sent;
    }
  }
  CheckTrue(
    std::to_string(count) + " uploads arrive", isRight, buffers[0].GetError() + buffers[1].GetError());
  // Values that are written in place.
  const sm::ContextScope scope(context);
  std::vector<std::uint32_t> received(70000);
  const auto fill = [&](std::uint32_t* values)
  {
    for (std::uint32_t i = 0; i < received.size(); ++i)
    {
      values[i] = 3 * i;
    }
  };
  CheckTrue("filled",
    buffers[0].Fill<std::uint32_t>(received.size(), fill) &&
      buffers[0].Read(received.data(), received.size() * sizeof(received[0])),
    buffers[0].GetError());
  std::size_t wrong = 0;
  for (std::uint32_t i = 0; i < received.size(); ++i)
  {
    wrong += received[i] == 3 * i ? 0 : 1;
  }
  CheckEqual("wrong values", 0, static_cast<long long>(wrong));
}

void TestOrder(vtkComputeContext* context)
{
  const sm::ContextScope scope(context);
  sm::ShaderSource source("smTestSumCS", smTestSumCS);
  sm::ComputeProgram program;
  CheckTrue("built", source.Assemble() && program.Build(context, source.GetName(), source.GetSource()),
    source.GetError() + program.GetError());
  constexpr unsigned int count = 20000;
  constexpr unsigned int invocations = 256;
  sm::ComputeBuffer input(context);
  sm::ComputeBuffer sums(context);
  std::vector<std::uint32_t> received(invocations);
  int wrong = 0;
  for (std::uint32_t round = 1; round <= 10; ++round)
  {
    const bool done = input.Upload(std::vector<std::uint32_t>(count, round)) &&
      sums.Allocate(invocations * sizeof(std::uint32_t)) && input.Bind(0) && sums.Bind(1) &&
      program.SetUniform("smCount", count) && program.Dispatch(invocations, 32) &&
      // What follows is not what the dispatch reads.
      input.Upload(std::vector<std::uint32_t>(count, 1000000u)) &&
      sums.Read(received.data(), received.size() * sizeof(received[0]));
    wrong += done &&
        std::all_of(received.begin(), received.end(), [&](std::uint32_t sum) { return sum == count * round; })
      ? 0
      : 1;
  }
  CheckEqual("dispatches that saw what came later", 0, wrong);
}

void TestTransfers(vtkComputeContext* context)
{
  for (const bool isFast : { true, false })
  {
    context->GetResources()->HasFastCopies = isFast;
    std::printf("--- %s\n", isFast ? "by the driver's functions" : "through mapped memory");
    TestBytes(context);
    if (!isFast || context->IsSoftware())
    {
      TestOrder(context);
    }
  }
}
}

int TestComputeTransfer(int, char*[])
{
  return RunInContext({ TestTransfers });
}
