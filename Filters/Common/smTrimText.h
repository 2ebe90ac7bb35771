/**
 * @file smTrimText.h
 * @brief Text without the blanks around it, and fields of a line; not installed
 */
#ifndef smTrimText_h
#define smTrimText_h

#include <algorithm>
#include <string>
#include <vector>

namespace sm
{
/// Removes spaces, tabs and ends of lines at both ends.
inline std::string Trim(const std::string& text)
{
  const char* const blanks = " \t\r\n";
  const std::string::size_type first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Returns what is between the commas of a line, trimmed: one field at least, perhaps an empty one.
inline std::vector<std::string> SplitFields(const std::string& line)
{
  std::vector<std::string> fields;
  for (std::string::size_type begin = 0; begin <= line.size();)
  {
    const std::string::size_type end = std::min(line.find(',', begin), line.size());
    fields.push_back(Trim(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return fields;
}
}

#endif
