#include "smJsonFields.h"

namespace sm
{
void JsonFields::Put(const char* key, Json value)
{
  Json& parent = this->Open.back().second;
  if (parent.is_array())
  {
    parent.push_back(std::move(value));
  }
  else
  {
    parent[key] = std::move(value);
  }
}

void JsonFields::Numbers(const char* key, double* values, std::size_t rows, std::size_t columns)
{
  if (std::isnan(values[0]))
  {
    this->Put(key, nullptr);
    return;
  }
  Json list = Json::array();
  for (std::size_t i = 0; i < rows; ++i)
  {
    Json row(std::vector<double>(values + i * columns, values + (i + 1) * columns));
    if (rows == 1)
    {
      list = std::move(row);
    }
    else
    {
      list.push_back(std::move(row));
    }
  }
  this->Put(key, std::move(list));
}

bool JsonFields::Begin(const char* key, bool exists)
{
  if (exists)
  {
    this->Open.emplace_back(key, Json::object());
  }
  else
  {
    this->Put(key, nullptr);
  }
  return exists;
}

std::size_t JsonFields::BeginList(const char* key, std::size_t count)
{
  this->Open.emplace_back(key, Json::array());
  return count;
}

void JsonFields::End()
{
  auto [key, value] = std::move(this->Open.back());
  this->Open.pop_back();
  this->Put(key, std::move(value));
}
}
