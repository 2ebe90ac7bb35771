#include "Detail/smVariantDevice.h"

#include "Detail/smVariantNumbers.h"
#include "smBernstein.h"
#include "smComputeBuffer.h"
#include "smComputeProgram.h"
#include "smContextScope.h"
#include "smShaderSource.h"
#include "smUnitRoundoff.h"
#include "smVariantBoundsCS.h"
#include "smVariantFlux.h"
#include "smVariantPanelsCS.h"
#include "smVariantResultsCS.h"
#include "smVariantStorage.h"
#include "smVariantStripsCS.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
// Variants of a batch of a software renderer, and work of a dispatch: some 50 ms on two CPU cores.
constexpr std::size_t SoftwareBatch = 1024;
constexpr std::uint64_t SoftwareWork = 400000000;

struct GroupProgram
{
  const DeviceGroup* Group = nullptr;
  ComputeProgram Program;
};

ShaderSource MakeSource(const DeviceGroup& group)
{
  const bool isStrip = group.Step == DeviceStep::Ribbons || group.Step == DeviceStep::Caps;
  ShaderSource source = group.Step == DeviceStep::Panels
    ? ShaderSource("smVariantPanelsCS", smVariantPanelsCS)
    : isStrip ? ShaderSource("smVariantStripsCS", smVariantStripsCS)
              : ShaderSource("smVariantBoundsCS", smVariantBoundsCS);
  source.AddChunk("smVariantStorage", smVariantStorage);
  source.AddChunk("smVariantFlux", smVariantFlux);
  if (isStrip)
  {
    source.Define("SM_CAPS", group.Step == DeviceStep::Caps ? 1 : 0);
  }
  else if (group.Step == DeviceStep::Panels && !group.IsNetInBuffer)
  {
    source.Define("SM_DEGREE_S", group.Degree[0]);
    source.Define("SM_DEGREE_R", group.Degree[1]);
    source.Define("SM_ROW_SIZE", group.Degree[0] + 1);
  }
  else if (group.Step == DeviceStep::Panels)
  {
    source.Define("SM_NET_IN_BUFFER", 1);
    source.Define("SM_ROW_SIZE", MaximumDegree + 1);
  }
  return source;
}
}

struct VariantDevice::Internals
{
  Internals(vtkComputeContext* context, DevicePoints points, std::size_t directions)
    : Context(context)
    , Points(std::move(points))
    , Directions(directions)
    , Words(context)
    , Numbers(context)
    , Variables(context)
    , Sums(context)
    , BoundSums(context)
    , Nets(context)
    , Values(context)
    , Bounds(context)
  {
  }

  vtkSmartPointer<vtkComputeContext> Context;
  DevicePoints Points;
  std::size_t Directions;
  std::vector<GroupProgram> Programs;
  ComputeProgram Results;
  ComputeBuffer Words, Numbers, Variables, Sums, BoundSums, Nets, Values, Bounds;
  vtkTypeUInt64 Generation = 0;
  std::string Error;

  bool Fail(const std::string& what)
  {
    this->Error = what;
    return false;
  }
  std::string GetBufferErrors() const
  {
    std::string errors;
    for (const ComputeBuffer* buffer : { &this->Words, &this->Numbers, &this->Variables, &this->Sums,
           &this->BoundSums, &this->Nets, &this->Values, &this->Bounds })
    {
      errors += buffer->GetError();
    }
    return errors;
  }
  bool Build();
  bool Upload();
  std::size_t GetBatchSize() const;
  std::uint64_t GetMaximumSteps() const
  {
    return this->Context->IsSoftware() ? SoftwareSteps : std::numeric_limits<std::uint64_t>::max();
  }
  bool RunGroup(GroupProgram& program, std::uint32_t count);
  bool RunGroups(std::uint32_t count, bool isBounds);
  bool RunResults(std::uint32_t count, ComputeBuffer& to, bool hasCarries);
  bool RunBatch(const double* c, std::size_t count, double* values, double* bounds);
};

bool VariantDevice::Internals::Build()
{
  const auto begin = [this](ComputeProgram& program, ShaderSource& source)
  {
    return (source.Assemble() || this->Fail(source.GetError())) &&
      (program.BeginBuild(this->Context, source.GetName(), source.GetSource()) ||
        this->Fail(program.GetError()));
  };
  this->Programs.clear();
  for (const DeviceGroup& group : this->Points.Groups)
  {
    this->Programs.emplace_back();
    this->Programs.back().Group = &group;
    ShaderSource source = MakeSource(group);
    if (!begin(this->Programs.back().Program, source))
    {
      return false;
    }
  }
  ShaderSource source("smVariantResultsCS", smVariantResultsCS);
  if (!begin(this->Results, source))
  {
    return false;
  }
  for (GroupProgram& program : this->Programs)
  {
    if (!program.Program.FinishBuild())
    {
      return this->Fail(program.Program.GetError());
    }
  }
  return this->Results.FinishBuild() || this->Fail(this->Results.GetError());
}

