/**
 * @file smPart21Changes.h
 * @brief Changes of the text of a STEP file
 */
#ifndef smPart21Changes_h
#define smPart21Changes_h

#include "smPart21File.h"

#include <string>
#include <string_view>
#include <vector>

namespace sm
{
/// Changes of a text, and new instances with numbers that it does not have.
class Part21Changes
{
public:
  explicit Part21Changes(const Part21File& file)
    : File(file)
  {
  }

  /// Replaces a part of the file's text. Parts must not overlap.
  void Replace(std::string_view part, std::string text);

  /// Adds an instance and returns its name, "#12".
  std::string Add(const std::string& entity);

  /// Returns the text with the changes; empty if nothing was replaced.
  std::string Apply();

private:
  struct Change
  {
    std::size_t Offset;
    std::size_t Size;
    std::string Text;
  };

  /// Returns a number that no instance and no reference has. Numbers in strings and comments are avoided,
  /// too.
  std::uint64_t GetFreeNumber();
  void FindNumbers();

  const Part21File& File;
  std::vector<Change> Changes;
  std::string Added;
  std::uint64_t Next = 0;
  /// The numbers in the text, sorted, if new ones must be found between them.
  std::vector<std::uint64_t> Numbers;
};
}

#endif
