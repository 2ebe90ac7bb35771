/**
 * @file smWorkItems.h
 * @brief Panels, ribbons and caps as records of the GPU's work list
 */
#ifndef smWorkItems_h
#define smWorkItems_h

#include "smFacePanels.h"
#include "smIntegrationOrders.h"
#include "smIntegrationPrograms.h"

#include <cstdint>
#include <vector>

namespace sm
{
struct ResidentFace;

// As smWorkRecord in glsl/smWork.glsl, std430.
struct WorkRecord
{
  std::uint32_t Item[4];
  std::uint32_t Detail[4];
  double Range[4];
};
static_assert(sizeof(WorkRecord) == 64, "layout of smWorkRecord");

struct WorkItem
{
  ProgramKey Program;
  WorkRecord Work;
  /// What the orders of a panel depend on.
  Panel Shape{};
  /// Rung of the ladder of orders.
  int Level = 0;
  /// Cost of an evaluation relative to a bilinear patch.
  int Cost = 1;
};

/// Appends the items of a face, its panels first. `slot` is the face's place in the batch.
void AddItems(const ResidentFace& face, std::uint32_t slot, std::vector<WorkItem>& items);

/// The orders of the item at its level.
Orders GetItemOrders(const OrderLadder& ladder, const WorkItem& item);

/// Writes them into the record. With `mayBisect` an item that does not converge at the last order leaves zeros.
void SetItemOrders(WorkItem& item, const Orders& orders, bool mayBisect);

/// Appends the quarters of a panel, or the halves of a ribbon, at the first level.
void BisectItem(const WorkItem& parent, std::vector<WorkItem>& children);
}

#endif
