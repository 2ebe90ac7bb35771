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
/**
 * Fills the instances, records and types of a file whose text is set, and collects the numbers of its
 * references.
 *
 * A long DATA section is parsed in chunks, each of which begins with a line that begins like an instance. A
 * chunk is taken only where the parser, coming from the front, arrives at its first byte between two
 * instances: all that parsing depends on is then the same, so that the result is that of one pass. Chunks in
 * which that is not so (they begin in a comment, say) are parsed again.
 */
class Part21Parser
{
public:
  /// `chunk` is the number of bytes in a chunk.
  Part21Parser(Part21File& file, std::size_t chunk);

  /// Parses the text from the first byte of the header.
  void Parse(std::size_t start);

  /// Numbers of all references in the order of the text.
  std::vector<std::uint64_t> References;

private:
  using Index = Part21File::Index;
  struct Chunk;

  /// Parses from one byte, between two instances, on. The text ends for it at another one.
  Part21Parser(Part21File& result, const char* start, Part21Cursor cursor);
  std::uint32_t GetOffset(const char* at) const { return static_cast<std::uint32_t>(at - this->Start); }
  bool SkipBlanks();
  bool ParseSection();
  void ParseHeader();
  void ParseInstances();
  /// Parses instances until one begins at `stop` or behind it. Returns false if the section ends before.
  bool ParseInstancesTo(const char* stop);
  /// Parses instances up to the last bytes of the text. Returns false if the section ends before.
  bool ParseChunks();
  std::vector<Chunk> FindChunks() const;
  void Append(const Chunk& chunk);
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
  std::size_t ChunkSize = 0;
  /// True behind text that belongs to no instance, which is reported.
  bool IsLost = false;
  /// Hash table of type names with open addressing: index of a name plus one; 0 for a free entry.
  std::vector<std::uint32_t> TypeTable = std::vector<std::uint32_t>(1024, 0);
  bool Ended = false;
};
}

#endif
