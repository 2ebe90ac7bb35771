/**
 * @file smFirstOfSeveral.h
 * @brief A message about the first of several entities
 */
#ifndef smFirstOfSeveral_h
#define smFirstOfSeveral_h

#include <string>
#include <vector>

namespace sm
{
/// A message about the first of several entities, and the number of the others.
class FirstOfSeveral
{
public:
  template <class Describe>
  void Add(const Describe& describe)
  {
    this->Others += this->First.empty() ? 0 : 1;
    this->First = this->First.empty() ? describe() : this->First;
  }
  void Report(std::vector<std::string>& messages) const
  {
    if (!this->First.empty())
    {
      messages.push_back(
        this->First + (this->Others > 0 ? " So it is with " + std::to_string(this->Others) + " more." : ""));
    }
  }

private:
  std::string First;
  int Others = 0;
};
}

#endif
