#include "smWorkList.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace sm
{
namespace
{
/// Bit of WorkShape::LinesOfItem for items that measure gaps, as in glsl/smLineStorage.glsl.
constexpr std::uint32_t MeasuresGaps = 0x80000000u;

std::uint32_t GetNodes(const WorkItem& item)
{
  return (item.Work.Detail[0] >> 8) & 255u;
}

/// Equal for items that are evaluated by the same instructions: kind, degrees, numbers of points, degrees of
/// trim and edge.
std::uint64_t GetShapeKey(const WorkItem& item)
{
  const std::uint64_t edgeDegree = item.Kind == ItemKind::Ribbon ? item.Work.Detail[2] & 255u : 0u;
  const auto kind = static_cast<std::uint64_t>(item.Kind);
  const std::uint64_t degrees =
    static_cast<std::uint64_t>(item.Degree[0]) << 5 | static_cast<std::uint64_t>(item.Degree[1]);
  return (kind << 10 | degrees) << 32 | (item.Work.Detail[0] & 0xffffffu) << 8 | edgeDegree;
}

ProgramKey GetProgram(const WorkItem& item)
{
  return IntegrationPrograms::ChooseProgram(item.Kind, item.Degree[0], item.Degree[1]);
}

/// Items of one key: one of them, how many they are, and where the first of them lies in the list.
struct KeyedItems
{
  std::uint64_t Key;
  const WorkItem* Example;
  ProgramKey Program;
  std::uint32_t Count;
  std::uint32_t First;
};
}

WorkList::WorkList(
  const std::vector<WorkItem>& items, const std::vector<std::size_t>& active, const PortionLimits& limits)
  : Order(active.size())
{
  std::vector<KeyedItems> shapes;
  std::unordered_map<std::uint64_t, std::uint32_t> known;
  std::vector<std::uint32_t> shapeOf(active.size());
  // Neighbours often alternate between a few shapes: the last one of each of some keys is found without the
  // map.
  constexpr std::size_t Recent = 1024;
  std::array<std::uint32_t, Recent> recent{};
  for (std::size_t i = 0; i < active.size(); ++i)
  {
    const WorkItem& item = items[active[i]];
    const std::uint64_t key = GetShapeKey(item);
    std::uint32_t& guess = recent[(key ^ key >> 16 ^ key >> 32) % Recent];
    if (guess >= shapes.size() || shapes[guess].Key != key)
    {
      const auto [found, isNew] = known.try_emplace(key, static_cast<std::uint32_t>(shapes.size()));
      if (isNew)
      {
        shapes.push_back({ key, &item, GetProgram(item), 0, 0 });
      }
      guess = found->second;
    }
    shapeOf[i] = guess;
    ++shapes[guess].Count;
    this->Comparisons = this->Comparisons || (item.Work.Detail[0] >> 24 & FlagFirst) == 0;
  }
  std::vector<std::uint32_t> sorted(shapes.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  std::sort(sorted.begin(), sorted.end(),
    [&shapes](std::uint32_t a, std::uint32_t b)
    { return std::tie(shapes[a].Program, shapes[a].Key) < std::tie(shapes[b].Program, shapes[b].Key); });
  std::uint32_t first = 0;
  for (const std::uint32_t shape : sorted)
  {
    shapes[shape].First = first;
    this->AddShape(*shapes[shape].Example, first, shapes[shape].Count, limits);
    first += shapes[shape].Count;
  }
  for (std::size_t i = 0; i < active.size(); ++i)
  {
    this->Order[shapes[shapeOf[i]].First++] = static_cast<std::uint32_t>(i);
  }
}

void WorkList::AddShape(
  const WorkItem& item, std::uint32_t firstItem, std::uint32_t count, const PortionLimits& limits)
{
  const std::uint32_t nodes = GetNodes(item);
  const std::uint32_t lines = limits.HasWholeRibbons && item.Kind != ItemKind::Panel ? 1u : nodes;
  const std::int64_t costOfItem = std::max<std::int64_t>(item.GetCost(), 1);
  const ProgramKey program = GetProgram(item);
  const std::int64_t points = item.Kind == ItemKind::Panel ? (item.Work.Detail[0] >> 16) & 255u
    : item.Kind == ItemKind::Ribbon                        ? 1
                                                           : 0;
  this->Evaluations += points * nodes * count;
  while (count > 0)
  {
    const std::int64_t room = this->Portions.empty()
      ? 0
      : std::min((limits.Cost - this->PortionCost) / costOfItem,
          (static_cast<std::int64_t>(limits.Lines) - this->Portions.back().LineCount) / lines);
    if (this->Portions.empty() || (room <= 0 && this->Portions.back().ItemCount > 0))
    {
      WorkPortion next;
      next.FirstShape = static_cast<std::uint32_t>(this->Shapes.size());
      next.FirstItem = firstItem;
      this->Portions.push_back(std::move(next));
      this->PortionCost = 0;
      continue;
    }
    const auto taken =
      static_cast<std::uint32_t>(std::min<std::int64_t>(std::max<std::int64_t>(room, 1), count));
    WorkPortion& portion = this->Portions.back();
    if (portion.Ranges.empty() || portion.Ranges.back().Program != program)
    {
      portion.Ranges.push_back(
        { program, static_cast<std::uint32_t>(this->Shapes.size()), 0, portion.LineCount, 0 });
    }
    LineRange& range = portion.Ranges.back();
    this->Shapes.push_back(
      { portion.LineCount, firstItem, taken, lines | (item.Kind == ItemKind::Ribbon ? MeasuresGaps : 0u) });
    ++range.ShapeCount;
    ++portion.ShapeCount;
    range.LineCount += taken * lines;
    portion.LineCount += taken * lines;
    portion.ItemCount += taken;
    this->PortionCost += taken * costOfItem;
    firstItem += taken;
    count -= taken;
  }
}

std::size_t WorkList::GetMaximumLines() const
{
  std::size_t lines = 0;
  for (const WorkPortion& portion : this->Portions)
  {
    lines = std::max<std::size_t>(lines, portion.LineCount);
  }
  return lines;
}
}