bool VariantDevice::Internals::Upload()
{
  const auto block = static_cast<std::size_t>(this->Context->GetMaximumStorageBlockSize());
  const std::size_t largest =
    std::max(this->Points.Numbers.size() * sizeof(double), this->Points.Words.size() * sizeof(std::uint32_t));
  if (largest > block || this->GetBatchSize() < VariantsOfGroup)
  {
    return this->Fail("the frozen points take " + std::to_string(largest) +
      " bytes, and a storage block of the OpenGL context has " + std::to_string(block));
  }
  for (const DeviceGroup& group : this->Points.Groups)
  {
    const std::uint32_t steps = *std::max_element(group.Steps.begin(), group.Steps.end());
    if (steps + 1 > this->GetMaximumSteps())
    {
      return this->Fail("a patch takes " + std::to_string(steps) +
        " iterations of loops, and a software renderer may end loops after 65535");
    }
  }
  return (this->Words.Upload(this->Points.Words) && this->Numbers.Upload(this->Points.Numbers)) ||
    this->Fail("the frozen points do not fit on the GPU: " + this->GetBufferErrors());
}

std::size_t VariantDevice::Internals::GetBatchSize() const
{
  const std::size_t row =
    sizeof(double) * std::max({ 2 * std::size_t{ NumberOfMoments }, this->Directions, this->Points.MaxNet });
  const std::size_t block =
    std::min(static_cast<std::size_t>(this->Context->GetMaximumStorageBlockSize()), MaximumBufferBytes);
  const std::size_t fitting = block / row / VariantsOfGroup * VariantsOfGroup;
  if (this->Context->IsSoftware())
  {
    return std::min(fitting, SoftwareBatch);
  }
  // A patch of a high degree is one item.
  std::uint64_t largest = 1;
  for (const DeviceGroup& group : this->Points.Groups)
  {
    for (std::size_t i = 0; i < group.Costs.size(); ++i)
    {
      largest = std::max(largest, CountWork(group.Costs[i], group.Steps[i]));
    }
  }
  const std::uint64_t allowed = std::max<std::uint64_t>(DeviceWork / largest, VariantsOfGroup);
  return std::min({ fitting, DeviceBatch, allowed / VariantsOfGroup * VariantsOfGroup });
}

bool VariantDevice::Internals::RunGroup(GroupProgram& own, std::uint32_t count)
{
  const DeviceGroup& group = *own.Group;
  ComputeProgram& program = own.Program;
  const std::uint64_t limit = this->Context->IsSoftware() ? SoftwareWork : DeviceWork;
  const std::uint64_t limitOfSteps = this->GetMaximumSteps();
  for (std::size_t begin = 0; begin < group.Costs.size();)
  {
    const auto getWork = [&](std::size_t i) { return CountWork(group.Costs[i], group.Steps[i]) * count; };
    std::uint64_t work = 0;
    std::uint64_t steps = 0;
    std::size_t end = begin;
    do
    {
      work += getWork(end);
      steps += group.Steps[end] + 1;
      ++end;
    } while (end < group.Costs.size() && work + getWork(end) <= limit &&
      steps + group.Steps[end] + 1 <= limitOfSteps);
    const bool hasDegrees = !group.IsNetInBuffer ||
      (program.SetUniform("smDegreeS", group.Degree[0]) && program.SetUniform("smDegreeR", group.Degree[1]));
    if (!hasDegrees || !program.SetUniform("smVariantCount", count) ||
      !program.SetUniform(
        "smFirstItem", static_cast<unsigned int>(group.FirstWord + begin * group.WordsOfItem)) ||
      !program.SetUniform("smItemCount", static_cast<unsigned int>(end - begin)) ||
      !program.Dispatch(count, VariantsOfGroup))
    {
      return this->Fail("a dispatch failed: " + program.GetError());
    }
    begin = end;
  }
  return true;
}

bool VariantDevice::Internals::RunGroups(std::uint32_t count, bool isBounds)
{
  ComputeBuffer& sums = isBounds ? this->BoundSums : this->Sums;
  if (!this->Words.Bind(0) || !this->Numbers.Bind(1) || !this->Variables.Bind(2) || !sums.Bind(3) ||
    !this->Nets.Bind(4))
  {
    return this->Fail("the buffers of a batch cannot be used: " + this->GetBufferErrors());
  }
  for (GroupProgram& program : this->Programs)
  {
    if ((program.Group->Step == DeviceStep::Bounds) == isBounds && !this->RunGroup(program, count))
    {
      return false;
    }
  }
  return this->RunResults(count, isBounds ? this->Bounds : this->Values, !isBounds);
}

