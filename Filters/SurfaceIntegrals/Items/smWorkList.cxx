#include "smWorkList.h"

#include "smParallelFor.h"

#include <algorithm>
#include <utility>

namespace sm
{
namespace
{
/// Items that a thread sorts at a time.
constexpr std::size_t ItemsOfChunk = 2048;
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

ProgramKey GetProgram(const WorkItem& item, const PortionLimits& limits)
{
  return IntegrationPrograms::ChooseProgram(item.Kind, item.Degree[0], item.Degree[1], limits.IsSoftware);
}

/// Keys in the order of their programs: degrees have 5 bits, and a key has 44.
std::uint64_t GetRank(const ProgramKey& program, std::uint64_t key)
{
  const auto& [kind, degreeS, degreeR] = program;
  return (static_cast<std::uint64_t>(kind) << 10 | static_cast<std::uint64_t>(degreeS) << 5 |
           static_cast<std::uint64_t>(degreeR))
    << 44 |
    key;
}

/// Numbers the keys that it gets, from 0: a hash table with open addressing, since a small part has a key for
/// every fifth item.
class KeyIndex
{
public:
  KeyIndex()
    : Places(1024)
  {
  }

  /// Returns the items of a key, which are new without an example.
  std::uint32_t Find(std::uint64_t key)
  {
    std::uint32_t& place = this->FindPlace(key);
    if (place == 0)
    {
      this->Shapes.push_back({ key, nullptr, 0, 0 });
      place = static_cast<std::uint32_t>(this->Shapes.size());
      if (2 * this->Shapes.size() > this->Places.size())
      {
        this->Grow();
      }
      return static_cast<std::uint32_t>(this->Shapes.size() - 1);
    }
    return place - 1;
  }

  std::vector<KeyedItems> Shapes;

private:
  /// Returns the place of a key, or the free one where it belongs.
  std::uint32_t& FindPlace(std::uint64_t key)
  {
    std::size_t at = static_cast<std::size_t>(key * 0x9e3779b97f4a7c15u >> 32);
    for (;; ++at)
    {
      std::uint32_t& place = this->Places[at & (this->Places.size() - 1)];
      if (place == 0 || this->Shapes[place - 1].Key == key)
      {
        return place;
      }
    }
  }
  void Grow()
  {
    this->Places.assign(2 * this->Places.size(), 0);
    for (std::size_t i = 0; i < this->Shapes.size(); ++i)
    {
      this->FindPlace(this->Shapes[i].Key) = static_cast<std::uint32_t>(i + 1);
    }
  }

  /// Numbers of the keys, from 1; 0: free. Their number is a power of two.
  std::vector<std::uint32_t> Places;
};

/// Consecutive items of the list, which one thread sorts by their keys.
struct ItemChunk
{
  KeyIndex Keys;
  bool HasComparisons = false;

  /// Writes the number of each item's key.
  void Count(const WorkItems& items, const ActiveItems& active, std::size_t begin, std::size_t end,
    std::uint32_t* shapeOf)
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      const WorkItem& item = items[active[i]];
      const std::uint32_t shape = this->Keys.Find(GetShapeKey(item));
      KeyedItems& keyed = this->Keys.Shapes[shape];
      keyed.Example = keyed.Example ? keyed.Example : &item;
      ++keyed.Count;
      shapeOf[i] = shape;
      this->HasComparisons = this->HasComparisons || (item.Work.Detail[0] >> 24 & FlagFirst) == 0;
    }
  }
};
}

WorkList::WorkList(const WorkItems& items, const ActiveItems& active, const PortionLimits& limits)
  : Order(active.size())
{
  std::vector<ItemChunk> chunks((active.size() + ItemsOfChunk - 1) / ItemsOfChunk);
  std::vector<std::uint32_t> shapeOf(active.size());
  const auto forChunks = [&](const auto& work)
  {
    ParallelFor(chunks.size(), 1,
      [&](std::size_t from, std::size_t to)
      {
        for (std::size_t chunk = from; chunk < to; ++chunk)
        {
          work(chunks[chunk], chunk * ItemsOfChunk, std::min((chunk + 1) * ItemsOfChunk, active.size()));
        }
      });
  };
  forChunks([&](ItemChunk& chunk, std::size_t begin, std::size_t end)
    { chunk.Count(items, active, begin, end, shapeOf.data()); });
  KeyIndex all;
  for (const ItemChunk& chunk : chunks)
  {
    this->Comparisons = this->Comparisons || chunk.HasComparisons;
    for (const KeyedItems& shape : chunk.Keys.Shapes)
    {
      KeyedItems& total = all.Shapes[all.Find(shape.Key)];
      total.Example = total.Example ? total.Example : shape.Example;
      total.Count += shape.Count;
    }
  }
  this->AddShapes(all.Shapes, limits);
  // Within a shape the items of a chunk follow those of the chunks before it.
  for (ItemChunk& chunk : chunks)
  {
    for (KeyedItems& shape : chunk.Keys.Shapes)
    {
      std::uint32_t& first = all.Shapes[all.Find(shape.Key)].First;
      shape.First = first;
      first += shape.Count;
    }
  }
  forChunks(
    [&](ItemChunk& chunk, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Order[chunk.Keys.Shapes[shapeOf[i]].First++] = static_cast<std::uint32_t>(i);
      }
    });
}

void WorkList::AddShapes(std::vector<KeyedItems>& shapes, const PortionLimits& limits)
{
  std::vector<std::pair<std::uint64_t, KeyedItems*>> sorted;
  sorted.reserve(shapes.size());
  for (KeyedItems& shape : shapes)
  {
    sorted.emplace_back(GetRank(GetProgram(*shape.Example, limits), shape.Key), &shape);
  }
  std::sort(sorted.begin(), sorted.end());
  std::uint32_t first = 0;
  for (const auto& [rank, shape] : sorted)
  {
    shape->First = first;
    this->AddShape(*shape->Example, first, shape->Count, limits);
    first += shape->Count;
  }
}

void WorkList::AddShape(
  const WorkItem& item, std::uint32_t firstItem, std::uint32_t count, const PortionLimits& limits)
{
  const std::uint32_t nodes = GetNodes(item);
  const std::uint32_t lines = limits.IsSoftware && item.Kind != ItemKind::Panel ? 1u : nodes;
  const std::int64_t costOfItem = std::max<std::int64_t>(item.GetCost(), 1);
  const ProgramKey program = GetProgram(item, limits);
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
