#include "smReduction.h"

#include "smContextResources.h"
#include "smContextScope.h"
#include "smReduceCS.h"
#include "smShaderSource.h"
#include "vtkComputeContext.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace
{
constexpr unsigned int LocalSize = 64;

/// Largest number of bytes of input that one dispatch reads, so that a dispatch is short on slow drivers.
constexpr std::int64_t MaximumTile = 128 << 20;

/// First row and number of rows, as the shader reads them.
struct Block
{
  std::uint32_t FirstRow;
  std::uint32_t Rows;
};

using Segments = std::vector<std::pair<unsigned int, unsigned int>>;

/// Cuts every segment into blocks; returns the segments that their results form.
Segments Cut(const Segments& segments, std::vector<Block>& blocks)
{
  blocks.clear();
  Segments next;
  next.reserve(segments.size());
  for (const auto& segment : segments)
  {
    const unsigned int first = static_cast<unsigned int>(blocks.size());
    for (unsigned int row = segment.first; row < segment.second;)
    {
      const unsigned int rows = std::min(sm::Reduction::BlockSize, segment.second - row);
      blocks.push_back({ row, rows });
      row += rows;
    }
    next.emplace_back(first, static_cast<unsigned int>(blocks.size()));
  }
  return next;
}

double GetNeutral(sm::Reduction::Operation operation)
{
  const double infinity = std::numeric_limits<double>::infinity();
  return operation == sm::Reduction::Operation::SUM  ? 0.0
    : operation == sm::Reduction::Operation::MINIMUM ? infinity
                                                     : -infinity;
}

/// Adds value and error of the last row of each segment; after the last level a segment has one row or none.
/// Results of segments without rows are not changed.
void AddPairs(const std::vector<double>& pairs, const Segments& segments, unsigned int columns,
  std::vector<double>& result)
{
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    if (segments[i].first == segments[i].second)
    {
      continue;
    }
    for (unsigned int column = 0; column < columns; ++column)
    {
      const double* pair = &pairs[(static_cast<std::size_t>(segments[i].first) * columns + column) * 2];
      // After an overflow the error is NaN, and the value alone, infinity, is the result.
      result[i * columns + column] = std::isfinite(pair[0]) ? pair[0] + pair[1] : pair[0];
    }
  }
}
}

