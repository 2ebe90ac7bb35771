/**
 * @file smFields.h
 * @brief One list of the members of a result, for JSON, for the pipe between processes, and for the reference
 *
 * A result has one function Visit() that names its members in the order of the documents. What it visits with
 * decides what becomes of them: smJsonFields.h writes JSON, smByteFields.h writes bytes and sets the members
 * from bytes.
 */
#ifndef smFields_h
#define smFields_h

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace sm
{
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

/// Numbers and the bound of the error of each; NaN: not known. All numbers are known, or none.
template <std::size_t N>
struct Quantity
{
  std::array<double, N> Value;
  double Bound = Unknown;

  Quantity() { this->Value.fill(Unknown); }
  bool IsKnown() const { return !std::isnan(this->Value[0]); }
  double Get() const { return this->Value[0]; }
};
using ScalarQuantity = Quantity<1>;
using VectorQuantity = Quantity<3>;
using TensorQuantity = Quantity<9>; ///< row-major

/// Writers leave the members as they are; readers set them. A value that is not known is null in JSON.
class Fields
{
public:
  virtual ~Fields() = default;
  /// Unit and meaning of the next key, in Markdown, for the reference; the unit of a bound is that of its
  /// quantity.
  virtual Fields& Note(const char*, const char*) { return *this; }
  /// Not known if it is not finite.
  virtual void Number(const char* key, double& value) = 0;
  /// Numbers in rows, a flat list if there is one row; not known if the first is NaN.
  virtual void Numbers(const char* key, double* values, std::size_t rows, std::size_t columns) = 0;
  /// Not known if it is negative.
  virtual void Count(const char* key, long long& value) = 0;
  virtual void Flag(const char* key, std::optional<bool>& value) = 0;
  virtual void Text(const char* key, std::optional<std::string>& value) = 0;
  virtual void Texts(const char* key, std::vector<std::string>& values) = 0;
  /// Begins an object, or an entry of a list if there is no key. Returns false, and takes no End(), if the
  /// object does not exist.
  virtual bool Begin(const char* key, bool exists = true) = 0;
  virtual void End() = 0;
  /// Returns the number of entries, each of which is an object without key.
  virtual std::size_t BeginList(const char* key, std::size_t count) = 0;
  virtual void EndList() = 0;
  /// Returns whether keys follow that exist only on request.
  virtual bool Has(bool exists) = 0;

  void Text(const char* key, std::string& value)
  {
    std::optional<std::string> text = value;
    this->Text(key, text);
    value = text.value_or("");
  }
  /// An empty text is not known.
  void Name(const char* key, std::string& value)
  {
    std::optional<std::string> text = value.empty() ? std::nullopt : std::optional(value);
    this->Text(key, text);
    value = text.value_or("");
  }
  void Number(const char* key, ScalarQuantity& quantity) { this->Number(key, quantity.Value[0]); }
  void Point(const char* key, std::array<double, 3>& point) { this->Numbers(key, point.data(), 1, 3); }
  void Matrix(const char* key, std::array<double, 9>& matrix) { this->Numbers(key, matrix.data(), 3, 3); }

  template <typename T, typename Use>
  void List(const char* key, std::vector<T>& entries, const Use& use)
  {
    entries.resize(this->BeginList(key, entries.size()));
    for (T& entry : entries)
    {
      if (this->Begin(nullptr))
      {
        use(entry);
        this->End();
      }
    }
    this->EndList();
  }
};
}

#endif
