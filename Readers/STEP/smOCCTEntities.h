/**
 * @file smOCCTEntities.h
 * @brief The entities of OpenCASCADE's model of a STEP file, by type
 */
#ifndef smOCCTEntities_h
#define smOCCTEntities_h

#include "smReadersSTEPModule.h"

#include <StepData_StepModel.hxx>

#include <functional>
#include <initializer_list>
#include <unordered_map>
#include <vector>

namespace sm
{
/// Returns true if geometry or structure of a body depends on the entity with this number in the file.
using EntityFilter = std::function<bool(int)>;

/// The entities of a model, listed by type in one pass: to ask every entity whether it is of some type takes
/// longer than to parse it. A model whose entities are replaced must not get others of the types sought.
class SMREADERSSTEP_EXPORT ModelEntities
{
public:
  explicit ModelEntities(const Handle(StepData_StepModel) & model);

  const Handle(StepData_StepModel) & GetModel() const { return this->Model; }

  /// Returns the positions in the model, from 1 and in ascending order, of all entities of these types or of
  /// types derived from them.
  std::vector<int> Find(std::initializer_list<Handle(Standard_Type)> types) const;

  /// Calls `visit` with every entity of type T, or of a type derived from it, in their order in the model.
  template <class T, class Visit>
  void ForEach(const Visit& visit) const
  {
    for (const int i : this->Find({ STANDARD_TYPE(T) }))
    {
      visit(Handle(T)::DownCast(this->Model->Value(i)));
    }
  }

  /// The positions of the entities of each type.
  using Lists = std::unordered_map<const Standard_Type*, std::vector<int>>;
  const Lists& GetLists() const { return this->ByType; }

private:
  Handle(StepData_StepModel) Model;
  Lists ByType;
};
}

#endif
