#include "smProbe.h"

#include "smComputeBuffer.h"
#include "smComputeProgram.h"
#include "smContextResources.h"
#include "smContextScope.h"
#include "smProbeArrayCS.h"
#include "smProbeCS.h"
#include "smShaderSource.h"
#include "vtkComputeContext.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <random>
#include <sstream>

namespace sm
{
namespace
{
constexpr double Epsilon = std::numeric_limits<double>::epsilon();
constexpr double Infinity = std::numeric_limits<double>::infinity();
/// Invocations of a probe, and operands of each.
constexpr int Lanes = 32;
constexpr int Operands = 8;
using Operand = std::array<double, Operands>;

/// A subnormal number, powers of two, infinity, a NaN, 3: as in glsl/smProbeCS.glsl.
const std::array<double, 6> Special = { 0x3p-1070, 0x1p-515, 0x1p100, Infinity,
  std::numeric_limits<double>::quiet_NaN(), 3.0 };

/// A construct, the right value for the operands, and the relative error that is allowed: 0 where the shaders
/// rely on every bit.
struct Construct
{
  const char* Name;
  double Allowed;
  double (*GetValue)(const Operand&);
  /// The value is, or comes from, a subnormal number, which GLSL lets a driver take for 0.
  bool MayBeZero = false;
};

double GetSumError(double a, double b)
{
  const double sum = a + b;
  const double part = sum - a;
  return (a - (sum - part)) + (b - part);
}

double SumProducts(const Operand& x)
{
  double sum = 0.0;
  for (int i = Operands - 1; i >= 0; --i)
  {
    sum += x[i] * (i + 1);
  }
  return sum;
}

double SumVectors(const Operand& x)
{
  double sum = 0.0;
  for (int i = 0; i < Operands - 3; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      sum += x[i + k] * (i + 1);
    }
  }
  return sum;
}

// Drivers for graphics cards make quotients and roots by iteration, some units in the last place off; in
// single precision they would be off by 1e-8. Products and sums of positive numbers may be fused. NVIDIA's
// compiler reads 0.1 one unit in the last place off.
const Construct Used[] = {
  { "a quotient", 8 * Epsilon, [](const Operand& x) { return x[0] / x[1]; } },
  { "a square root", 8 * Epsilon, [](const Operand& x) { return std::sqrt(x[1]); } },
  { "the length of a vector", 8 * Epsilon,
    [](const Operand& x) { return std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]); } },
  { "the rounding error of a sum", 0.0, [](const Operand& x) { return GetSumError(x[0], x[1]); } },
  { "the rounding error of a product", 0.0,
    [](const Operand& x) { return std::fma(x[0], x[1], -(x[0] * x[1])); } },
  { "a constant of double precision", 4 * Epsilon, [](const Operand& x) { return x[0] * 0.1; } },
  { "a conversion from int and float", 0.0, [](const Operand&) { return 8.0 + (1.5 + 8.0 * 0x1p-23); } },
  { "a double as two uints", 0.0, [](const Operand& x) { return x[0]; } },
  { "an array of doubles as uints", 4 * Epsilon, SumProducts },
  { "an array of vectors as uints", 8 * Epsilon, SumVectors },
  { "an array of doubles in shared memory", 4 * Epsilon, SumProducts },
  { "a subnormal operand", 0.0, [](const Operand&) { return Special[0] * Special[2]; }, true },
  { "a subnormal result", 0.0, [](const Operand& x) { return Special[1] * Special[1] * x[1]; }, true },
  { "a placement", 8 * Epsilon,
    [](const Operand& x) { return x[3] * x[0] + x[4] * x[1] + x[5] * x[2] + x[6]; } },
  { "a cross product", 8 * Epsilon, [](const Operand& x) { return x[4] * x[2] + x[5] * x[1]; } },
  { "a comparison with infinity and NaN", 0.0, [](const Operand&) { return 15.0; } },
  { "a maximum that keeps a NaN", 0.0, [](const Operand&) { return 1.0; } },
};
constexpr int UsedCount = static_cast<int>(std::size(Used));

/// The values of SM_FORM in glsl/smProbeArrayCS.glsl.
const char* const Unused[] = { "a local array of doubles", "a local array of dvec4",
  "an array of structures with a double", "the columns of a matrix of doubles", "a global array of doubles",
  "a constant array of doubles", "an array of doubles as an output parameter",
  "a copy of an array of doubles", "a component of a dvec3 assigned by an index" };

/// Numbers between 0.25 and 1.75 with all bits of a double.
std::vector<Operand> MakeOperands()
{
  std::mt19937_64 random(7);
  std::vector<Operand> operands(Lanes);
  for (Operand& lane : operands)
  {
    for (double& value : lane)
    {
      value = 0.25 + 1.5 * static_cast<double>(random() >> 11) * 0x1p-53;
    }
  }
  return operands;
}

