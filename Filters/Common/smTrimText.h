/**
 * @file smTrimText.h
 * @brief Text without the blanks around it; not installed
 */
#ifndef smTrimText_h
#define smTrimText_h

#include <string>

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
}

#endif
