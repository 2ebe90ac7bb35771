/**
 * @file smJsonText.h
 * @brief Results as the text of a JSON value
 */
#ifndef smJsonText_h
#define smJsonText_h

#include "smFields.h"

#include <string>

namespace sm
{
class JsonText : public Fields
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
  bool Begin(const char* key, bool exists = true) override;
  void End() override { this->Close('}'); }
  std::size_t BeginList(const char* key, std::size_t count) override;
  void EndList() override { this->Close(']'); }
  bool Has(bool exists) override { return exists; }

  const std::string& Get() const { return this->Written; }

private:
  /// Begins a value, with its key in an object.
  void Put(const char* key, const std::string& value);
  void Close(char bracket);

  std::string Written;
};
}

#endif