/// Runs a program that has a result of `count` doubles for each lane.
bool RunProbe(vtkComputeContext* context, ShaderSource& source, const std::vector<Operand>& operands,
  int count, std::vector<double>& values, std::string& error)
{
  const std::uint64_t dispatches = context->GetResources()->Dispatches;
  const ContextScope scope(context);
  ComputeProgram program;
  ComputeBuffer buffers[] = { ComputeBuffer(context), ComputeBuffer(context), ComputeBuffer(context) };
  values.assign(static_cast<std::size_t>(Lanes) * count, 0.0);
  bool done = scope && source.Assemble() && program.Build(context, source.GetName(), source.GetSource()) &&
    buffers[0].Upload(operands) && buffers[1].Upload(Special.data(), sizeof(Special)) &&
    buffers[2].Allocate(values.size() * sizeof(double));
  for (unsigned int i = 0; i < 3 && done; ++i)
  {
    done = buffers[i].Bind(i);
  }
  if (done)
  {
    program.SetUniform("smValueCount", static_cast<unsigned int>(count));
    done = program.SetUniform("smCount", Operands) && program.Dispatch(Lanes, Lanes) &&
      buffers[2].Read(values.data(), values.size() * sizeof(double));
  }
  error = source.GetError() + program.GetError();
  for (const ComputeBuffer& buffer : buffers)
  {
    error += buffer.GetError();
  }
  context->GetResources()->Dispatches = dispatches;
  return done;
}

/// The largest relative error of the lanes.
double GetError(const std::vector<double>& values, int count, int index, const std::vector<Operand>& operands,
  double (*getValue)(const Operand&))
{
  double worst = 0.0;
  for (int lane = 0; lane < Lanes; ++lane)
  {
    const double expected = getValue(operands[lane]);
    const double difference = std::fabs(values[static_cast<std::size_t>(lane) * count + index] - expected);
    const double error = difference == 0.0 ? 0.0 : difference / std::fabs(expected);
    // The condition is written so that a NaN is infinite.
    worst = error <= worst ? worst : error < Infinity ? error : Infinity;
  }
  return worst;
}

/// True if a construct that may be 0 is 0 in all lanes.
bool IsFlushed(const std::vector<double>& values, int index)
{
  bool isZero = Used[index].MayBeZero;
  for (int lane = 0; lane < Lanes && isZero; ++lane)
  {
    isZero = values[static_cast<std::size_t>(lane) * UsedCount + index] == 0.0;
  }
  return isZero;
}

std::vector<ProbeResult> ProbeUsed(vtkComputeContext* context, std::string& error)
{
  const std::vector<Operand> operands = MakeOperands();
  ShaderSource source("smProbeCS", smProbeCS);
  std::vector<double> values;
  const bool done = RunProbe(context, source, operands, UsedCount, values, error);
  std::vector<ProbeResult> results;
  for (int i = 0; i < UsedCount; ++i)
  {
    const double worst = done ? GetError(values, UsedCount, i, operands, Used[i].GetValue) : Infinity;
    const bool isFlushed = done && IsFlushed(values, i);
    results.push_back({ Used[i].Name, true, worst <= Used[i].Allowed || isFlushed, isFlushed, worst });
  }
  return results;
}
}

bool ProbeConstructs(vtkComputeContext* context, bool& isFlushed, std::string& complaint)
{
  isFlushed = false;
  std::string error;
  const std::vector<ProbeResult> results = ProbeUsed(context, error);
  if (!error.empty())
  {
    complaint = "cannot run a compute shader with doubles: " + error;
    return false;
  }
  std::ostringstream text;
  for (const ProbeResult& result : results)
  {
    isFlushed = isFlushed || result.IsFlushed;
    if (!result.IsRight)
    {
      text << (text.tellp() > 0 ? ", " : "computes ") << result.Construct
           << " wrong, with a relative error of " << std::setprecision(2) << result.Error;
    }
  }
  complaint = text.str();
  return complaint.empty();
}

std::vector<ProbeResult> ProbeAllConstructs(vtkComputeContext* context)
{
  std::string error;
  std::vector<ProbeResult> results = ProbeUsed(context, error);
  const std::vector<Operand> operands = MakeOperands();
  for (int form = 0; form < static_cast<int>(std::size(Unused)); ++form)
  {
    ShaderSource source("smProbeArrayCS", smProbeArrayCS);
    source.Define("SM_FORM", form);
    source.SetUnchecked();
    std::vector<double> values;
    const bool done = RunProbe(context, source, operands, 1, values, error);
    const double worst = done ? GetError(values, 1, 0, operands, SumProducts) : Infinity;
    results.push_back({ Unused[form], false, worst <= 8 * Epsilon, false, worst });
  }
  return results;
}
}
