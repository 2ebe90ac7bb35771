/**
 * @file smSelectionTerms.h
 * @brief A combined selection of ParaView: named sets of elements, and a Boolean expression of these names
 *
 * Elements are cells of a mesh or rows of a table, numbered from 0 in their block. Blocks are solids,
 * numbered from 0; a table is block 0.
 */
#ifndef smSelectionTerms_h
#define smSelectionTerms_h

#include "vtkType.h"

#include <map>
#include <set>
#include <string>
#include <vector>

class vtkMultiProcessStream;

namespace sm
{
struct SelectionSet
{
  std::string Name;
  /// Blocks with all their elements.
  std::set<vtkIdType> Blocks;
  /// Single elements by their block.
  std::map<vtkIdType, std::vector<vtkIdType>> Elements;
};

struct SelectionTerms
{
  std::vector<SelectionSet> Sets;
  /// Names of sets with | & ^ ! and parentheses. Empty: the union of all sets.
  std::string Expression;
  /// True if the elements that are not in the expression are selected.
  bool IsInverse = false;
};

/// The selected elements of a block.
struct SelectedElements
{
  /// True if the expression keeps all elements and a set has the block as a whole, not its single elements.
  /// Then Elements is empty.
  bool IsWhole = false;
  std::vector<vtkIdType> Elements;
};

/// Returns false for an expression that ParaView refuses.
bool IsValid(const SelectionTerms& terms);
/// Returns the selected elements of a block with `count` elements; larger indices are left out.
SelectedElements FindSelectedElements(const SelectionTerms& terms, vtkIdType block, vtkIdType count);

void Write(const SelectionTerms& terms, vtkMultiProcessStream& stream);
void Read(SelectionTerms& terms, vtkMultiProcessStream& stream);
}

#endif
