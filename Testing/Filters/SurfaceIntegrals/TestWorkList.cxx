// The order and the portions in which a GPU evaluates items: every item once, those of a shape one after
// another, lines within the limits of a portion, one dispatch for each program of a portion.
#include "Items/smWorkList.h"
#include "smTesting.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace
{
using namespace smtest;

sm::WorkItem MakeItem(std::mt19937& random)
{
  const sm::ItemKind kinds[] = { sm::ItemKind::Panel, sm::ItemKind::Ribbon, sm::ItemKind::Cap };
  sm::WorkItem item{};
  item.Kind = kinds[random() % 3];
  item.Work = {};
  item.Degree[0] = 1 + static_cast<int>(random() % 8);
  item.Degree[1] = 1 + static_cast<int>(random() % 3);
  const std::uint32_t along = 1 + random() % 40;
  const std::uint32_t across = 1 + random() % 5;
  item.Work.Detail[0] = 1u | along << 8 | across << 16 | sm::FlagFirst << 24;
  return item;
}

std::uint32_t GetNodes(const sm::WorkItem& item)
{
  return (item.Work.Detail[0] >> 8) & 255u;
}

void CheckList(const sm::WorkItems& items, const sm::PortionLimits& limits)
{
  std::vector<std::size_t> active(items.size());
  std::iota(active.begin(), active.end(), 0u);
  const sm::WorkList list(items, active, limits);

  std::vector<std::uint32_t> order = list.GetOrder();
  std::sort(order.begin(), order.end());
  bool isComplete = order.size() == items.size();
  for (std::uint32_t i = 0; i < order.size(); ++i)
  {
    isComplete = isComplete && order[i] == i;
  }
  CheckTrue("every item once", isComplete);

  std::int64_t evaluations = 0;
  for (const sm::WorkItem& item : items)
  {
    const std::int64_t across = item.Kind == sm::ItemKind::Panel ? (item.Work.Detail[0] >> 16) & 255u
      : item.Kind == sm::ItemKind::Ribbon                        ? 1
                                                                 : 0;
    evaluations += GetNodes(item) * across;
  }
  CheckEqual("evaluations", evaluations, list.GetEvaluations());

  std::uint32_t nextItem = 0;
  std::uint32_t nextShape = 0;
  bool isInOrder = true;
  bool isAlike = true;
  bool isWithin = true;
  bool isOneDispatch = true;
  for (const sm::WorkPortion& portion : list.GetPortions())
  {
    isInOrder = isInOrder && portion.FirstItem == nextItem && portion.FirstShape == nextShape;
    isWithin = isWithin && (portion.LineCount <= limits.Lines || portion.ItemCount == 1);
    std::uint32_t nextLine = 0;
    for (std::size_t i = 0; i < portion.Ranges.size(); ++i)
    {
      const sm::LineRange& range = portion.Ranges[i];
      isOneDispatch = isOneDispatch && (i == 0 || portion.Ranges[i - 1].Program < range.Program);
      isInOrder = isInOrder && range.FirstLine == nextLine && range.FirstShape == nextShape;
      const std::uint32_t end = range.FirstShape + range.ShapeCount;
      for (; nextShape < end; ++nextShape)
      {
        const sm::WorkShape& shape = list.GetShapes()[nextShape];
        const std::uint32_t lines = shape.LinesOfItem & 0x7fffffffu;
        isInOrder = isInOrder && shape.FirstLine == nextLine && shape.FirstItem == nextItem;
        for (; nextItem < shape.FirstItem + shape.ItemCount; ++nextItem)
        {
          const sm::WorkItem& item = items[list.GetOrder()[nextItem]];
          const bool isWhole = limits.IsSoftware && item.Kind != sm::ItemKind::Panel;
          isAlike = isAlike && lines == (isWhole ? 1u : GetNodes(item)) &&
            (shape.LinesOfItem >> 31 != 0) == (item.Kind == sm::ItemKind::Ribbon) &&
            sm::IntegrationPrograms::ChooseProgram(
              item.Kind, item.Degree[0], item.Degree[1], limits.IsSoftware) == range.Program;
        }
        nextLine += lines * shape.ItemCount;
      }
    }
    isInOrder =
      isInOrder && nextLine == portion.LineCount && nextItem == portion.FirstItem + portion.ItemCount;
  }
  CheckTrue("portions, shapes, items and lines follow one another", isInOrder && nextItem == items.size());
  CheckTrue("items of a shape are alike", isAlike);
  CheckTrue("no portion has more lines", isWithin);
  CheckTrue("a program is dispatched once for a portion", isOneDispatch);
}
}

int TestWorkList(int, char*[])
{
  std::mt19937 random(11);
  for (const std::size_t count : { 0, 1, 7, 2048, 10000 })
  {
    sm::WorkItems items(count);
    std::generate(items.begin(), items.end(), [&random] { return MakeItem(random); });
    CheckList(items, { 1000000000, 1000000, false });
    CheckList(items, { 1000000000, 1000000, true });
    CheckList(items, { 1000000000, 300, false });
    CheckList(items, { 500, 1000000, true });
    CheckList(items, { 1, 20, false });
  }
  return Finish();
}
