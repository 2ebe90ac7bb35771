#include "smReportJson.h"

#include "smJsonFields.h"
#include "smReport.h"

#include <algorithm>

namespace sm
{
namespace
{
bool IsFlat(const Json& value)
{
  return std::none_of(value.begin(), value.end(), [](const Json& item) { return item.is_object(); });
}

std::string WriteJson(const Json& value, const std::string& indent)
{
  if ((!value.is_object() && !value.is_array()) || value.empty() || (value.is_array() && IsFlat(value)))
  {
    return Dump(value);
  }
  const std::string inner = indent + "  ";
  std::string text;
  for (auto item = value.begin(); item != value.end(); ++item)
  {
    text += (text.empty() ? "" : ",") + ("\n" + inner) +
      (value.is_object() ? Dump(Json(item.key())) + ": " : "") + WriteJson(*item, inner);
  }
  return (value.is_object() ? "{" : "[") + text + "\n" + indent + (value.is_object() ? "}" : "]");
}

}

Json MakeJson(const FileResult& file)
{
  // A writer changes nothing.
  return WriteJsonFields([&file](Fields& fields) { const_cast<FileResult&>(file).Visit(fields); });
}

std::string FormatJson(const DocumentHead& head, const std::vector<FileResult>& files)
{
  Json document = { { "version", 2 }, { "process_start", head.ProcessStart }, { "files", Json::array() } };
  for (const FileResult& file : files)
  {
    document["files"].push_back(MakeJson(file));
  }
  if (head.HasComparison)
  {
    std::optional<ProductDifference> comparison = head.Comparison;
    document["comparison"] =
      comparison ? WriteJsonFields([&comparison](Fields& fields) { comparison->Visit(fields); }) : Json();
  }
  return WriteJson(document, "") + "\n";
}
}
