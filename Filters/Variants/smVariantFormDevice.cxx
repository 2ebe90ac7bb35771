#include "Detail/smVariantFormDevice.h"

#include "Detail/smVariantFormTables.h"
#include "Detail/smVariantNumbers.h"
#include "smComputeProgram.h"
#include "smContextScope.h"
#include "smShaderSource.h"
#include "smVariantFormResultsCS.h"
#include "smVariantFormsCS.h"
#include "smVariantPolynomial.h"

#include "vtkComputeContext.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdint>
#include <map>

namespace sm
{
namespace
{
// Variants times coefficients of a batch on a software renderer, and multiply-adds of a dispatch: some 100 ms
// on two CPU cores.
constexpr std::size_t SoftwareTerms = 20000000;
// Multiply-adds of an iteration.
constexpr std::size_t WorkOfStep = 4;

/// Monomials whose last variable is in a range, which one dispatch sums up by so many iterations.
struct FormRange
{
  std::uint32_t First, End, FirstMonomial;
  std::size_t Steps;
};

/// Iterations of the loops of a sum of this degree over the variables up to `last`.
std::size_t CountSteps(int degree, std::size_t last)
{
  if (degree == 1)
  {
    return last + 2;
  }
  std::size_t steps = 1;
  for (std::size_t a = 0; a <= last; ++a)
  {
    steps += 1 + CountSteps(degree - 1, a);
  }
  return steps;
}

std::vector<FormRange> DivideForms(const VariantForms& forms, int degree, std::size_t limit)
{
  std::vector<FormRange> ranges;
  const auto variables = static_cast<std::uint32_t>(forms.Variables);
  const std::size_t* counts = forms.Counts + static_cast<std::size_t>(degree) * (variables + 1);
  for (std::uint32_t first = 0; first < variables;)
  {
    std::uint32_t end = first;
    std::size_t steps = 2 * variables;
    do
    {
      steps += 1 + CountSteps(degree - 1, end);
      ++end;
    } while (end < variables && steps + 1 + CountSteps(degree - 1, end) <= limit);
    ranges.push_back({ first, end, static_cast<std::uint32_t>(counts[first]), steps });
    first = end;
  }
  return ranges;
}
}

struct VariantFormDevice::Internals
{
  Internals(vtkComputeContext* context, std::shared_ptr<const VariantPolynomial> polynomial)
    : Context(context)
    , Polynomial(std::move(polynomial))
    , Directions(static_cast<std::size_t>(this->Polynomial->GetNumberOfDirections()))
    , Entries{ ComputeBuffer(context), ComputeBuffer(context) }
    , Variables(context)
    , Columns(context)
    , Values(context)
    , Gradients(context)
  {
  }

  vtkSmartPointer<vtkComputeContext> Context;
  std::shared_ptr<const VariantPolynomial> Polynomial;
  std::size_t Directions;
  /// By degree.
  std::map<int, ComputeProgram> Programs;
  ComputeProgram Results;
  /// Of the moments, and of their derivatives.
  ComputeBuffer Entries[2];
  ComputeBuffer Variables, Columns, Values, Gradients;
  vtkTypeUInt64 Generation = 0;
  std::string Error;

