#include "smOCCTEntities.h"

#include <algorithm>

namespace sm
{
ModelEntities::ModelEntities(const Handle(StepData_StepModel) & model)
  : Model(model)
{
  const int count = model.IsNull() ? 0 : model->NbEntities();
  for (int i = 1; i <= count; ++i)
  {
    this->ByType[model->Value(i)->DynamicType().get()].push_back(i);
  }
}

std::vector<int> ModelEntities::Find(std::initializer_list<Handle(Standard_Type)> types) const
{
  std::vector<int> found;
  for (const auto& [type, positions] : this->ByType)
  {
    const auto isDerived = [own = type](const Handle(Standard_Type) & base) { return own->SubType(base); };
    if (std::any_of(types.begin(), types.end(), isDerived))
    {
      found.insert(found.end(), positions.begin(), positions.end());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}
}
