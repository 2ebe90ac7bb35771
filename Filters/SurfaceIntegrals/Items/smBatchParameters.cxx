#include "smBatchParameters.h"

#include "smGaussLegendre.h"

namespace sm
{
BatchParameters::BatchParameters(const std::vector<ItemRunner::BatchFace>& faces, bool usePlacements)
  : Values(GetRuleTable())
{
  this->ToleranceOffset = static_cast<std::uint32_t>(this->Values.size());
  for (const ItemRunner::BatchFace& face : faces)
  {
    this->Values.insert(this->Values.end(), face.Tolerances.begin(), face.Tolerances.end());
  }
  this->PlacementOffset = static_cast<std::uint32_t>(this->Values.size());
  for (std::size_t i = 0; usePlacements && i < faces.size(); ++i)
  {
    this->Values.insert(this->Values.end(), faces[i].Placement.begin(), faces[i].Placement.end());
  }
}
}
