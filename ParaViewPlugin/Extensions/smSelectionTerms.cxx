#include "smSelectionTerms.h"

#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSignedCharArray.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace sm
{
namespace
{
/// Returns true if single elements of the block are in a set.
bool HasElements(const SelectionTerms& terms, vtkIdType block)
{
  return std::any_of(terms.Sets.begin(), terms.Sets.end(),
    [block](const SelectionSet& set) { return set.Elements.count(block) > 0; });
}

bool HasBlock(const SelectionTerms& terms, vtkIdType block)
{
  return std::any_of(terms.Sets.begin(), terms.Sets.end(),
    [block](const SelectionSet& set) { return set.Blocks.count(block) > 0; });
}

vtkSmartPointer<vtkSignedCharArray> MakeMask(const SelectionSet& set, vtkIdType block, vtkIdType count)
{
  vtkNew<vtkSignedCharArray> mask;
  mask->SetNumberOfValues(count);
  mask->FillValue(set.Blocks.count(block) > 0 ? 1 : 0);
  const auto found = set.Elements.find(block);
  if (found != set.Elements.end())
  {
    for (const vtkIdType element : found->second)
    {
      if (element >= 0 && element < count)
      {
        mask->SetValue(element, 1);
      }
    }
  }
  return mask;
}

/// Returns 1 for each selected element of a block; null for an invalid expression.
vtkSmartPointer<vtkSignedCharArray> Evaluate(const SelectionTerms& terms, vtkIdType block, vtkIdType count)
{
  // The expression is evaluated by vtkSelection.
  vtkNew<vtkSelection> selection;
  std::map<std::string, vtkSmartPointer<vtkSignedCharArray>> masks;
  std::string sum;
  for (const SelectionSet& set : terms.Sets)
  {
    selection->SetNode(set.Name, vtkNew<vtkSelectionNode>());
    masks[set.Name] = MakeMask(set, block, count);
    sum += (sum.empty() ? "" : "|") + set.Name;
  }
  const std::string expression = terms.Expression.empty() ? sum : terms.Expression;
  selection->SetExpression(terms.IsInverse ? "!(" + expression + ")" : expression);
  return selection->Evaluate(masks);
}

void WriteNumber(vtkMultiProcessStream& stream, std::size_t number)
{
  stream << static_cast<vtkTypeInt64>(number);
}

vtkTypeInt64 ReadNumber(vtkMultiProcessStream& stream)
{
  vtkTypeInt64 number = 0;
  stream >> number;
  return number;
}
}

bool IsValid(const SelectionTerms& terms)
{
  const auto mask = terms.Sets.empty() ? nullptr : Evaluate(terms, 0, 1);
  return terms.Sets.empty() || (mask && mask->GetNumberOfValues() == 1);
}

SelectedElements FindSelectedElements(const SelectionTerms& terms, vtkIdType block, vtkIdType count)
{
  SelectedElements selected;
  if (terms.Sets.empty() || count <= 0)
  {
    return selected;
  }
  const bool isUniform = !HasElements(terms, block);
  const auto mask = Evaluate(terms, block, isUniform ? 1 : count);
  if (!mask || mask->GetNumberOfValues() == 0)
  {
    return selected;
  }
  if (isUniform)
  {
    selected.IsWhole = mask->GetValue(0) != 0;
    return selected;
  }
  for (vtkIdType element = 0; element < mask->GetNumberOfValues(); ++element)
  {
    if (mask->GetValue(element) != 0)
    {
      selected.Elements.push_back(element);
    }
  }
  selected.IsWhole = static_cast<vtkIdType>(selected.Elements.size()) == count && HasBlock(terms, block);
  if (selected.IsWhole)
  {
    selected.Elements.clear();
  }
  return selected;
}

void Write(const SelectionTerms& terms, vtkMultiProcessStream& stream)
{
  stream << terms.Expression << static_cast<int>(terms.IsInverse);
  WriteNumber(stream, terms.Sets.size());
  for (const SelectionSet& set : terms.Sets)
  {
    stream << set.Name;
    WriteNumber(stream, set.Blocks.size());
    for (const vtkIdType block : set.Blocks)
    {
      stream << static_cast<vtkTypeInt64>(block);
    }
    WriteNumber(stream, set.Elements.size());
    for (const auto& [block, elements] : set.Elements)
    {
      stream << static_cast<vtkTypeInt64>(block);
      WriteNumber(stream, elements.size());
      for (const vtkIdType element : elements)
      {
        stream << static_cast<vtkTypeInt64>(element);
      }
    }
  }
}

void Read(SelectionTerms& terms, vtkMultiProcessStream& stream)
{
  int isInverse = 0;
  stream >> terms.Expression >> isInverse;
  terms.IsInverse = isInverse != 0;
  terms.Sets.resize(static_cast<std::size_t>(ReadNumber(stream)));
  for (SelectionSet& set : terms.Sets)
  {
    stream >> set.Name;
    set.Blocks.clear();
    for (vtkTypeInt64 left = ReadNumber(stream); left > 0; --left)
    {
      set.Blocks.insert(ReadNumber(stream));
    }
    set.Elements.clear();
    for (vtkTypeInt64 left = ReadNumber(stream); left > 0; --left)
    {
      std::vector<vtkIdType>& elements = set.Elements[ReadNumber(stream)];
      elements.resize(static_cast<std::size_t>(ReadNumber(stream)));
      for (vtkIdType& element : elements)
      {
        element = ReadNumber(stream);
      }
    }
  }
}
}
