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
/// Fills the instances, records and types of a file whose text is set, and collects the numbers of its
/// references.
class Part21Parser
{
public:
  explicit Part21Parser(Part21File& file);

  /// Parses the text from the first byte of the header.
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
  /// Parses the parameters of a record from ( to its ), and checks every token between them.
  bool ParseParameters();
  bool ParseValue(std::size_t& depth, bool& nested);
  bool ParseTyped(std::size_t& depth, bool& nested);
  bool ParseReference();
  void FinishInstance(bool valid);
  /// Moves the cursor to where parsing continues after damage: behind the next semicolon, or to a line that
  /// begins like an instance or ends the section.
  void Recover();
  /// Adds UnreadInstance if the text from `begin` to the cursor, which was skipped, has the number of an
  /// instance or a =; with `startsOnly` if an instance begins in it, #1=.
  void ReportSkipped(const char* begin, bool startsOnly);
  void SkipSection();
  void FindInstanceBehindEnd();
  std::uint32_t FindType(std::string_view name);
  void GrowTypes();

  Part21File& File;
  const char* Start;
  Part21Cursor Cursor;
  /// Hash table of type names with open addressing: index of a name plus one; 0 for a free entry.
  std::vector<std::uint32_t> TypeTable = std::vector<std::uint32_t>(1024, 0);
  bool Ended = false;
};
}

#endif
