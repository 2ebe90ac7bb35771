#include "smSTEPTessellations.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace sm
{
namespace
{
/// Types whose parameters are lists of numbers.
constexpr std::string_view Types[] = { "COMPLEX_TRIANGULATED_FACE", "COMPLEX_TRIANGULATED_SURFACE_SET",
  "COORDINATES_LIST", "CUBIC_BEZIER_TESSELLATED_EDGE", "CUBIC_BEZIER_TRIANGULATED_FACE",
  "TESSELLATED_CONNECTING_EDGE", "TESSELLATED_CURVE_SET", "TESSELLATED_EDGE", "TESSELLATED_POINT_SET",
  "TRIANGULATED_FACE", "TRIANGULATED_SURFACE_SET" };
}

std::vector<bool> FindTessellationTypes(const Part21File& file)
{
  std::vector<bool> tessellated;
  for (const std::string& name : file.GetTypeNames())
  {
    tessellated.push_back(std::find(std::begin(Types), std::end(Types), name) != std::end(Types));
  }
  return tessellated;
}

std::string RemoveTessellations(const Part21File& file)
{
  const std::vector<bool> tessellated = FindTessellationTypes(file);
  const std::string_view text = file.GetText();
  std::string result;
  std::size_t kept = std::min(text.find("ISO-10303-21;"), text.size());
  for (Part21File::Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    if (file.IsComplex(i) || file.IsDamaged(i) || !tessellated[file.GetType(i)])
    {
      continue;
    }
    const std::string_view parameters = file.GetParameters(i);
    const auto begin = static_cast<std::size_t>(parameters.data() - text.data());
    result.append(text, kept, begin - kept);
    kept = begin + parameters.size();
  }
  return result.empty() ? result : result.append(text, kept);
}
}
