#include "smPart21Remains.h"

#include "smPart21Cursor.h"

#include <algorithm>
#include <string_view>

namespace sm
{
namespace
{
bool IsBroken(const Part21File& file, bool isUnparsable)
{
  const auto has = [&file](Part21Defect defect) { return file.GetNumberOfProblems(defect) > 0; };
  return (isUnparsable || has(Part21Defect::Syntax) || has(Part21Defect::NotAnInstance) ||
           has(Part21Defect::UnterminatedText) || has(Part21Defect::NumberTooLarge) ||
           has(Part21Defect::ControlCharacters)) &&
    !has(Part21Defect::Truncated) && !has(Part21Defect::NoData) && !has(Part21Defect::BehindEnd) &&
    file.GetNumberOfInstances() > 0;
}

bool IsBelowBlank(char c)
{
  return static_cast<unsigned char>(c) < ' ';
}

/// The schemas as members of a list; what no name of a schema has is left out.
std::string ListSchemas(const Part21File& file)
{
  std::string list;
  for (const std::string& schema : file.GetSchemas())
  {
    if (schema.find('\'') == std::string::npos && std::none_of(schema.begin(), schema.end(), IsBelowBlank))
    {
      list += (list.empty() ? "'" : ",'") + schema + "'";
    }
  }
  return list.empty() ? "''" : list;
}
}

std::string GetRemains(const Part21File& file, const std::vector<bool>& unparsable)
{
  if (!IsBroken(file, !unparsable.empty()))
  {
    return {};
  }
  std::string text = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                     "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA((" +
    ListSchemas(file) + "));\nENDSEC;\nDATA;\n";
  text.reserve(text.size() + file.GetText().size());
  for (Part21File::Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    if (!file.IsMalformed(i) && (unparsable.empty() || !unparsable[i]))
    {
      const std::size_t start = text.size();
      text += file.GetText(i);
      // To the parser of the file these are blanks.
      std::replace_if(text.begin() + static_cast<std::ptrdiff_t>(start), text.end(), IsBelowBlank, ' ');
      text += '\n';
    }
  }
  return text += "ENDSEC;\nEND-ISO-10303-21;\n";
}
}
