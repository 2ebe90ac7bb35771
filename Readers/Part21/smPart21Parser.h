/**
 * @file smPart21Parser.h
 * @brief One pass over the text of a STEP file
 */
#ifndef smPart21Parser_h
#define smPart21Parser_h

#include "smPart21Cursor.h"
#include "smPart21File.h"

#include <cstdint>
#include <vector>

namespace sm
{
/// Fills the instances, records and types of a file whose text is set, and collects the numbers of its references.
class Part21Parser
{
public:
  explicit Part21Parser(Part21File& file);

  /// Begins at the header's first byte.
  void Parse(std::size_t start);

  /// Numbers of all references in the order of the text.
  std::vector<std::uint64_t> References;

private:
  using Index = Part21File::Index;
  std::uint32_t GetOffset(const char* at) const { return static_cast<std::uint32_t>(at - this->Start); }
  bool SkipBlanks();
  bool ParseSection();
  void ParseHeader();
  void ParseInstances();
  void ParseInstance();
  bool ParseRecords();
  bool ParseRecord();
  /// From ( to its ), with every token between checked.
  bool ParseParameters();
  bool ParseValue(std::size_t& depth, bool& nested);
  bool ParseTyped(std::size_t& depth, bool& nested);
  bool ParseReference();
  void FinishInstance(bool valid);
  /// To where reading goes on after damage: behind the next semicolon, or at a line that begins like an instance or ends the section.
  void Recover();
  void SkipSection();
  void FindInstanceBehindEnd();
  std::uint32_t FindType(std::string_view name);
  void GrowTypes();

  Part21File& File;
  const char* Start;
  Part21Cursor Cursor;
  /// Open addressing: index of a type's name plus one, 0 for free.
  std::vector<std::uint32_t> TypeTable = std::vector<std::uint32_t>(1024, 0);
  bool Ended = false;
};
}

#endif
