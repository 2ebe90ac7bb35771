#include "smWorkItems.h"

#include <algorithm>
#include <cstring>

namespace sm
{
namespace
{
/// Bits of the float 1.
constexpr std::uint32_t One = 0x3f800000u;
/// Increment of a float's exponent by one, which doubles it.
constexpr std::uint32_t Doubling = 0x00800000u;

// Flags of a work record, as in glsl/smWorkRecord.glsl.
constexpr std::uint32_t Negative = 1;
constexpr std::uint32_t Flip = 2;
constexpr std::uint32_t AlongEdge = 16;

/// Makes the items of a face, undivided.
class ItemMaker
{
public:
  ItemMaker(const CutFace& face, std::uint32_t slot)
    : Face(face)
    , Slot(slot)
    , Cost(std::max(1, (face.Degree[0] * 4 + face.Degree[1]) / 4))
  {
  }

  WorkItem MakePanel(std::size_t index) const
  {
    const Panel& panel = this->Face.Panels.Panels[index];
    const std::uint32_t flags = (panel.Negative ? Negative : 0u) | (panel.FlipNormal ? Flip : 0u);
    const WorkRecord work = { { panel.Patch, panel.Trim, 0, this->Slot },
      { panel.TrimDegree | flags << 24, 0, 0, One }, { panel.Start, panel.End, 0.0, 1.0 } };
    return this->Make(ItemKind::Panel, work, &panel, -1, this->Cost);
  }
  WorkItem MakeRibbon(std::size_t index) const
  {
    const Ribbon& ribbon = this->Face.Panels.Ribbons[index];
    const std::uint32_t flags = (ribbon.FlipNormal ? Flip : 0u) | (ribbon.AlongEdge ? AlongEdge : 0u);
    const WorkRecord work = { { ribbon.Patch, ribbon.Trim, 0, this->Slot },
      { ribbon.TrimDegree | flags << 24, ribbon.Edge, ribbon.EdgeDegree, One },
      { ribbon.Start, ribbon.End, ribbon.EdgeStart, ribbon.EdgeEnd } };
    return this->Make(ItemKind::Ribbon, work, nullptr, ribbon.Coedge,
      this->Cost + (this->Face.Degree[0] + 1) * (this->Face.Degree[1] + 1));
  }
  WorkItem MakeCap(std::size_t index) const
  {
    const std::uint32_t flags = this->Face.Panels.Caps[index].FlipNormal ? Flip : 0u;
    const WorkRecord work = { { 0, static_cast<std::uint32_t>(9 * index), 0, this->Slot },
      { flags << 24, 0, 0, One }, { 0.0, 1.0, 0.0, 1.0 } };
    return this->Make(ItemKind::Cap, work, nullptr, -1, 1);
  }

private:
  WorkItem Make(ItemKind kind, const WorkRecord& work, const Panel* source, int coedge, int cost) const
  {
    return { kind, work, { this->Face.Degree[0], this->Face.Degree[1] }, source, 0, coedge, false, cost };
  }

  const CutFace& Face;
  const std::uint32_t Slot;
  const int Cost;
};
}

void AddItems(const CutFace& face, std::uint32_t slot, WorkItems& items)
{
  const ItemMaker maker(face, slot);
  items.reserve(items.size() + face.GetNumberOfItems());
  for (std::size_t i = 0; i < face.Panels.Panels.size(); ++i)
  {
    items.push_back(maker.MakePanel(i));
  }
  for (std::size_t i = 0; i < face.Panels.Ribbons.size(); ++i)
  {
    items.push_back(maker.MakeRibbon(i));
  }
  for (std::size_t i = 0; i < face.Panels.Caps.size(); ++i)
  {
    items.push_back(maker.MakeCap(i));
  }
}

void NumberRows(WorkItems& items)
{
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    items[i].Work.Item[2] = static_cast<std::uint32_t>(i);
  }
}

