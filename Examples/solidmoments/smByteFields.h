/**
 * @file smByteFields.h
 * @brief Results as bytes, for the pipe between two processes of one program
 */
#ifndef smByteFields_h
#define smByteFields_h

#include "smBytes.h"
#include "smFields.h"

#include <string>

namespace sm
{
/// Appends the members to bytes. Bytes of texts that are not UTF-8 are replaced by U+FFFD: names in files
/// may be in any encoding.
class ByteFieldWriter : public Fields
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

  const Bytes& Get() { return this->To.GetBytes(); }

private:
  ByteWriter To;
};

/// Sets the members from the bytes of a ByteFieldWriter. If these end too early, IsWhole() returns false.
class ByteFieldReader : public Fields
{
public:
  explicit ByteFieldReader(Bytes bytes)
    : Content(std::move(bytes))
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

  bool IsWhole() const { return this->From.IsGood() && this->From.GetNumberOfBytesLeft() == 0; }

private:
  Bytes Content;
  ByteReader From{ this->Content };
};
}

#endif
