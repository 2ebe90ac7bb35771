/**
 * @file smWorkItems.h
 * @brief Panels, ribbons and caps as records of a work list
 */
#ifndef smWorkItems_h
#define smWorkItems_h

#include "smFacePanelsCache.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smIntegrationOrders.h"
#include "smQuadraturePlan.h"

#include <cstdint>
#include <vector>

namespace sm
{

// As smWorkRecord in glsl/smWorkRecord.glsl, std430. Indices are relative to the face.
struct WorkRecord
{
  std::uint32_t Item[4];
  std::uint32_t Detail[4];
  double Range[4];
};
static_assert(sizeof(WorkRecord) == 64, "layout of smWorkRecord");

struct WorkItem
{
  ItemKind Kind = ItemKind::Panel;
  WorkRecord Work;
  /// Degrees of the patch, in s and r.
  int Degree[2] = { 1, 1 };
  /// What the orders of a panel depend on.
  Panel Shape{};
  /// Rung of the ladder of orders.
  int Level = 0;
  /// Of a ribbon: which of the face's coedges, -1: none.
  int Coedge = -1;
  /// Planned to be evaluated twice.
  bool Compared = false;
  /// Cost of an evaluation relative to a bilinear patch.
  int Cost = 1;

  /// Place of the item's face in its batch, and the row of its results.
  std::uint32_t GetSlot() const { return this->Work.Item[3]; }
  std::uint32_t GetRow() const { return this->Work.Item[2]; }
  /// About what evaluating it costs at its orders.
  std::int64_t GetCost() const
  {
    const std::uint32_t detail = this->Work.Detail[0];
    return static_cast<std::int64_t>((detail >> 8) & 255u) * ((detail >> 16) & 255u) * this->Cost;
  }
};

/// Appends the items of a face, its panels first. `slot` is the face's place in the batch.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddItems(
  const CutFace& face, std::uint32_t slot, std::vector<WorkItem>& items);

/// Appends the items of a face's plan, panels, then ribbons, then caps, with their orders: each is evaluated once, with
/// nothing to compare with.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddPlannedItems(
  const CutFace& face, const FacePlan& plan, std::uint32_t slot, std::vector<WorkItem>& items);

/// Doubles the points of an item that was evaluated, to be compared with its row. With `mayBisect` it leaves zeros where it
/// does not converge.
SMFILTERSSURFACEINTEGRALS_EXPORT void DoubleOrders(WorkItem& item, bool mayBisect);
/// The other way round, for the parts of such an item.
SMFILTERSSURFACEINTEGRALS_EXPORT void HalveOrders(WorkItem& item);

/// The orders of the item at its level.
SMFILTERSSURFACEINTEGRALS_EXPORT Orders GetItemOrders(const OrderLadder& ladder, const WorkItem& item);

/// Writes them into the record. With `mayBisect` an item that does not converge at the last order leaves zeros.
SMFILTERSSURFACEINTEGRALS_EXPORT void SetItemOrders(WorkItem& item, const Orders& orders, bool mayBisect);

/// Appends the quarters of a panel, or the halves of a ribbon, at the first level. Each gets the parent's tolerance, halved so
/// many times.
SMFILTERSSURFACEINTEGRALS_EXPORT void BisectItem(
  const WorkItem& parent, int shareHalvings, std::vector<WorkItem>& children);
}

#endif
