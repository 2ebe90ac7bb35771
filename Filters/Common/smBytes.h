/**
 * @file smBytes.h
 * @brief Conversion of values to bytes and back, for messages between processes on machines of one kind
 *
 * Numbers are copied in their memory representation, so that doubles are bitwise preserved. A ByteReader
 * never reads beyond the end: after missing or invalid data IsGood() is false, and the requested values are
 * zero.
 */
#ifndef smBytes_h
#define smBytes_h

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace sm
{
using Bytes = std::vector<char>;

class ByteWriter
{
public:
  template <typename Type>
  void Put(const Type& value)
  {
    static_assert(std::is_trivially_copyable_v<Type>, "only plain values have their bytes");
    this->Append(&value, sizeof(Type));
  }
  template <typename Type>
  void PutAll(const std::vector<Type>& values)
  {
    static_assert(std::is_trivially_copyable_v<Type>, "only plain values have their bytes");
    this->Put(static_cast<std::uint64_t>(values.size()));
    this->Append(values.data(), values.size() * sizeof(Type));
  }
  void PutText(const std::string& text) { this->PutBlock(text.data(), text.size()); }
  void PutTexts(const std::vector<std::string>& texts)
  {
    this->Put(static_cast<std::uint64_t>(texts.size()));
    for (const std::string& text : texts)
    {
      this->PutText(text);
    }
  }
  /// Writes `size` bytes and their number.
  void PutBlock(const void* from, std::size_t size)
  {
    this->Put(static_cast<std::uint64_t>(size));
    this->Append(from, size);
  }
  Bytes& GetBytes() { return this->Content; }

private:
  void Append(const void* from, std::size_t size)
  {
    const char* first = static_cast<const char*>(from);
    this->Content.insert(this->Content.end(), first, first + size);
  }

  Bytes Content;
};

class ByteReader
{
public:
  /// The bytes must outlive the reader.
  explicit ByteReader(const Bytes& bytes)
    : Content(bytes)
  {
  }

  template <typename Type>
  Type Get()
  {
    static_assert(std::is_trivially_copyable_v<Type>, "only plain values have their bytes");
    Type value{};
    this->Take(&value, 1, sizeof(Type));
    return value;
  }
  template <typename Type>
  std::vector<Type> GetAll()
  {
    std::vector<Type> values(this->GetCount(sizeof(Type)));
    this->Take(values.data(), values.size(), sizeof(Type));
    return values;
  }
  std::string GetText()
  {
    std::string text(this->GetCount(1), '\0');
    this->Take(text.data(), text.size(), 1);
    return text;
  }
  std::vector<std::string> GetTexts()
  {
    std::vector<std::string> texts(this->GetCount(sizeof(std::uint64_t)));
    for (std::string& text : texts)
    {
      text = this->GetText();
    }
    return texts;
  }
  /// Reads a block of `size` bytes; IsGood() is false if the next one has another size.
  void GetBlock(void* to, std::size_t size)
  {
    this->Good = this->GetCount(1) == size && this->Good;
    this->Take(to, size, 1);
  }
  /// Returns the number of following elements of at least `size` bytes each. If the message is too short for
  /// them, returns 0, and IsGood() is false.
  std::size_t GetCount(std::size_t size)
  {
    const auto count = this->Get<std::uint64_t>();
    this->Good = this->Good && count <= (this->Content.size() - this->At) / size;
    return this->Good ? static_cast<std::size_t>(count) : 0;
  }
  bool IsGood() const { return this->Good; }
  std::size_t GetNumberOfBytesLeft() const { return this->Content.size() - this->At; }
  /// Returns the number of bytes read.
  std::size_t GetPosition() const { return this->At; }

private:
  void Take(void* to, std::size_t count, std::size_t size)
  {
    this->Good = this->Good && count <= (this->Content.size() - this->At) / size;
    if (this->Good && count > 0)
    {
      std::memcpy(to, this->Content.data() + this->At, count * size);
      this->At += count * size;
    }
  }

  const Bytes& Content;
  std::size_t At = 0;
  bool Good = true;
};
}

#endif
