#include "smPolylineText.h"

#include <charconv>
#include <cstddef>
#include <sstream>
#include <system_error>

namespace sm
{
std::string FormatPolylines(const std::vector<std::vector<Vector3>>& polylines)
{
  std::string text;
  for (const std::vector<Vector3>& polyline : polylines)
  {
    for (const Vector3& point : polyline)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        char number[32];
        text.append(number, std::to_chars(number, number + sizeof(number), point[k]).ptr);
        text += ' ';
      }
    }
    text += '\n';
  }
  return text;
}

std::vector<std::vector<Vector3>> ParsePolylines(const std::string& text)
{
  std::vector<std::vector<Vector3>> polylines;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    std::vector<double> numbers;
    const char* at = line.data();
    const char* const end = at + line.size();
    double number = 0.0;
    for (auto read = std::from_chars(at, end, number); read.ec == std::errc();
         read = std::from_chars(at, end, number))
    {
      numbers.push_back(number);
      at = read.ptr < end ? read.ptr + 1 : end;
    }
    polylines.emplace_back();
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    {
      polylines.back().push_back({ numbers[i], numbers[i + 1], numbers[i + 2] });
    }
  }
  return polylines;
}
}
