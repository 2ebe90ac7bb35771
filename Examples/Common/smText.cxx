#include "smText.h"

#include "smFields.h"
#include "smJson.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>
#include <system_error>

namespace sm
{
double ParseNumber(const std::string& text)
{
  const char* end = text.data() + text.size();
  // std::from_chars does not accept a plus sign.
  const bool hasPlus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data() + (hasPlus ? 1 : 0), end, value);
  return error == std::errc() && stop == end ? value : std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> ParseNumbers(const std::string& text)
{
  std::vector<double> numbers;
  for (size_t begin = 0; begin <= text.size();)
  {
    const size_t end = std::min(text.find(',', begin), text.size());
    const double number = ParseNumber(text.substr(begin, end - begin));
    if (number != number)
    {
      return {};
    }
    numbers.push_back(number);
    begin = end + 1;
  }
  return numbers;
}

std::string FormatExact(double number)
{
  return Dump(Json(number));
}

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

std::string TrimEnd(std::string text)
{
  const size_t last = text.find_last_not_of(" \n\r\t");
  text.erase(last == std::string::npos ? 0 : last + 1);
  return text;
}

std::string GetFileName(const std::string& path)
{
  const size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::string GetStem(const std::string& path)
{
  const std::string name = GetFileName(path);
  const size_t dot = name.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

std::string MakeUtf8(const std::string& text)
{
  return Json::parse(Dump(text)).get<std::string>();
}

std::string PercentEncode(const std::string& text)
{
  const char* const digits = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : text)
  {
    const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
      std::string_view("-._~/").find(c) != std::string_view::npos;
    const auto byte = static_cast<unsigned char>(c);
    encoded += isPlain ? std::string(1, c) : std::string{ '%', digits[byte >> 4], digits[byte & 15] };
  }
  return encoded;
}

void VisitFileName(Fields& fields, std::string& name)
{
  fields.Note("", "name of the file").Text("file", name);
  std::optional<std::string> bytes =
    MakeUtf8(name) == name ? std::nullopt : std::optional(PercentEncode(name));
  fields.Note("", "the percent-encoded name of a file whose name is not UTF-8").Text("file_bytes", bytes);
}
}
