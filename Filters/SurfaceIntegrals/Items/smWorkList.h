/**
 * @file smWorkList.h
 * @brief Items of integration in the order and the portions in which the GPU evaluates them; not installed
 */
#ifndef smWorkList_h
#define smWorkList_h

#include "smFiltersSurfaceIntegralsModule.h"
#include "smIntegrationPrograms.h"
#include "smWorkItems.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sm
{
/// Items of one kind, degrees and numbers of points, which lie one after another in the list, in the layout
/// of smShapes in glsl/smLineStorage.glsl. A shape of a larger number of lines than a portion has is there
/// several times.
struct WorkShape
{
  /// The first line is counted from the beginning of the portion.
  std::uint32_t FirstLine, FirstItem, ItemCount, LinesOfItem;
};
static_assert(sizeof(WorkShape) == 16, "layout of a uvec4");

/// The part of a portion that one program evaluates.
struct LineRange
{
  ProgramKey Program;
  std::uint32_t FirstShape, ShapeCount;
  std::uint32_t FirstLine, LineCount;
};

/// Work between two calls of a progress callback.
struct WorkPortion
{
  std::vector<LineRange> Ranges;
  std::uint32_t FirstShape = 0, ShapeCount = 0;
  std::uint32_t FirstItem = 0, ItemCount = 0;
  std::uint32_t LineCount = 0;
};

/// Limits of a portion, which has one item at least.
struct PortionLimits
{
  std::int64_t Cost = 0;
  std::size_t Lines = 0;
  /// True for a processor with few lanes: a ribbon, whose nodes have few samples, is one line there.
  bool IsSoftware = false;
};

/// Items of one key: one of them, how many they are, and the place of the first of them in the list.
struct KeyedItems
{
  std::uint64_t Key;
  const WorkItem* Example;
  std::uint32_t Count;
  std::uint32_t First;
};

/// The order of the items depends on nothing but the items. Shapes are in the order of their programs, so
/// that each program is dispatched once for a portion.
class SMFILTERSSURFACEINTEGRALS_EXPORT WorkList
{
public:
  WorkList(const WorkItems& items, const ActiveItems& active, const PortionLimits& limits);

  /// Indices into `active`, in the order of evaluation.
  const std::vector<std::uint32_t>& GetOrder() const { return this->Order; }
  const std::vector<WorkShape>& GetShapes() const { return this->Shapes; }
  const std::vector<WorkPortion>& GetPortions() const { return this->Portions; }
  /// Returns the largest number of lines of a portion.
  std::size_t GetMaximumLines() const;
  /// Returns the number of points of panels and ribbons.
  std::int64_t GetEvaluations() const { return this->Evaluations; }
  /// Returns true if an item is compared with its row, and may not converge.
  bool HasComparisons() const { return this->Comparisons; }

private:
  /// Sorts the keys by their programs, sets the first place of each, and adds their shapes.
  void AddShapes(std::vector<KeyedItems>& shapes, const PortionLimits& limits);
  /// Adds items that lie one after another and are like this one.
  void AddShape(
    const WorkItem& item, std::uint32_t firstItem, std::uint32_t count, const PortionLimits& limits);

  std::vector<std::uint32_t> Order;
  std::vector<WorkShape> Shapes;
  std::vector<WorkPortion> Portions;
  std::int64_t PortionCost = 0;
  std::int64_t Evaluations = 0;
  bool Comparisons = false;
};
}

#endif