bool VariantDevice::Internals::RunResults(std::uint32_t count, ComputeBuffer& to, bool hasCarries)
{
  return (to.Allocate(std::size_t{ NumberOfMoments } * count * sizeof(double)) && to.Bind(5) &&
           this->Results.SetUniform("smVariantCount", count) &&
           this->Results.SetUniform("smHasCarries", hasCarries ? 1u : 0u) &&
           this->Results.Dispatch(count, VariantsOfGroup)) ||
    this->Fail("the results could not be made: " + this->Results.GetError() + to.GetError());
}

bool VariantDevice::Internals::RunBatch(const double* c, std::size_t count, double* values, double* bounds)
{
  const auto variants = static_cast<std::uint32_t>(count);
  const std::size_t bytes = NumberOfMoments * count * sizeof(double);
  const ContextScope scope(this->Context);
  if (!scope)
  {
    return this->Fail("the OpenGL context was lost: " + this->Context->GetReason());
  }
  // Everything is written before the first dispatch: drivers may write a buffer before shaders have read it.
  if (!UploadVariables(this->Variables, c, count, this->Directions) || !this->Sums.Allocate(2 * bytes) ||
    !this->Sums.Clear() || !this->BoundSums.Allocate(bytes) || !this->BoundSums.Clear() ||
    !this->Nets.Allocate(std::max<std::size_t>(this->Points.MaxNet, 1) * count * sizeof(double)))
  {
    return this->Fail("a batch does not fit on the GPU: " + this->GetBufferErrors());
  }
  const bool isBounded = bounds && this->Points.HasBounds;
  return this->RunGroups(variants, false) && (!isBounded || this->RunGroups(variants, true)) &&
    ((this->Values.Read(values, bytes) && (!isBounded || this->Bounds.Read(bounds, bytes))) ||
      this->Fail("the results could not be read: " + this->GetBufferErrors()));
}

VariantDevice::VariantDevice(vtkComputeContext* context, DevicePoints points, std::size_t directions)
  : Implementation(std::make_unique<Internals>(context, std::move(points), directions))
{
}

VariantDevice::~VariantDevice() = default;

const DevicePoints& VariantDevice::GetPoints() const
{
  return this->Implementation->Points;
}

vtkComputeContext* VariantDevice::GetContext() const
{
  return this->Implementation->Context;
}

const std::string& VariantDevice::GetError() const
{
  return this->Implementation->Error;
}

bool VariantDevice::IsReady() const
{
  const Internals& self = *this->Implementation;
  return self.Generation != 0 && self.Generation == self.Context->GetGeneration();
}

bool VariantDevice::Prepare()
{
  Internals& self = *this->Implementation;
  self.Generation = 0;
  if (self.Context->Start() != vtkComputeContext::READY)
  {
    return self.Fail(self.Context->GetReason());
  }
  if (self.Context->FlushesSubnormals())
  {
    return self.Fail(self.Context->GetRenderer() + SubnormalsProblem);
  }
  if (!self.Upload() || !self.Build())
  {
    return false;
  }
  self.Generation = self.Context->GetGeneration();
  return true;
}

bool VariantDevice::Evaluate(const double* c, std::size_t n, double* values, double* bounds)
{
  Internals& self = *this->Implementation;
  const std::size_t batch = self.GetBatchSize();
  for (std::size_t first = 0; first < n; first += batch)
  {
    const std::size_t count = std::min(batch, n - first);
    if (!this->IsReady())
    {
      return self.Fail("the OpenGL context was lost: " + self.Context->GetReason());
    }
    if (!self.RunBatch(c + first * self.Directions, count, values + first * NumberOfMoments,
          bounds ? bounds + first * NumberOfMoments : nullptr))
    {
      return false;
    }
  }
  const DevicePoints& points = self.Points;
  for (std::size_t i = 0; i < n * NumberOfMoments; ++i)
  {
    const std::size_t m = i % NumberOfMoments;
    const double divisor = GetMomentDegree(static_cast<int>(m));
    values[i] = points.Constant[m] + values[i] / divisor;
    if (!bounds)
    {
      continue;
    }
    // The result, its quotient and its sum with the constant are rounded.
    const double bound = GetSumRounding(points.Terms) * (points.ConstantBound[m] + bounds[i] / divisor) +
      4.0 * UnitRoundoff * (std::abs(values[i]) + std::abs(points.Constant[m]));
    bounds[i] = points.HasBounds && std::isfinite(bound) ? bound : std::numeric_limits<double>::quiet_NaN();
  }
  return true;
}
}
