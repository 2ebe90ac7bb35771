/**
 * @file smSelectionTerms.h
 * @brief A selection as ParaView combines it: sets of elements by name, and a Boolean expression of these names
 *
 * Elements are cells of a mesh or rows of a table, numbered from 0 in their block. Blocks are solids, numbered from 0; a table is block 0.
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
  /// What is not in the expression is selected.
  bool IsInverse = false;
};

/// What is selected of a block.
struct SelectedElements
{
  /// True for a selection of the block as a whole, by block or because nothing of it was excluded. Then Elements is empty.
  bool IsWhole = false;
  std::vector<vtkIdType> Elements;
};

/// False for an expression that ParaView refuses, too.
bool IsValid(const SelectionTerms& terms);
/// `count` is the number of elements of the block; those that it does not have are left out.
SelectedElements FindSelectedElements(const SelectionTerms& terms, vtkIdType block, vtkIdType count);

void Write(const SelectionTerms& terms, vtkMultiProcessStream& stream);
void Read(SelectionTerms& terms, vtkMultiProcessStream& stream);
}

#endif
