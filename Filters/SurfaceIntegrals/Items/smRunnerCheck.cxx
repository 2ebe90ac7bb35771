#include "smRunnerCheck.h"

#include "smCPUItemRunner.h"
#include "smFormat.h"
#include "smUnitRoundoff.h"

#include <cmath>

namespace sm
{
namespace
{
/// Evaluates all items; those of each are a face of their own in `totals`.
bool Evaluate(ItemRunner& runner, WorkItems& items, FaceTotals& totals)
{
  NumberRows(items);
  std::vector<RowPart> parts;
  for (std::uint32_t i = 0; i < items.size(); ++i)
  {
    parts.push_back({ i, ItemKind::Panel, -1, i, i + 1 });
  }
  totals = FaceTotals(items.size(), static_cast<std::size_t>(runner.GetLayout().GetNumberOfIntegrands()));
  std::int64_t evaluations = 0;
  std::vector<RowGaps> gaps;
  return runner.BeginRows(items.size()) && runner.Run(items, ActiveItems(items), evaluations, nullptr) &&
    runner.AddUp(parts, totals, gaps);
}

const char* GetKindName(ItemKind kind)
{
  return kind == ItemKind::Panel ? "a panel" : kind == ItemKind::Ribbon ? "a ribbon" : "a cap";
}

/// Returns true if two values are equal within the roundings of both.
bool AreEqual(double a, double b, double roundings)
{
  return std::fabs(a - b) <= 4.0 * roundings + 64.0 * UnitRoundoff * (std::fabs(a) + std::fabs(b)) ||
    (!std::isfinite(a) && !std::isfinite(b));
}
}

std::string FindRunnerDifference(ItemRunner& runner, const ItemRunner::Setup& setup,
  const std::vector<CutFacePointer>& faces, const std::vector<ItemRunner::BatchFace>& batch, WorkItems items)
{
  CPUItemRunner cpu;
  ItemRunner::Setup known = setup;
  known.Integrands.clear();
  std::vector<std::size_t> indices;
  for (std::size_t k = 0; k < setup.Integrands.size(); ++k)
  {
    if (cpu.GetObstacle(setup.Integrands[k]).empty())
    {
      known.Integrands.push_back(setup.Integrands[k]);
      indices.push_back(k);
    }
  }
  FaceTotals own(0, 0);
  if (indices.empty())
  {
    return "";
  }
  if (!Evaluate(runner, items, own))
  {
    return runner.GetError();
  }
  std::vector<CutFacePointer> cut;
  std::vector<ItemRunner::BatchFace> slots;
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    const ItemRunner::BatchFace& face = batch[items[i].GetSlot()];
    cut.push_back(faces[face.Face]);
    slots.push_back({ i, std::vector<double>(indices.size(), 1.0), face.Placement });
    items[i].Work.Item[3] = static_cast<std::uint32_t>(i);
  }
  cpu.Configure(known);
  FaceTotals expected(0, 0);
  if (!cpu.Acquire(cut, nullptr) || !cpu.BeginBatch(slots) || !Evaluate(cpu, items, expected))
  {
    return cpu.GetError();
  }
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    for (std::size_t k = 0; k < indices.size(); ++k)
    {
      const RowTotal& value = own.At(i, indices[k]);
      const RowTotal& right = expected.At(i, k);
      if (!AreEqual(value.Face, right.Face, value.Rounding + right.Rounding))
      {
        return std::string("computes ") + GetKindName(items[i].Kind) +
          " wrong: " + setup.Integrands[indices[k]].Name + " is " + FormatDigits(value.Face, 17) + " for " +
          FormatDigits(right.Face, 17);
      }
    }
  }
  return "";
}
}
