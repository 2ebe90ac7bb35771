#include "smPart21Remains.h"

#include "smPart21Changes.h"
#include "smPart21Cursor.h"

#include <algorithm>
#include <limits>
#include <string_view>

namespace sm
{
namespace
{
bool IsBroken(const Part21File& file, bool isUnparsable)
{
  const auto has = [&file](Part21Defect defect) { return file.GetNumberOfProblems(defect) > 0; };
  return (isUnparsable || file.HasLaterSections() || has(Part21Defect::Syntax) ||
           has(Part21Defect::NotAnInstance) || has(Part21Defect::UnterminatedText) ||
           has(Part21Defect::NumberTooLarge) || has(Part21Defect::ControlCharacters)) &&
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

/// Calls `change` with each reference of an instance to nothing.
template <typename Change>
void VisitUndefined(const Part21File& file, Part21File::Index i, const Change& change)
{
  const std::string_view text = file.GetText(i);
  // The instance's own number is not a reference.
  Part21Cursor cursor{ text.data() + std::min<std::size_t>(1, text.size()), text.data() + text.size() };
  while (cursor.SkipBlanks() && !cursor.IsAtEnd())
  {
    const char* start = cursor.At;
    const char c = cursor.Peek();
    if (c == '#')
    {
      std::uint64_t id = 0;
      bool fits = false;
      if (cursor.SkipReference(id, fits) && (!fits || file.Find(id) == Part21File::None))
      {
        change(std::string_view(start, static_cast<std::size_t>(cursor.At - start)));
      }
    }
    else if (c == '\'' || c == '"')
    {
      c == '"' ? cursor.SkipBinary() : cursor.SkipString();
    }
    else
    {
      ++cursor.At;
    }
  }
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

std::string ReplaceUndefinedReferences(const Part21File& file)
{
  if (file.GetNumberOfProblems(Part21Defect::UndefinedReference) == 0)
  {
    return {};
  }
  std::uint64_t number = std::numeric_limits<std::int32_t>::max();
  while (file.Find(number) != Part21File::None)
  {
    --number;
  }
  const std::string free = "#" + std::to_string(number);
  Part21Changes changes(file);
  for (Part21File::Index i = 0; i < file.GetNumberOfInstances(); ++i)
  {
    const Part21Range<Part21File::Index> references = file.GetReferences(i);
    if (std::find(references.begin(), references.end(), Part21File::None) != references.end())
    {
      VisitUndefined(file, i, [&](std::string_view reference) { changes.Replace(reference, free); });
    }
  }
  return changes.Apply();
}
}
