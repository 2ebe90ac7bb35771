#include "Detail/smJsonText.h"

#include "smFormat.h"

namespace sm
{
namespace
{
std::string FormatNumber(double value)
{
  return std::isfinite(value) ? FormatDigits(value, 17) : "null";
}

std::string Quote(const std::string& text)
{
  constexpr char digits[] = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20)
    {
      result += std::string("\\u00") + digits[byte / 16] + digits[byte % 16];
    }
    else
    {
      result += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    }
  }
  return result + "\"";
}
}

void JsonText::Put(const char* key, const std::string& value)
{
  const bool isFirst = this->Written.empty() || this->Written.back() == '{' || this->Written.back() == '[';
  this->Written += (isFirst ? "" : ",") + (key ? Quote(key) + ":" : std::string()) + value;
}

void JsonText::Close(char bracket)
{
  this->Written += bracket;
}

void JsonText::Number(const char* key, double& value)
{
  this->Put(key, FormatNumber(value));
}

void JsonText::Numbers(const char* key, double* values, std::size_t rows, std::size_t columns)
{
  if (std::isnan(values[0]))
  {
    this->Put(key, "null");
    return;
  }
  std::string text;
  for (std::size_t i = 0; i < rows; ++i)
  {
    text += i > 0 ? ",[" : "[";
    for (std::size_t j = 0; j < columns; ++j)
    {
      text += (j > 0 ? "," : "") + FormatNumber(values[i * columns + j]);
    }
    text += "]";
  }
  this->Put(key, rows == 1 ? text : "[" + text + "]");
}

void JsonText::Count(const char* key, long long& value)
{
  this->Put(key, value < 0 ? "null" : std::to_string(value));
}

void JsonText::Flag(const char* key, std::optional<bool>& value)
{
  this->Put(key, !value ? "null" : *value ? "true" : "false");
}

void JsonText::Text(const char* key, std::optional<std::string>& value)
{
  this->Put(key, value ? Quote(*value) : "null");
}

void JsonText::Texts(const char* key, std::vector<std::string>& values)
{
  std::string text;
  for (const std::string& value : values)
  {
    text += (text.empty() ? "" : ",") + Quote(value);
  }
  this->Put(key, "[" + text + "]");
}

bool JsonText::Begin(const char* key, bool exists)
{
  this->Put(key, exists ? "{" : "null");
  return exists;
}

std::size_t JsonText::BeginList(const char* key, std::size_t count)
{
  this->Put(key, "[");
  return count;
}
}
