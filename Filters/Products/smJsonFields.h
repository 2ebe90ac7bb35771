/**
 * @file smJsonFields.h
 * @brief Results as JSON
 */
#ifndef smJsonFields_h
#define smJsonFields_h

#include "smFields.h"
#include "smFiltersProductsModule.h"
#include "smJson.h"

#include <utility>
#include <vector>

namespace sm
{
class SMFILTERSPRODUCTS_EXPORT JsonFields : public Fields
{
public:
  using Fields::Number;
  using Fields::Text;
  void Number(const char* key, double& value) override { this->Put(key, MakeNumber(value)); }
  void Numbers(const char* key, double* values, std::size_t rows, std::size_t columns) override;
  void Count(const char* key, long long& value) override { this->Put(key, value < 0 ? Json() : Json(value)); }
  void Flag(const char* key, std::optional<bool>& value) override
  {
    this->Put(key, value ? Json(*value) : Json());
  }
  void Text(const char* key, std::optional<std::string>& value) override
  {
    this->Put(key, value ? Json(*value) : Json());
  }
  void Texts(const char* key, std::vector<std::string>& values) override { this->Put(key, Json(values)); }
  bool Begin(const char* key, bool exists) override;
  void End() override;
  std::size_t BeginList(const char* key, std::size_t count) override;
  void EndList() override { this->End(); }
  bool Has(bool exists) override { return exists; }

  Json Take() { return std::move(this->Open.front().second); }

private:
  void Put(const char* key, Json value);

  /// The objects and lists that are being written, from the outermost, with their keys.
  std::vector<std::pair<const char*, Json>> Open{ { nullptr, Json::object() } };
};

/// Returns the object that `visit(fields)` writes.
template <typename Visit>
Json WriteJsonFields(const Visit& visit)
{
  JsonFields fields;
  visit(fields);
  return fields.Take();
}
}

#endif
