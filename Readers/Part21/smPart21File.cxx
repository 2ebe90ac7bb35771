#include "smPart21File.h"

#include "smParallelFor.h"
#include "smPart21Cursor.h"
#include "smPart21Parser.h"
#include "smTextEncoding.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <fstream>
#include <limits>

namespace sm
{
namespace
{
/// Number of references that a thread resolves at a time.
constexpr std::size_t ResolveGrain = 1 << 14;

constexpr std::string_view Magic = "ISO-10303-21;";

bool IsControl(char c)
{
  const unsigned char code = static_cast<unsigned char>(c);
  return code < 32 && code != '\n' && code != '\r' && code != '\t' && code != '\f' && code != '\v';
}

/// Returns the position of the first control character that the parser reads as a blank but the standard does
/// not allow.
std::size_t FindControlCharacter(std::string_view text)
{
  std::size_t i = 0;
  // Eight bytes at once, where none is below 32.
  for (; i + 8 <= text.size(); i += 8)
  {
    std::uint64_t word;
    std::memcpy(&word, text.data() + i, sizeof(word));
    if (((word - 0x2020202020202020u) & ~word & 0x8080808080808080u) == 0)
    {
      continue;
    }
    for (std::size_t k = i; k < i + 8; ++k)
    {
      if (IsControl(text[k]))
      {
        return k;
      }
    }
  }
  for (; i < text.size(); ++i)
  {
    if (IsControl(text[i]))
    {
      return i;
    }
  }
  return std::string_view::npos;
}

bool IsBlank(std::string_view text)
{
  Part21Cursor cursor{ text.data(), text.data() + text.size() };
  return cursor.SkipBlanks() && cursor.IsAtEnd();
}
}

bool Part21File::Read(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  file.seekg(0, std::ios::end);
  // On some systems a folder can be opened, and its size is then a huge number.
  const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : -1;
  if (size < 0 || size == std::numeric_limits<std::streamoff>::max())
  {
    this->Clear();
    this->Add(Part21Defect::Unopened, 0);
    return false;
  }
  if (size > std::numeric_limits<std::uint32_t>::max())
  {
    this->Clear();
    this->Add(Part21Defect::TooLarge, 0);
    return false;
  }
  std::string text(static_cast<std::size_t>(size), '\0');
  file.seekg(0);
  file.read(&text[0], size);
  // A file may become shorter while it is read.
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return this->Parse(std::move(text));
}

bool Part21File::Parse(std::string text, std::size_t chunk)
{
  this->Clear();
  this->Text = ToUTF8(std::move(text));
  const std::size_t start = std::string_view(this->Text).substr(0, HeaderSearch).find(Magic);
  if (this->Text.empty() || start == std::string_view::npos || this->Text.size() > UINT32_MAX)
  {
    this->Add(this->Text.empty()         ? Part21Defect::Empty
        : this->Text.size() > UINT32_MAX ? Part21Defect::TooLarge
                                         : Part21Defect::NoHeader,
      0);
    return false;
  }
  if (!IsBlank(std::string_view(this->Text).substr(0, start)))
  {
    this->Add(Part21Defect::Junk, 0);
  }
  const std::size_t control = FindControlCharacter(std::string_view(this->Text).substr(start));
  if (control != std::string_view::npos)
  {
    this->Add(Part21Defect::ControlCharacters, start + control);
  }
  Part21Parser parser(*this, chunk);
  parser.Parse(start);
  this->IndexIds();
  this->Resolve(parser.References);
  return true;
}

void Part21File::Clear()
{
  *this = Part21File();
}

void Part21File::Add(Part21Defect defect, std::size_t offset, std::uint64_t id, std::uint64_t other)
{
  if (this->Counts[static_cast<std::size_t>(defect)]++ < ProblemLimit)
  {
    this->Problems.push_back({ defect, id, other, offset });
  }
}

void Part21File::IndexIds()
{
  const Index count = this->GetNumberOfInstances();
  // Most files number their instances densely. A few very large numbers must not enlarge the table to their
  // size.
  const std::uint64_t dense = std::uint64_t{ 4 } * count + 1024;
  std::uint64_t largest = 0;
  for (Index i = 0; i < count; ++i)
  {
    const std::uint64_t id = this->Instances[i].Id;
    largest = id < dense ? std::max(largest, id) : largest;
  }
  this->DenseIds.assign(static_cast<std::size_t>(largest) + 1, None);
  for (Index i = 0; i < count; ++i)
  {
    const std::uint64_t id = this->Instances[i].Id;
    if (id >= this->DenseIds.size())
    {
      this->SparseIds.push_back({ id, i });
    }
    else if (this->DenseIds[id] == None)
    {
      this->DenseIds[id] = i;
    }
  }
  std::sort(this->SparseIds.begin(), this->SparseIds.end(),
    [](const SparseId& a, const SparseId& b)
    { return a.Id != b.Id ? a.Id < b.Id : a.Instance < b.Instance; });
  for (Index i = 0; i < count; ++i)
  {
    if (this->Find(this->Instances[i].Id) != i)
    {
      // It is ambiguous which of the instances a reference means.
      this->Damaged[i] |= Contradictory;
      this->Damaged[this->Find(this->Instances[i].Id)] |= Contradictory;
      this->Add(Part21Defect::DuplicateId, this->Instances[i].Begin, this->Instances[i].Id);
    }
  }
}

Part21File::Index Part21File::Find(std::uint64_t id) const
{
  if (id < this->DenseIds.size())
  {
    return this->DenseIds[id];
  }
  const auto found = std::lower_bound(this->SparseIds.begin(), this->SparseIds.end(), id,
    [](const SparseId& entry, std::uint64_t value) { return entry.Id < value; });
  return found != this->SparseIds.end() && found->Id == id ? found->Instance : None;
}

void Part21File::Resolve(const std::vector<std::uint64_t>& ids)
{
  this->References.resize(ids.size());
  std::atomic<bool> areAllDefined{ true };
  ParallelFor(ids.size(), ResolveGrain,
    [&](std::size_t begin, std::size_t end)
    {
      bool areDefined = true;
      for (std::size_t k = begin; k < end; ++k)
      {
        this->References[k] = this->Find(ids[k]);
        areDefined = areDefined && this->References[k] != None;
      }
      if (!areDefined)
      {
        areAllDefined = false;
      }
    });
  for (Index i = 0; !areAllDefined && i < this->GetNumberOfInstances(); ++i)
  {
    for (std::uint32_t k = this->Instances[i].FirstReference; k < this->Instances[i + 1].FirstReference; ++k)
    {
      if (this->References[k] == None)
      {
        this->Damaged[i] |= Contradictory;
        this->Add(Part21Defect::UndefinedReference, this->Instances[i].Begin, this->Instances[i].Id, ids[k]);
      }
    }
  }
}

std::size_t Part21File::GetLine(std::size_t offset) const
{
  const auto end = this->Text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, this->Text.size()));
  return 1 + static_cast<std::size_t>(std::count(this->Text.begin(), end, '\n'));
}

const char* Part21File::GetName(Part21Defect defect)
{
  static const char* const names[] = { "cannot be opened", "empty", "no header", "too large",
    "junk before the header", "truncated", "no data section", "comment without an end", "syntax error",
    "text outside of instances", "number too large", "number used twice", "undefined reference",
    "control characters", "skipped instance", "instance behind the end" };
  static_assert(
    sizeof(names) / sizeof(names[0]) == static_cast<std::size_t>(Part21Defect::Count), "a name each");
  return names[static_cast<std::size_t>(defect)];
}
}
