// Programs and buffers: messages, limits, failures, moves, and what is alive.
#include "smComputeTesting.h"
#include "smTestBrokenCS.h"

#include "vtkOpenGLRenderWindow.h"

#include <limits>
#include <utility>

using namespace smtest;

namespace
{
void CheckContains(const std::string& what, const std::string& text, const std::string& clue)
{
  CheckTrue(what, text.find(clue) != std::string::npos, clue);
}

void TestBrokenShader(vtkComputeContext* context)
{
  sm::ShaderSource source("smTestBrokenCS", smTestBrokenCS);
  CheckTrue("assembles", source.Assemble());
  sm::ComputeProgram program;
  CheckTrue("a broken shader fails", !program.Build(context, "smTestBrokenCS", source.GetSource()));
  std::printf("%s\n", program.GetError().c_str());
  CheckContains("the error has the name", program.GetError(), "smTestBrokenCS: does not compile");
  CheckContains("the error has the driver's log", program.GetError(), "undeclared");
  CheckContains("the error has the numbered source", program.GetError(), "    5 |   undeclared = 1.0LF;");
  CheckTrue("it is not built", !program.IsBuilt());
  CheckTrue("and can be built after that", BuildIndexProgram(context, program, 64), program.GetError());
  CheckTrue("now it is built", program.IsBuilt());
}

void TestUniformsAndDispatch(vtkComputeContext* context)
{
  sm::ComputeProgram program;
  CheckTrue("builds", BuildIndexProgram(context, program, 64));
  CheckTrue("no uniform outside a scope", !program.SetUniform("smStep", 1.0));
  CheckTrue("no dispatch outside a scope", !program.Dispatch(1, 64));
  const sm::ContextScope scope(context);
  CheckTrue("uniform", program.SetUniform("smStep", 1.0), program.GetError());
  CheckTrue("no such uniform", !program.SetUniform("smNone", 1.0));
  CheckContains("its name", program.GetError(), "smNone");
  CheckTrue("a uniform of another type", !program.SetUniform("smStep", 1));
  CheckContains("its name", program.GetError(), "smStep");
  CheckTrue("a wrong local size", !program.Dispatch(1, 32));
  CheckContains("both sizes", program.GetError(), "64");
  const auto dispatches = context->GetNumberOfDispatches();
  CheckTrue("nothing to do", program.Dispatch(0, 64));
  CheckTrue("is not counted as a dispatch", context->GetNumberOfDispatches() == dispatches);
  CheckTrue("too many invocations", !program.Dispatch(std::numeric_limits<unsigned int>::max(), 64));
}

/// A program keeps its uniforms between dispatches, and is built again without them.
void TestUniformValues(vtkComputeContext* context)
{
  const sm::ContextScope scope(context);
  sm::ComputeProgram program;
  sm::ComputeBuffer buffer(context);
  double value = 0.0;
  CheckTrue("a value", buffer.Upload(&value, sizeof(value)), buffer.GetError());
  double sum = 0.0;
  for (const int isBuiltAgain : { 0, 1 })
  {
    CheckTrue("builds", BuildIndexProgram(context, program, 64));
    CheckTrue("count", program.SetUniform("smCount", 1u) && buffer.Bind(0));
    for (const double step : { 1.0, 1.0, 4.0, 4.0, 1.0 })
    {
      CheckTrue("step", program.SetUniform("smStep", step) && program.Dispatch(1, 64), program.GetError());
      CheckTrue("reads", buffer.Read(&value, sizeof(value)), buffer.GetError());
      sum += step;
      CheckEqual(isBuiltAgain ? "sum after the second build" : "sum", sum, value);
    }
  }
}

void TestManyGroups(vtkComputeContext* context)
{
  // More groups than one axis has, and a count that does not fill the rectangle.
  const unsigned int limit = static_cast<unsigned int>(context->GetMaximumWorkGroupCount());
  const unsigned int maximum = 70001;
  std::string detail;
  CheckTrue(
    "one group more than an axis has", limit > 1000000 || Compute(context, limit + 1, 1, detail), detail);
  const bool computed = Compute(context, maximum, 1, detail);
  CheckTrue("70001 groups", computed, detail);
}

void TestBuffers(vtkComputeContext* context)
{
  const long before = sm::ComputeBuffer::GetLiveCount();
  {
    sm::ComputeBuffer buffer(context);
    CheckEqual("a new buffer has no store", before, sm::ComputeBuffer::GetLiveCount());
    const std::vector<double> values = { 1.0, 2.0, 3.0 };
    CheckTrue("uploads outside a scope", buffer.Upload(values), buffer.GetError());
    CheckEqual("size", 24, static_cast<long long>(buffer.GetSize()));
    CheckEqual("one store", before + 1, sm::ComputeBuffer::GetLiveCount());
    double read[3] = { 0.0, 0.0, 0.0 };
    const double five = 5.0;
    CheckTrue("uploads a part", buffer.Upload(&five, sizeof(five), sizeof(double)));
    CheckTrue("reads", buffer.Read(read, sizeof(read)));
    CheckTrue("what was written", read[0] == 1.0 && read[1] == 5.0 && read[2] == 3.0);
    CheckTrue("reads a part", buffer.Read(read, sizeof(double), 2 * sizeof(double)) && read[0] == 3.0);
    CheckTrue("no read beyond the end", !buffer.Read(read, 24, 8));
    CheckTrue("no upload beyond the end", !buffer.Upload(read, 24, 8));
    CheckTrue("clears", buffer.Clear() && buffer.Read(read, sizeof(read)));
    CheckTrue("zeros", read[0] == 0.0 && read[1] == 0.0 && read[2] == 0.0);
    CheckTrue("no binding outside a scope", !buffer.Bind(0));

    sm::ComputeBuffer moved = std::move(buffer);
    CheckEqual("moved, still one store", before + 1, sm::ComputeBuffer::GetLiveCount());
    CheckEqual("moved size", 24, static_cast<long long>(moved.GetSize()));
    buffer = sm::ComputeBuffer(context);
    CheckTrue("the moved-from one can be used again", buffer.Allocate(8), buffer.GetError());
    CheckEqual("two stores", before + 2, sm::ComputeBuffer::GetLiveCount());

    const sm::ContextScope scope(context);
    CheckTrue("no misaligned binding", context->GetStorageOffsetAlignment() == 1 || !moved.Bind(0, 1));
    CheckTrue("no binding beyond the end", !moved.Bind(0, 0, 32));
    sm::ComputeBuffer empty(context);
    CheckTrue("an empty vector", empty.Upload(std::vector<double>()) && empty.GetSize() == 0);
    CheckTrue("an empty buffer binds", empty.Bind(0), empty.GetError());
    CheckEqual("its size is 0", 0, static_cast<long long>(empty.GetSize()));

    // More than any machine has.
    CheckTrue("too large a buffer fails", !empty.Allocate(std::size_t(1) << 46));
    CheckTrue("with a message", !empty.GetError().empty(), empty.GetError());
    CheckTrue("and can be used again", empty.Allocate(64), empty.GetError());
    sm::ComputeBuffer nowhere;
    CheckTrue("no context", !nowhere.Allocate(16) && !nowhere.Bind(0));
  }
  CheckEqual("all stores are freed", before, sm::ComputeBuffer::GetLiveCount());
}

/// The counters of the context follow the stores; a store that is too large for its uses is replaced by a
/// smaller one.
void TestMemory(vtkComputeContext* context)
{
  constexpr long long large = 1 << 20;
  constexpr long long small = 1 << 17;
  const long long before = context->GetAllocatedBytes();
  {
    sm::ComputeBuffer buffer(context);
    sm::ComputeBuffer other(context);
    CheckTrue("allocates", buffer.Allocate(large) && other.Allocate(100));
    CheckEqual("allocated bytes", before + large + 100, context->GetAllocatedBytes());
    for (int use = 1; use < sm::ComputeBuffer::UsesBeforeShrinking; ++use)
    {
      CheckTrue("a small use", buffer.Allocate(small));
    }
    CheckEqual("a few small uses keep the store", large, static_cast<long long>(buffer.GetCapacity()));
    CheckTrue("a large use", buffer.Allocate(large / 2));
    for (int use = 1; use < sm::ComputeBuffer::UsesBeforeShrinking; ++use)
    {
      CheckTrue("a small use", buffer.Allocate(small + use));
    }
    CheckEqual("and they are counted anew", large, static_cast<long long>(buffer.GetCapacity()));
    CheckTrue("one more", buffer.Allocate(1000), buffer.GetError());
    const long long shrunk = small + sm::ComputeBuffer::UsesBeforeShrinking - 1;
    CheckEqual(
      "the store shrinks to the largest of them", shrunk, static_cast<long long>(buffer.GetCapacity()));
    CheckEqual("its size", 1000, static_cast<long long>(buffer.GetSize()));
    CheckEqual("allocated bytes after it", before + shrunk + 100, context->GetAllocatedBytes());
    CheckTrue("peak", context->GetPeakAllocatedBytes() >= before + large + 100);
    double value = 3.0;
    CheckTrue(
      "it holds data", buffer.Upload(&value, sizeof(value), 8) && buffer.Read(&value, sizeof(value), 8));
    buffer.Free();
    CheckEqual("freed", before + 100, context->GetAllocatedBytes());
    vtkNew<vtkComputeContext> same;
    same->SetSource(vtkComputeContext::WINDOW);
    same->SetWindow(context->GetRenderWindow());
    CheckEqual("another context of the window", vtkComputeContext::READY, same->Start());
    CheckEqual("reports the same bytes", before + 100, same->GetAllocatedBytes());
  }
  CheckEqual("everything is released", 0, context->GetAllocatedBytes());
}

void TestLargeBlock(vtkComputeContext* context)
{
  const std::size_t limit = static_cast<std::size_t>(context->GetMaximumStorageBlockSize());
  if (limit > std::size_t(1) << 28)
  {
    return;
  }
  const sm::ContextScope scope(context);
  sm::ComputeBuffer buffer(context);
  CheckTrue("a buffer larger than a block", buffer.Allocate(limit + 1024), buffer.GetError());
  CheckTrue("does not bind as a whole", !buffer.Bind(0));
  CheckTrue("binds in parts", buffer.Bind(0, 1024), buffer.GetError());
}
}

int TestComputeProgram(int, char*[])
{
  return RunInContext({ TestBrokenShader, TestUniformsAndDispatch, TestUniformValues, TestManyGroups,
    TestBuffers, TestMemory, TestLargeBlock });
}
