/**
 * @file smCountedTexts.h
 * @brief Lists of names in messages, in which a name that occurs several times stands once with its number
 */
#ifndef smCountedTexts_h
#define smCountedTexts_h

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace sm
{
/// Counts texts in the order of their first occurrence.
class CountedTexts
{
public:
  void Add(const std::string& text)
  {
    if (this->Counts[text]++ == 0)
    {
      this->Order.push_back(text);
    }
    ++this->Total;
  }
  std::size_t GetTotal() const { return this->Total; }

  /// Returns the first five: "bolt (3 times), nut and 2 more".
  std::string List() const
  {
    constexpr std::size_t maximum = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(this->Order.size(), maximum); ++i)
    {
      const std::size_t count = this->Counts.at(this->Order[i]);
      text +=
        (i > 0 ? ", " : "") + this->Order[i] + (count > 1 ? " (" + std::to_string(count) + " times)" : "");
    }
    return this->Order.size() > maximum
      ? text + " and " + std::to_string(this->Order.size() - maximum) + " more"
      : text;
  }

private:
  std::vector<std::string> Order;
  std::map<std::string, std::size_t> Counts;
  std::size_t Total = 0;
};
}

#endif
