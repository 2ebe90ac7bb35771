#include "smPart21Parser.h"

#include "smParallelFor.h"

#include <algorithm>
#include <memory>

namespace sm
{
namespace
{
/// Chunks that are parsed before they are put together: their number bounds the memory.
constexpr std::size_t MaxChunks = 64;
}

/// A part of a DATA section, and what was read of it.
struct Part21Parser::Chunk
{
  const char* Begin;
  /// The next chunk begins here.
  const char* Stop;
  std::unique_ptr<Part21File> Result;
  std::unique_ptr<Part21Parser> Parser;
  bool IsSectionOpen = false;
  /// False if the text beyond may have mattered: that of damage is found in one pass.
  bool IsValid = false;

  void Parse(const char* start, const char* end, std::size_t size)
  {
    // So that a chunk which begins within a string or a comment is not parsed to the end of the text.
    const char* last = static_cast<std::size_t>(end - this->Stop) > size ? this->Stop + size : end;
    this->Result = std::make_unique<Part21File>();
    this->Result->Instances.clear();
    this->Parser.reset(new Part21Parser(*this->Result, start, { this->Begin, last }));
    this->IsSectionOpen = this->Parser->ParseInstancesTo(this->Stop);
    this->IsValid = this->Result->Problems.empty() && this->Parser->Cursor.At < this->Stop + size / 2;
  }
};

std::vector<Part21Parser::Chunk> Part21Parser::FindChunks() const
{
  std::vector<Chunk> chunks;
  const char* const end = this->Cursor.End;
  const char* begin = this->Cursor.At;
  while (chunks.size() < MaxChunks && static_cast<std::size_t>(end - begin) > 2 * this->ChunkSize)
  {
    const char* const last = begin + 2 * this->ChunkSize;
    const char* stop = begin + this->ChunkSize;
    do
    {
      stop = std::find(stop, last, '\n');
      stop += stop != last ? 1 : 0;
    } while (stop != last && !IsInstanceStart(stop, end));
    chunks.push_back({ begin, stop, nullptr, nullptr });
    begin = stop;
  }
  return chunks;
}

bool Part21Parser::ParseChunks()
{
  while (this->ChunkSize > 0)
  {
    // The first chunk begins here, so that at least its text is parsed in a pass.
    if (!this->ParseInstancesTo(this->Cursor.At))
    {
      return false;
    }
    std::vector<Chunk> chunks = this->FindChunks();
    if (chunks.empty())
    {
      return true;
    }
    ParallelFor(chunks.size(), 1,
      [&](std::size_t first, std::size_t last)
      {
        for (std::size_t k = first; k < last; ++k)
        {
          chunks[k].Parse(this->Start, this->Cursor.End, this->ChunkSize);
        }
      });
    for (const Chunk& chunk : chunks)
    {
      if (!this->ParseInstancesTo(chunk.Begin))
      {
        return false;
      }
      const bool isFirst = &chunk == chunks.data();
      if (this->Cursor.At == chunk.Begin && this->Cursor.Peek() == '#' && chunk.IsValid)
      {
        this->Append(chunk);
        if (!chunk.IsSectionOpen)
        {
          return false;
        }
      }
      else if (isFirst && !this->ParseInstancesTo(chunk.Stop))
      {
        return false;
      }
    }
  }
  return true;
}

void Part21Parser::Append(const Chunk& chunk)
{
  const Part21File& part = *chunk.Result;
  std::vector<std::uint32_t> types;
  for (const std::string& name : part.TypeNames)
  {
    types.push_back(this->FindType(name));
  }
  const auto firstRecord = static_cast<std::uint32_t>(this->File.Records.size());
  const auto firstReference = static_cast<std::uint32_t>(this->References.size());
  for (const Part21File::Instance& instance : part.Instances)
  {
    this->File.Instances.push_back({ instance.Id, instance.Begin, instance.End,
      firstRecord + instance.FirstRecord, firstReference + instance.FirstReference });
  }
  for (const Part21File::Record& record : part.Records)
  {
    this->File.Records.push_back({ types[record.Type], record.Begin, record.End });
  }
  this->File.Damaged.insert(this->File.Damaged.end(), part.Damaged.begin(), part.Damaged.end());
  const std::vector<std::uint64_t>& references = chunk.Parser->References;
  this->References.insert(this->References.end(), references.begin(), references.end());
  this->Cursor.At = chunk.Parser->Cursor.At;
  this->IsLost = chunk.Parser->IsLost;
}
}
