#include "smByteFields.h"

#include "smText.h"

#include <algorithm>
#include <cstring>

namespace sm
{
namespace
{
template <typename T>
void Append(std::string& bytes, const T& value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}
}

void ByteWriter::Number(const char*, double& value)
{
  Append(this->Bytes, value);
}

void ByteWriter::Numbers(const char*, double* values, std::size_t rows, std::size_t columns)
{
  this->Bytes.append(reinterpret_cast<const char*>(values), rows * columns * sizeof(double));
}

void ByteWriter::Count(const char*, long long& value)
{
  Append(this->Bytes, value);
}

void ByteWriter::Flag(const char*, std::optional<bool>& value)
{
  this->Bytes += value ? (*value ? '\2' : '\1') : '\0';
}

void ByteWriter::Text(const char*, std::optional<std::string>& value)
{
  if (this->Has(value.has_value()))
  {
    const std::string text = MakeUtf8(*value);
    this->BeginList(nullptr, text.size());
    this->Bytes += text;
  }
}

void ByteWriter::Texts(const char*, std::vector<std::string>& values)
{
  this->BeginList(nullptr, values.size());
  for (std::string& value : values)
  {
    this->Fields::Text(nullptr, value);
  }
}

std::size_t ByteWriter::BeginList(const char*, std::size_t count)
{
  Append(this->Bytes, count);
  return count;
}

bool ByteWriter::Has(bool exists)
{
  this->Bytes += exists ? '\1' : '\0';
  return exists;
}

bool ByteReader::Take(void* to, std::size_t size)
{
  this->IsShort = this->IsShort || size > this->Bytes.size() - this->At;
  if (!this->IsShort)
  {
    std::memcpy(to, this->Bytes.data() + this->At, size);
    this->At += size;
  }
  return !this->IsShort;
}

void ByteReader::Number(const char*, double& value)
{
  this->Take(&value, sizeof(value));
}

void ByteReader::Numbers(const char*, double* values, std::size_t rows, std::size_t columns)
{
  this->Take(values, rows * columns * sizeof(double));
}

void ByteReader::Count(const char*, long long& value)
{
  this->Take(&value, sizeof(value));
}

void ByteReader::Flag(const char*, std::optional<bool>& value)
{
  char byte = '\0';
  this->Take(&byte, 1);
  value = byte == '\0' ? std::nullopt : std::optional(byte == '\2');
}

void ByteReader::Text(const char*, std::optional<std::string>& value)
{
  value = std::nullopt;
  if (this->Has(false))
  {
    std::string text(this->BeginList(nullptr, 0), '\0');
    this->Take(text.data(), text.size());
    value = std::move(text);
  }
}

void ByteReader::Texts(const char*, std::vector<std::string>& values)
{
  values.resize(this->BeginList(nullptr, 0));
  for (std::string& value : values)
  {
    this->Fields::Text(nullptr, value);
  }
}

std::size_t ByteReader::BeginList(const char*, std::size_t)
{
  // Every entry has a byte at least.
  std::size_t count = 0;
  this->Take(&count, sizeof(count));
  this->IsShort = this->IsShort || count > this->Bytes.size() - this->At;
  return this->IsShort ? 0 : count;
}

bool ByteReader::Has(bool)
{
  char byte = '\0';
  this->Take(&byte, 1);
  return byte == '\1';
}
}
