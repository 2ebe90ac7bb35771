#include "smPart21Changes.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace sm
{
namespace
{
/// OpenCASCADE reads numbers of 31 bits.
constexpr std::uint64_t LargestNumber = std::numeric_limits<std::int32_t>::max();
}

void Part21Changes::Replace(std::string_view part, std::string text)
{
  this->Changes.push_back(
    { static_cast<std::size_t>(part.data() - this->File.GetText().data()), part.size(), std::move(text) });
}

std::string Part21Changes::Add(const std::string& entity)
{
  const std::string name = "#" + std::to_string(this->GetFreeNumber());
  this->Added += name + "=" + entity + ";\n";
  return name;
}

std::string Part21Changes::Apply()
{
  if (this->Changes.empty())
  {
    return {};
  }
  std::sort(this->Changes.begin(), this->Changes.end(),
    [](const Change& a, const Change& b) { return a.Offset < b.Offset; });
  const std::string_view text = this->File.GetText();
  std::string result;
  result.reserve(text.size() + this->Added.size() + 64 * this->Changes.size());
  std::size_t kept = 0;
  for (const Change& change : this->Changes)
  {
    result.append(text, kept, change.Offset - kept).append(change.Text);
    kept = change.Offset + change.Size;
  }
  const Part21File::Index last = this->File.GetNumberOfInstances() - 1;
  const std::size_t end = this->File.GetOffset(last) + this->File.GetText(last).size();
  result.append(text, kept, end - kept).append("\n").append(this->Added);
  return result.append(text, end);
}

std::uint64_t Part21Changes::GetFreeNumber()
{
  if (this->Next == 0)
  {
    this->FindNumbers();
  }
  while (std::binary_search(this->Numbers.begin(), this->Numbers.end(), this->Next))
  {
    ++this->Next;
  }
  return this->Next++;
}

void Part21Changes::FindNumbers()
{
  const std::string_view text = this->File.GetText();
  std::uint64_t largest = 0;
  for (std::size_t at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1))
  {
    std::uint64_t number = 0;
    for (std::size_t k = at + 1;
         k < text.size() && text[k] >= '0' && text[k] <= '9' && number <= LargestNumber; ++k)
    {
      number = 10 * number + static_cast<std::uint64_t>(text[k] - '0');
    }
    this->Numbers.push_back(number);
    largest = std::max(largest, number);
  }
  if (largest < LargestNumber / 2)
  {
    // Above the largest number nothing has to be looked up.
    this->Next = largest + 1;
    this->Numbers.clear();
    return;
  }
  this->Next = 1;
  std::sort(this->Numbers.begin(), this->Numbers.end());
}
}