namespace sm
{
struct Reduction::Level
{
  std::vector<Block> Blocks;
  unsigned int Stride = 0;
  unsigned int Columns = 0;
  bool Paired = false;
};

Reduction::Reduction(vtkComputeContext* context)
  : Resources(context ? context->GetResources() : std::make_shared<ContextResources>())
  , Blocks(context)
  , Scratch{ ComputeBuffer(context), ComputeBuffer(context) }
{
}

void Reduction::Free()
{
  this->Program.Free();
  this->Blocks.Free();
  this->Scratch[0].Free();
  this->Scratch[1].Free();
}

bool Reduction::Fail(const std::string& what)
{
  this->Error = "reduction: " + what;
  return false;
}

bool Reduction::CountBlocks(std::uint64_t available, const Segments& segments, std::uint64_t& total)
{
  total = 0;
  for (const auto& segment : segments)
  {
    if (segment.first > segment.second || segment.second > available)
    {
      return this->Fail("segment [" + std::to_string(segment.first) + ", " + std::to_string(segment.second) +
        ") is not inside " + std::to_string(available) + " rows");
    }
    total += (static_cast<std::uint64_t>(segment.second) - segment.first + BlockSize - 1) / BlockSize;
  }
  return total <= std::numeric_limits<std::uint32_t>::max() || this->Fail("too many rows");
}

bool Reduction::PrepareProgram(unsigned int columns, Operation operation)
{
  if (!this->Program.IsBuilt())
  {
    ShaderSource source("smReduceCS", smReduceCS);
    if (!source.Assemble() ||
      !this->Program.Build(this->Resources->Context, source.GetName(), source.GetSource()))
    {
      return this->Fail(source.GetError() + this->Program.GetError());
    }
  }
  return (this->Program.SetUniform("smOperation", static_cast<unsigned int>(operation)) &&
           this->Program.SetUniform("smColumns", columns)) ||
    this->Fail(this->Program.GetError());
}

bool Reduction::Reduce(ComputeBuffer& rows, unsigned int stride, unsigned int columns,
  const Segments& segments, Operation operation, std::vector<double>& result)
{
  result.clear();
  this->Error.clear();
  if (columns == 0 || stride < columns)
  {
    return this->Fail(std::to_string(columns) + " columns of rows of " + std::to_string(stride) + " doubles");
  }
  std::uint64_t total = 0;
  if (!this->CountBlocks(rows.GetSize() / (sizeof(double) * stride), segments, total))
  {
    return false;
  }
  if (total == 0)
  {
    result.assign(segments.size() * columns, GetNeutral(operation));
    return true;
  }

  const ContextScope scope(this->Resources->Context);
  if (!scope)
  {
    return this->Fail("the compute context is not ready");
  }
  if (!this->PrepareProgram(columns, operation))
  {
    return false;
  }
  Level level;
  level.Stride = stride;
  level.Columns = columns;
  ComputeBuffer* input = &rows;
  Segments left = segments;
  bool done = false;
  for (int i = 0; !done; ++i)
  {
    left = Cut(left, level.Blocks);
    ComputeBuffer& output = this->Scratch[i % 2];
    if (!this->ReduceLevel(*input, level, output))
    {
      return false;
    }
    done = std::all_of(left.begin(), left.end(),
      [](const std::pair<unsigned int, unsigned int>& segment)
      { return segment.second - segment.first <= 1; });
    input = &output;
    level.Stride = 2 * columns;
    level.Paired = true;
  }

  std::vector<double> pairs(level.Blocks.size() * 2 * columns);
  if (!input->Read(pairs.data(), pairs.size() * sizeof(double)))
  {
    return this->Fail(input->GetError());
  }
  result.assign(segments.size() * columns, GetNeutral(operation));
  AddPairs(pairs, left, columns, result);
  return true;
}

bool Reduction::ReduceLevel(ComputeBuffer& input, const Level& level, ComputeBuffer& output)
{
  const std::size_t outputRow = sizeof(double) * 2 * level.Columns;
  if (!this->Blocks.Upload(level.Blocks) || !output.Allocate(level.Blocks.size() * outputRow))
  {
    return this->Fail(this->Blocks.GetError() + output.GetError());
  }
  const std::size_t alignment =
    std::lcm(static_cast<std::size_t>(this->Resources->StorageOffsetAlignment), sizeof(double));
  // A range starts at an aligned offset up to one alignment before its first row.
  const std::size_t limit =
    static_cast<std::size_t>(std::min(this->Resources->MaximumStorageBlockSize, MaximumTile)) - alignment;
  const std::size_t inputRow = sizeof(double) * level.Stride;
  if (inputRow * BlockSize > limit)
  {
    return this->Fail("rows of " + std::to_string(level.Stride) + " doubles are too long");
  }

  for (std::size_t first = 0; first < level.Blocks.size();)
  {
    // As many blocks as fit into one binding of the input and one of the output.
    std::size_t begin = level.Blocks[first].FirstRow;
    std::size_t end = begin + level.Blocks[first].Rows;
    std::size_t last = first + 1;
    for (; last < level.Blocks.size() && (last + 1 - first) * outputRow <= limit; ++last)
    {
      const Block& block = level.Blocks[last];
      const std::size_t newBegin = std::min<std::size_t>(begin, block.FirstRow);
      const std::size_t newEnd =
        std::max<std::size_t>(end, static_cast<std::size_t>(block.FirstRow) + block.Rows);
      if ((newEnd - newBegin) * inputRow > limit)
      {
        break;
      }
      begin = newBegin;
      end = newEnd;
    }
    const std::size_t inputStart = begin * inputRow / alignment * alignment;
    const std::size_t outputStart = first * outputRow / alignment * alignment;
    const auto toUnsigned = [](std::size_t value) { return static_cast<unsigned int>(value); };
    if (!input.Bind(0, inputStart, end * inputRow - inputStart) || !this->Blocks.Bind(1) ||
      !output.Bind(2, outputStart, last * outputRow - outputStart))
    {
      return this->Fail(input.GetError() + this->Blocks.GetError() + output.GetError());
    }
    ComputeProgram& program = this->Program;
    if (!program.SetUniform("smFirstBlock", toUnsigned(first)) ||
      !program.SetUniform("smBlockCount", toUnsigned(last - first)) ||
      !program.SetUniform("smStride", level.Stride) ||
      !program.SetUniform("smPaired", level.Paired ? 1u : 0u) ||
      !program.SetUniform("smFirstRow", toUnsigned(begin)) ||
      !program.SetUniform("smInputStart", toUnsigned((begin * inputRow - inputStart) / sizeof(double))) ||
      !program.SetUniform("smOutputStart", toUnsigned((first * outputRow - outputStart) / sizeof(double))) ||
      !program.Dispatch(toUnsigned((last - first) * level.Columns), LocalSize))
    {
      return this->Fail(program.GetError());
    }
    first = last;
  }
  return true;
}
}