  bool Fail(const std::string& what)
  {
    this->Error = what;
    return false;
  }
  std::string GetBufferErrors() const
  {
    return this->Entries[0].GetError() + this->Entries[1].GetError() + this->Variables.GetError() +
      this->Columns.GetError() + this->Values.GetError() + this->Gradients.GetError();
  }
  /// The same for all batches, as the bits of a variant depend on how forms are divided.
  std::size_t GetMaximumSteps() const
  {
    return this->Context->IsSoftware() ? SoftwareSteps : DeviceWork / (WorkOfStep * DeviceBatch);
  }
  /// Returns the blocks of forms that a dispatch of `count` variants may have.
  std::uint32_t GetBlocksAtOnce(std::size_t steps, std::uint32_t blocks, std::uint32_t count) const
  {
    const std::uint64_t limit = this->Context->IsSoftware() ? SoftwareTerms : DeviceWork;
    const std::uint64_t allowed = limit / (WorkOfStep * steps * count);
    return static_cast<std::uint32_t>(std::clamp<std::uint64_t>(allowed, 1, blocks));
  }
  bool Build();
  bool Upload();
  std::size_t GetBatchSize(bool hasGradients) const;
  bool RunRange(const FormTables& tables, const VariantMatrix& matrix, const FormRange& range,
    std::uint32_t firstEntry, std::uint32_t firstColumn, std::uint32_t count);
  bool RunMatrix(const FormTables& tables, std::size_t index, std::uint32_t firstEntry,
    std::uint32_t firstColumn, std::uint32_t count);
  bool RunResults(const FormTables& tables, bool hasGradients, std::uint32_t count);
  bool RunBatch(const double* c, std::size_t count, double* values, double* gradients);
};

bool VariantFormDevice::Internals::Build()
{
  this->Programs.clear();
  for (int degree = 2; degree <= MaximumFormDegree; ++degree)
  {
    ShaderSource source("smVariantFormsCS", smVariantFormsCS);
    source.Define("SM_LOWER", "smSum" + std::to_string(degree - 1));
    ComputeProgram& program = this->Programs[degree];
    if (!source.Assemble() || !program.BeginBuild(this->Context, source.GetName(), source.GetSource()))
    {
      return this->Fail(source.GetError() + program.GetError());
    }
  }
  ShaderSource source("smVariantFormResultsCS", smVariantFormResultsCS);
  if (!source.Assemble() || !this->Results.Build(this->Context, source.GetName(), source.GetSource()))
  {
    return this->Fail(source.GetError() + this->Results.GetError());
  }
  for (auto& [degree, program] : this->Programs)
  {
    if (!program.FinishBuild())
    {
      return this->Fail(program.GetError());
    }
  }
  return true;
}

bool VariantFormDevice::Internals::Upload()
{
  const auto block = static_cast<std::size_t>(this->Context->GetMaximumStorageBlockSize());
  for (int i = 0; i < 2; ++i)
  {
    std::vector<double> all;
    for (const std::vector<double>& entries : this->Polynomial->GetTables(i == 1).Entries)
    {
      all.insert(all.end(), entries.begin(), entries.end());
    }
    if (all.size() * sizeof(double) > block || this->GetBatchSize(i == 1) < VariantsOfGroup)
    {
      return this->Fail("the coefficients take " + std::to_string(all.size() * sizeof(double)) +
        " bytes, and a storage block of the OpenGL context has " + std::to_string(block));
    }
    if (!this->Entries[i].Upload(all))
    {
      return this->Fail("the coefficients do not fit on the GPU: " + this->Entries[i].GetError());
    }
  }
  return true;
}

std::size_t VariantFormDevice::Internals::GetBatchSize(bool hasGradients) const
{
  const FormTables& tables = this->Polynomial->GetTables(hasGradients);
  const std::size_t gradients = hasGradients ? NumberOfMoments * this->Directions : 0;
  const std::size_t row =
    sizeof(double) * std::max({ tables.Forms.TotalColumns, this->Directions, gradients });
  const std::size_t fitting =
    std::min(static_cast<std::size_t>(this->Context->GetMaximumStorageBlockSize()), MaximumBufferBytes) / row;
  std::size_t entries = 1;
  for (const std::vector<double>& matrix : tables.Entries)
  {
    entries += matrix.size();
  }
  const std::size_t wanted = this->Context->IsSoftware()
    ? std::clamp<std::size_t>(SoftwareTerms / entries, VariantsOfGroup, DeviceBatch)
    : DeviceBatch;
  return std::min(fitting, wanted) / VariantsOfGroup * VariantsOfGroup;
}

/// Blocks of four forms follow each other in the entries and columns, so that a dispatch may have some of
/// them.
bool VariantFormDevice::Internals::RunRange(const FormTables& tables, const VariantMatrix& matrix,
  const FormRange& range, std::uint32_t firstEntry, std::uint32_t firstColumn, std::uint32_t count)
{
  ComputeProgram& program = this->Programs.at(matrix.Degree);
  const auto blocks = static_cast<std::uint32_t>(matrix.Columns / 4);
  const auto rows = static_cast<std::uint32_t>(matrix.Rows);
  const std::uint32_t atOnce = this->GetBlocksAtOnce(range.Steps, blocks, count);
  for (std::uint32_t block = 0; block < blocks; block += atOnce)
  {
    const std::uint32_t own = std::min(atOnce, blocks - block);
    if (!program.SetUniform("smVariantCount", count) ||
      !program.SetUniform("smVariableCount", static_cast<unsigned int>(tables.Forms.Variables)) ||
      !program.SetUniform("smBlockCount", own) ||
      !program.SetUniform("smFirstEntry", firstEntry + block * rows) ||
      !program.SetUniform("smMonomialCount", rows) ||
      !program.SetUniform("smFirstColumn", firstColumn + 4 * block) ||
      !program.SetUniform("smFirst", range.First) || !program.SetUniform("smEnd", range.End) ||
      !program.SetUniform("smFirstMonomial", range.FirstMonomial) ||
      !program.Dispatch(own * count, VariantsOfGroup))
    {
      return this->Fail("a dispatch failed: " + program.GetError());
    }
  }
  return true;
}

bool VariantFormDevice::Internals::RunMatrix(const FormTables& tables, std::size_t index,
  std::uint32_t firstEntry, std::uint32_t firstColumn, std::uint32_t count)
{
  const VariantMatrix& matrix = tables.Matrices[index];
  const std::vector<FormRange> ranges = DivideForms(tables.Forms, matrix.Degree, this->GetMaximumSteps());
  return std::all_of(ranges.begin(), ranges.end(),
    [&](const FormRange& range)
    { return this->RunRange(tables, matrix, range, firstEntry, firstColumn, count); });
}

bool VariantFormDevice::Internals::RunResults(
  const FormTables& tables, bool hasGradients, std::uint32_t count)
{
  const auto first = static_cast<std::uint32_t>(tables.Matrices[0].Columns);
  const auto second = static_cast<std::uint32_t>(first + tables.Matrices[1].Columns);
  return (this->Results.SetUniform("smVariantCount", count) &&
           this->Results.SetUniform(
             "smFormCount", hasGradients ? static_cast<unsigned int>(tables.Forms.Variables) : 1u) &&
           this->Results.SetUniform("smFirstColumn", first) &&
           this->Results.SetUniform("smSecondColumn", second) &&
           this->Results.Dispatch(count, VariantsOfGroup)) ||
    this->Fail("the results could not be made: " + this->Results.GetError());
}

bool VariantFormDevice::Internals::RunBatch(
  const double* c, std::size_t count, double* values, double* gradients)
{
  const bool hasGradients = gradients != nullptr;
  const FormTables& tables = this->Polynomial->GetTables(hasGradients);
  const std::size_t bytes = NumberOfMoments * count * sizeof(double);
  const ContextScope scope(this->Context);
  if (!scope)
  {
    return this->Fail("the OpenGL context was lost: " + this->Context->GetReason());
  }
  if (!UploadVariables(this->Variables, c, count, this->Directions) ||
    !this->Columns.Allocate(tables.Forms.TotalColumns * count * sizeof(double)) || !this->Columns.Clear() ||
    !this->Values.Allocate(bytes) || !this->Gradients.Allocate(hasGradients ? bytes * this->Directions : 8) ||
    !this->Entries[hasGradients ? 1 : 0].Bind(1) || !this->Variables.Bind(2) || !this->Columns.Bind(3) ||
    !this->Values.Bind(4) || !this->Gradients.Bind(5))
  {
    return this->Fail("a batch does not fit on the GPU: " + this->GetBufferErrors());
  }
  std::uint32_t entry = 0;
  std::uint32_t column = 0;
  for (std::size_t i = 0; i < tables.Matrices.size(); ++i)
  {
    if (!this->RunMatrix(tables, i, entry, column, static_cast<std::uint32_t>(count)))
    {
      return false;
    }
    entry += static_cast<std::uint32_t>(tables.Entries[i].size() / 4);
    column += static_cast<std::uint32_t>(tables.Matrices[i].Columns);
  }
  return this->RunResults(tables, hasGradients, static_cast<std::uint32_t>(count)) &&
    ((this->Values.Read(values, bytes) &&
       (!hasGradients || this->Gradients.Read(gradients, bytes * this->Directions))) ||
      this->Fail("the results could not be read: " + this->GetBufferErrors()));
}

VariantFormDevice::VariantFormDevice(
  vtkComputeContext* context, std::shared_ptr<const VariantPolynomial> polynomial)
  : Implementation(std::make_unique<Internals>(context, std::move(polynomial)))
{
}

VariantFormDevice::~VariantFormDevice() = default;

vtkComputeContext* VariantFormDevice::GetContext() const
{
  return this->Implementation->Context;
}

const std::string& VariantFormDevice::GetError() const
{
  return this->Implementation->Error;
}

bool VariantFormDevice::IsReady() const
{
  const Internals& self = *this->Implementation;
  return self.Generation != 0 && self.Generation == self.Context->GetGeneration();
}

bool VariantFormDevice::Prepare()
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

bool VariantFormDevice::Evaluate(const double* c, std::size_t n, double* values, double* gradients)
{
  Internals& self = *this->Implementation;
  const std::size_t batch = self.GetBatchSize(gradients != nullptr);
  for (std::size_t first = 0; first < n; first += batch)
  {
    if (!this->IsReady())
    {
      return self.Fail("the OpenGL context was lost: " + self.Context->GetReason());
    }
    const std::size_t count = std::min(batch, n - first);
    if (!self.RunBatch(c + first * self.Directions, count, values + first * NumberOfMoments,
          gradients ? gradients + first * NumberOfMoments * self.Directions : nullptr))
    {
      return false;
    }
  }
  if (gradients)
  {
    for (std::size_t i = 0; i < n * NumberOfMoments; ++i)
    {
      values[i] /= GetMomentDegree(static_cast<int>(i % NumberOfMoments));
    }
  }
  return true;
}
}
