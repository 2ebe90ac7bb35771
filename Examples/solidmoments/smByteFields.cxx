#include "smByteFields.h"

#include "smText.h"

namespace sm
{
void ByteFieldWriter::Number(const char*, double& value)
{
  this->To.Put(value);
}

void ByteFieldWriter::Numbers(const char*, double* values, std::size_t rows, std::size_t columns)
{
  for (std::size_t i = 0; i < rows * columns; ++i)
  {
    this->To.Put(values[i]);
  }
}

void ByteFieldWriter::Count(const char*, long long& value)
{
  this->To.Put(value);
}

void ByteFieldWriter::Flag(const char*, std::optional<bool>& value)
{
  this->To.Put(value ? (*value ? '\2' : '\1') : '\0');
}

void ByteFieldWriter::Text(const char*, std::optional<std::string>& value)
{
  if (this->Has(value.has_value()))
  {
    this->To.PutText(MakeUtf8(*value));
  }
}

void ByteFieldWriter::Texts(const char*, std::vector<std::string>& values)
{
  this->BeginList(nullptr, values.size());
  for (std::string& value : values)
  {
    this->Fields::Text(nullptr, value);
  }
}

std::size_t ByteFieldWriter::BeginList(const char*, std::size_t count)
{
  this->To.Put(static_cast<std::uint64_t>(count));
  return count;
}

bool ByteFieldWriter::Has(bool exists)
{
  this->To.Put(exists ? '\1' : '\0');
  return exists;
}

void ByteFieldReader::Number(const char*, double& value)
{
  value = this->From.Get<double>();
}

void ByteFieldReader::Numbers(const char*, double* values, std::size_t rows, std::size_t columns)
{
  for (std::size_t i = 0; i < rows * columns; ++i)
  {
    values[i] = this->From.Get<double>();
  }
}

void ByteFieldReader::Count(const char*, long long& value)
{
  value = this->From.Get<long long>();
}

void ByteFieldReader::Flag(const char*, std::optional<bool>& value)
{
  const char byte = this->From.Get<char>();
  value = byte == '\0' ? std::nullopt : std::optional(byte == '\2');
}

void ByteFieldReader::Text(const char*, std::optional<std::string>& value)
{
  value = this->Has(false) ? std::optional(this->From.GetText()) : std::nullopt;
}

void ByteFieldReader::Texts(const char*, std::vector<std::string>& values)
{
  values.resize(this->BeginList(nullptr, 0));
  for (std::string& value : values)
  {
    this->Fields::Text(nullptr, value);
  }
}

std::size_t ByteFieldReader::BeginList(const char*, std::size_t)
{
  // Every entry has a byte at least.
  return this->From.GetCount(1);
}

bool ByteFieldReader::Has(bool)
{
  return this->From.Get<char>() == '\1';
}
}
