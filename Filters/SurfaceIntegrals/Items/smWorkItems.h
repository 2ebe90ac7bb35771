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
#include "smUninitializedVector.h"

#include <cstdint>
#include <type_traits>
#include <vector>

namespace sm
{

/// A work item in the layout (std430) of smWorkRecord in glsl/smWorkRecord.glsl. Indices are relative to the
/// face.
struct WorkRecord
{
  std::uint32_t Item[4];
  std::uint32_t Detail[4];
  double Range[4];
};
static_assert(sizeof(WorkRecord) == 64, "layout of smWorkRecord");

///@{
/// Flags of a record that concern the comparison with its row, as in glsl/smWorkRecord.glsl.
constexpr std::uint32_t FlagFirst = 4;
constexpr std::uint32_t FlagDiscard = 8;
///@}

/// A panel, ribbon or cap to evaluate.
struct WorkItem
{
  ItemKind Kind;
  WorkRecord Work;
  /// Degrees of the patch, in s and r.
  int Degree[2];
  /// The panel of the cut face, whose orders depend on it; null for other items.
  const Panel* Source;
  /// Level in the ladder of orders.
  int Level;
  /// Index of the coedge of a ribbon within the face; -1: none.
  int Coedge;
  /// True if the plan evaluates the item at two orders.
  bool Compared;
  /// Cost of an evaluation relative to a bilinear patch.
  int Cost;

  /// Index of the item's face in its batch, and index of the row of its results.
  std::uint32_t GetSlot() const { return this->Work.Item[3]; }
  std::uint32_t GetRow() const { return this->Work.Item[2]; }
  /// Returns true if the item is evaluated by the same code as another one.
  bool HasProgramOf(const WorkItem& other) const
  {
    return this->Kind == other.Kind && this->Degree[0] == other.Degree[0] &&
      this->Degree[1] == other.Degree[1];
  }
  /// Returns the approximate cost of an evaluation of the item at its orders.
  std::int64_t GetCost() const
  {
    const std::uint32_t detail = this->Work.Detail[0];
    return static_cast<std::int64_t>((detail >> 8) & 255u) * ((detail >> 16) & 255u) * this->Cost;
  }
};

/// Trivial, so that a list of items is written once.
using WorkItems = UninitializedVector<WorkItem>;
static_assert(std::is_trivially_default_constructible_v<WorkItem>);

/// Items of a list to evaluate: some, by their indices, or all.
class ActiveItems
{
public:
  ActiveItems(const std::vector<std::size_t>& indices)
    : Indices(indices.data())
    , Count(indices.size())
  {
  }
  explicit ActiveItems(const WorkItems& all)
    : Indices(nullptr)
    , Count(all.size())
  {
  }

  std::size_t size() const { return this->Count; }
  std::size_t operator[](std::size_t i) const { return this->Indices ? this->Indices[i] : i; }

private:
  const std::size_t* Indices;
  std::size_t Count;
};

/// Appends the items of a face, panels first. `slot` is the index of the face in the batch.
SMFILTERSSURFACEINTEGRALS_EXPORT void AddItems(const CutFace& face, std::uint32_t slot, WorkItems& items);

/// Writes the items of a face's plan, as many as it has, panels, then ribbons, then caps, with their orders
/// and with rows from `row` on. Each is evaluated once, without a comparison.
SMFILTERSSURFACEINTEGRALS_EXPORT void MakePlannedItems(
  const CutFace& face, const FacePlan& plan, std::uint32_t slot, std::uint32_t row, WorkItem* items);

/// Sets the row of each item to its place in the list.
SMFILTERSSURFACEINTEGRALS_EXPORT void NumberRows(WorkItems& items);

/// Doubles the points of an item that was evaluated, for a comparison with its row. If `mayBisect` is true,
/// an item that does not converge leaves zeros in its row.
SMFILTERSSURFACEINTEGRALS_EXPORT void DoubleOrders(WorkItem& item, bool mayBisect);
/// Halves the points again, for the parts of such an item.
SMFILTERSSURFACEINTEGRALS_EXPORT void HalveOrders(WorkItem& item);

/// Returns the orders of the item at its level.
SMFILTERSSURFACEINTEGRALS_EXPORT Orders GetItemOrders(const OrderLadder& ladder, const WorkItem& item);

/// Writes the orders into the record. If `mayBisect` is true, an item that does not converge at the last
/// order leaves zeros in its row.
SMFILTERSSURFACEINTEGRALS_EXPORT void SetItemOrders(WorkItem& item, const Orders& orders, bool mayBisect);

/// Appends the quarters of a panel, or the halves of a ribbon, at the first level. The tolerance of each is
/// that of its parent, halved `shareHalvings` times.
SMFILTERSSURFACEINTEGRALS_EXPORT void BisectItem(
  const WorkItem& parent, int shareHalvings, WorkItems& children);
}

#endif
