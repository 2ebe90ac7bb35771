/**
 * @file smComputeTesting.h
 * @brief Helpers of the tests of Rendering/Compute
 */
#ifndef smComputeTesting_h
#define smComputeTesting_h

#include "smTesting.h"

#include "smComputeBuffer.h"
#include "smComputeProgram.h"
#include "smContextScope.h"
#include "smShaderSource.h"
#include "smTestIndexCS.h"
#include "vtkComputeContext.h"

#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkStringOutputWindow.h"

#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

namespace smtest
{
/// Collects what VTK prints; the tests expect silence.
class Silence
{
public:
  Silence() { vtkOutputWindow::SetInstance(this->Window); }
  ~Silence()
  {
    CheckEqual("VTK's output", "", this->Window->GetOutput());
    vtkOutputWindow::SetInstance(nullptr);
  }

private:
  vtkNew<vtkStringOutputWindow> Window;
};

/// Builds the kernel that adds step * (i + 1) to value i.
inline bool BuildIndexProgram(vtkComputeContext* context, sm::ComputeProgram& program, int localSize)
{
  sm::ShaderSource source("smTestIndexCS", smTestIndexCS);
  source.Define("LOCAL_SIZE", localSize);
  const bool built = source.Assemble() && program.Build(context, source.GetName(), source.GetSource());
  if (!built)
  {
    std::printf("%s%s\n", source.GetError().c_str(), program.GetError().c_str());
  }
  return built;
}

/// Runs the kernel over `count` values and compares every one; small integers are exact.
inline bool Compute(vtkComputeContext* context, unsigned int count, int localSize, std::string& detail)
{
  const sm::ContextScope scope(context);
  sm::ComputeProgram program;
  sm::ComputeBuffer buffer(context);
  std::vector<double> values(count, 0.5);
  if (!scope || !BuildIndexProgram(context, program, localSize) || !buffer.Upload(values) ||
    !buffer.Bind(0) || !program.SetUniform("smCount", count) || !program.SetUniform("smStep", 2.0) ||
    !program.Dispatch(count, static_cast<unsigned int>(localSize)) ||
    !buffer.Read(values.data(), count * sizeof(double)))
  {
    detail = program.GetError() + buffer.GetError();
    return false;
  }
  for (unsigned int i = 0; i < count; ++i)
  {
    if (values[i] != 0.5 + 2.0 * (i + 1.0))
    {
      detail = "value " + std::to_string(i) + " is " + std::to_string(values[i]);
      return false;
    }
  }
  return true;
}

inline void CheckComputes(const std::string& what, vtkComputeContext* context)
{
  std::string detail;
  const bool computed = Compute(context, 1000, 64, detail);
  CheckTrue(what, computed, detail);
}

/// Nothing of ours is left on any GPU.
inline void CheckNothingLives()
{
  CheckEqual("live buffers", 0, sm::ComputeBuffer::GetLiveCount());
  CheckEqual("live bytes", 0, sm::ComputeBuffer::GetLiveBytes());
  CheckEqual("live programs", 0, sm::ComputeProgram::GetLiveCount());
}

/// Runs tests in one context of their own, and checks that nothing is left of it. Returns the program's exit
/// status.
inline int RunInContext(std::initializer_list<void (*)(vtkComputeContext*)> tests)
{
  {
    const Silence silence;
    vtkNew<vtkComputeContext> context;
    if (!CheckEqual("status", vtkComputeContext::READY, context->Start()))
    {
      std::printf("%s\n", context->GetReason().c_str());
      return Finish();
    }
    std::printf("%s, %s\n", context->GetRenderer().c_str(), context->GetSourceName().c_str());
    for (const auto test : tests)
    {
      test(context);
    }
    CheckNothingLives();
  }
  return Finish();
}
}

#endif