void MakePlannedItems(
  const CutFace& face, const FacePlan& plan, std::uint32_t slot, std::uint32_t row, WorkItem* items)
{
  const ItemMaker maker(face, slot);
  for (const PlannedItem& planned : plan.Items)
  {
    WorkItem& item = *items++;
    item = planned.Kind == ItemKind::Panel ? maker.MakePanel(planned.Index)
      : planned.Kind == ItemKind::Ribbon   ? maker.MakeRibbon(planned.Index)
                                           : maker.MakeCap(planned.Index);
    item.Work.Item[2] = row++;
    double* range = item.Work.Range;
    const double start = range[0];
    const double width = range[1] - start;
    range[0] = start + width * planned.Start;
    range[1] = planned.End == 1.0 ? range[1] : start + width * planned.End;
    if (item.Kind == ItemKind::Panel)
    {
      range[2] = planned.XiStart;
      range[3] = planned.XiEnd;
    }
    else if (item.Kind == ItemKind::Ribbon)
    {
      // The edge's range is divided in proportion to the trim's range.
      const double edgeStart = range[2];
      const double edgeWidth = range[3] - edgeStart;
      range[2] = edgeStart + edgeWidth * planned.Start;
      range[3] = planned.End == 1.0 ? range[3] : edgeStart + edgeWidth * planned.End;
    }
    const auto share = static_cast<float>(planned.Share);
    std::memcpy(&item.Work.Detail[3], &share, sizeof(share));
    item.Compared = planned.Compared;
    SetItemOrders(item, { planned.Along, planned.Across, true, true }, false);
  }
}

void HalveOrders(WorkItem& item)
{
  const std::uint32_t detail = item.Work.Detail[0];
  SetItemOrders(item,
    { static_cast<int>((detail >> 8) & 255u) / 2, static_cast<int>((detail >> 16) & 255u) / 2, true, true },
    false);
}

void DoubleOrders(WorkItem& item, bool mayBisect)
{
  const std::uint32_t detail = item.Work.Detail[0];
  ++item.Level;
  SetItemOrders(item,
    { static_cast<int>(2 * ((detail >> 8) & 255u)), static_cast<int>(2 * ((detail >> 16) & 255u)), false,
      true },
    mayBisect);
}

Orders GetItemOrders(const OrderLadder& ladder, const WorkItem& item)
{
  switch (item.Kind)
  {
    case ItemKind::Panel:
      return ladder.GetPanelOrders(*item.Source, item.Level);
    case ItemKind::Ribbon:
      return ladder.GetRibbonOrders(item.Level);
    default:
      return { ladder.GetStripPoints(), ladder.GetStripPoints(), true, true };
  }
}

void SetItemOrders(WorkItem& item, const Orders& orders, bool mayBisect)
{
  std::uint32_t flags = (item.Work.Detail[0] >> 24) & ~(FlagFirst | FlagDiscard);
  flags |= item.Level == 0 ? FlagFirst : 0u;
  flags |= orders.Last && !orders.Exact && mayBisect ? FlagDiscard : 0u;
  item.Work.Detail[0] = (item.Work.Detail[0] & 255u) | static_cast<std::uint32_t>(orders.Along) << 8 |
    static_cast<std::uint32_t>(orders.Across) << 16 | flags << 24;
}

void BisectItem(const WorkItem& parent, int shareHalvings, WorkItems& children)
{
  const double* range = parent.Work.Range;
  const double middle[2] = { 0.5 * (range[0] + range[1]), 0.5 * (range[2] + range[3]) };
  const bool isPanel = parent.Kind == ItemKind::Panel;
  for (int part = 0; part < (isPanel ? 4 : 2); ++part)
  {
    WorkItem child = parent;
    child.Level = 0;
    child.Work.Detail[3] -= shareHalvings * Doubling;
    child.Work.Range[part & 1 ? 0 : 1] = middle[0];
    // The second range of a ribbon, along the edge's curve, is divided together with the first one; that of a
    // panel is independent.
    const bool upper = isPanel ? part & 2 : part & 1;
    child.Work.Range[upper ? 2 : 3] = middle[1];
    children.push_back(child);
  }
}
}
