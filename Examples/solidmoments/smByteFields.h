/**
 * @file smByteFields.h
 * @brief Results as bytes, for the pipe between two processes of one program
 */
#ifndef smByteFields_h
#define smByteFields_h

#include "smFields.h"

#include <string>

namespace sm
{
/// Appends the members to a text. Bytes of texts that are not UTF-8 are replaced by U+FFFD: names in files
/// may be in any encoding.
class ByteWriter : public Fields
{
public:
  using Fields::Number;
  using Fields::Text;
  void Number(const char* key, double& value) override;
  void Numbers(const char* key, double* values, std::size_t rows, std::size_t columns) override;
  void Count(const char* key, long long& value) override;
  void Flag(const char* key, std::optional<bool>& value) override;
  void Text(const char* key, std::optional<std::string>& value) override;
  void Texts(const char* key, std::vector<std::string>& values) override;
  bool Begin(const char*, bool exists) override { return this->Has(exists); }
  void End() override {}
  std::size_t BeginList(const char* key, std::size_t count) override;
  void EndList() override {}
  bool Has(bool exists) override;

  const std::string& Get() const { return this->Bytes; }

private:
  std::string Bytes;
};

/// Sets the members from the bytes of a ByteWriter. Where these end too early, the rest is unknown and
/// IsWhole() returns false.
class ByteReader : public Fields
{
public:
  explicit ByteReader(std::string bytes)
    : Bytes(std::move(bytes))
  {
  }
  using Fields::Number;
  using Fields::Text;
  void Number(const char* key, double& value) override;
  void Numbers(const char* key, double* values, std::size_t rows, std::size_t columns) override;
  void Count(const char* key, long long& value) override;
  void Flag(const char* key, std::optional<bool>& value) override;
  void Text(const char* key, std::optional<std::string>& value) override;
  void Texts(const char* key, std::vector<std::string>& values) override;
  bool Begin(const char*, bool exists) override { return this->Has(exists); }
  void End() override {}
  std::size_t BeginList(const char* key, std::size_t count) override;
  void EndList() override {}
  bool Has(bool exists) override;

  bool IsWhole() const { return this->At == this->Bytes.size() && !this->IsShort; }

private:
  /// Returns false, and sets nothing, if there are not as many bytes.
  bool Take(void* to, std::size_t size);

  std::string Bytes;
  std::size_t At = 0;
  bool IsShort = false;
};
}

#endif
