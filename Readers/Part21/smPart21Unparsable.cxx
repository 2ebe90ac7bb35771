#include "smPart21Unparsable.h"

#include "smPart21Values.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace sm
{
namespace
{
/// Types of which every list must have members. Empty lists in others, which real files have, are accepted.
constexpr std::string_view TypesWithLists[] = { "CAMERA_MODEL_D3_MULTI_CLIPPING",
  "CONTEXT_DEPENDENT_OVER_RIDING_STYLED_ITEM", "CURVE_BOUNDED_SURFACE", "DATUM_REFERENCE_COMPARTMENT",
  "DATUM_REFERENCE_ELEMENT", "DERIVED_UNIT", "DIRECTION", "EDGE_LOOP", "INVISIBILITY",
  "MEASURE_QUALIFICATION", "OVER_RIDING_STYLED_ITEM", "PRESENTATION_STYLE_BY_CONTEXT",
  "SHELL_BASED_SURFACE_MODEL", "TESSELLATED_GEOMETRIC_SET", "TRIMMED_CURVE", "BOUNDED_SURFACE_CURVE",
  "INTERSECTION_CURVE", "SEAM_CURVE", "SURFACE_CURVE" };
/// The same for all types whose names begin so, or have the word: dates, approvals, persons; splines;
/// tolerances.
constexpr std::string_view PrefixesWithLists[] = { "APPLIED_", "AUTO_DESIGN_", "CC_DESIGN_" };
constexpr std::string_view WordsWithLists[] = { "B_SPLINE_CURVE", "B_SPLINE_SURFACE", "TOLERANCE" };

/// Lists in one another beyond this level are refused; the schemas have three levels.
constexpr std::size_t MaxNestedLists = 100;

bool NeedsMembers(std::string_view type)
{
  return std::find(std::begin(TypesWithLists), std::end(TypesWithLists), type) != std::end(TypesWithLists) ||
    std::any_of(std::begin(PrefixesWithLists), std::end(PrefixesWithLists),
      [type](std::string_view prefix) { return type.substr(0, prefix.size()) == prefix; }) ||
    std::any_of(std::begin(WordsWithLists), std::end(WordsWithLists),
      [type](std::string_view word) { return type.find(word) != std::string_view::npos; });
}

/// Returns false for a text without an empty list; a comment or a string may look like one.
bool MayHaveEmptyList(std::string_view parameters)
{
  for (std::size_t end = parameters.find(')'); end != std::string_view::npos;
       end = parameters.find(')', end + 1))
  {
    const std::size_t before = parameters.find_last_not_of(" \t\r\n", end == 0 ? 0 : end - 1);
    if (before != std::string_view::npos && (parameters[before] == '(' || parameters[before] == '/'))
    {
      return true;
    }
  }
  return false;
}

/// Looks at the parameters and at the members of their lists.
bool HasEmptyList(std::string_view parameters, int levels)
{
  Part21Values values(parameters);
  for (Part21Value value; values.Next(value);)
  {
    Part21Value member;
    if (value.IsList() &&
      (!Part21Values(value.Text).Next(member) || (levels > 1 && HasEmptyList(value.Text, levels - 1))))
    {
      return true;
    }
  }
  return false;
}

/// Returns true for lists in more than MaxNestedLists levels. Brackets in strings and comments are counted
/// only if there are so many.
bool IsDeeplyNested(std::string_view parameters)
{
  std::size_t level = 0;
  std::size_t deepest = 0;
  const auto count = [&level, &deepest](char c)
  {
    level += c == '(' ? 1 : 0;
    level -= c == ')' && level > 0 ? 1 : 0;
    deepest = std::max(deepest, level);
  };
  if (parameters.size() < 2 * MaxNestedLists)
  {
    return false;
  }
  std::for_each(parameters.begin(), parameters.end(), count);
  if (deepest <= MaxNestedLists)
  {
    return false;
  }
  // The same without strings and comments.
  level = 0;
  deepest = 0;
  for (std::size_t at = 0; at < parameters.size(); ++at)
  {
    const bool isComment = parameters.substr(at, 2) == "/*";
    if (isComment || parameters[at] == '\'')
    {
      const std::size_t end = parameters.find(isComment ? "*/" : "'", at + (isComment ? 2 : 1));
      if (end == std::string_view::npos)
      {
        break;
      }
      at = end + (isComment ? 1 : 0);
    }
    else
    {
      count(parameters[at]);
    }
  }
  return deepest > MaxNestedLists;
}
}

std::vector<bool> FindUnparsable(const Part21File& file)
{
  std::vector<bool> needsMembers;
  for (const std::string& type : file.GetTypeNames())
  {
    needsMembers.push_back(NeedsMembers(type));
  }
  std::vector<bool> found;
  for (Part21File::Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    bool isUnparsable = file.GetId(i) > LargestParsedNumber;
    for (std::size_t k = 0; k < file.GetNumberOfRecords(i) && !isUnparsable; ++k)
    {
      constexpr int levels = 2;
      const std::string_view parameters = file.GetParameters(i, k);
      isUnparsable = IsDeeplyNested(parameters) ||
        (needsMembers[file.GetType(i, k)] && MayHaveEmptyList(parameters) &&
          HasEmptyList(parameters, levels));
    }
    if (isUnparsable)
    {
      found.resize(file.GetNumberOfInstances(), false);
      found[i] = true;
    }
  }
  return found;
}
}
