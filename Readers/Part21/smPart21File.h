/**
 * @file smPart21File.h
 * @brief The text of a STEP file (ISO 10303-21) as a graph of entity instances
 */
#ifndef smPart21File_h
#define smPart21File_h

#include "smPart21Values.h"

#include <array>
#include <string>
#include <vector>

namespace sm
{
/// Kinds of defects of a text. They are collected, never thrown: a damaged file is read as far as possible.
enum class Part21Defect : unsigned char
{
  Unopened,           ///< the file cannot be opened or read
  Empty,              ///< it has no bytes
  NoHeader,           ///< "ISO-10303-21;" does not begin within the first 64 KiB
  TooLarge,           ///< 4 GiB or more
  Junk,               ///< bytes before the header that are neither blanks nor comments
  Truncated,          ///< END-ISO-10303-21 is missing
  NoData,             ///< there is no DATA section
  UnterminatedText,   ///< a comment without its end; in an instance a string without its end is Syntax
  Syntax,             ///< an instance is not what the standard allows; the next one is read again
  NotAnInstance,      ///< text between instances that belongs to none
  NumberTooLarge,     ///< an instance or a reference has a number beyond 64 bits
  DuplicateId,        ///< a second instance with the same number; Find() gives the first
  UndefinedReference, ///< a reference to an instance that the file does not have
  ControlCharacters,  ///< bytes below 32 that are not tabs or line ends; they are read as blanks
  UnreadInstance, ///< text with numbers of instances that is skipped, between instances or in a section that
                  ///< is not read
  BehindEnd,      ///< an instance behind END-ISO-10303-21; it is not read
  Count
};

struct Part21Problem
{
  Part21Defect Defect = Part21Defect::Syntax;
  /// Number of the instance that has the defect; 0: none.
  std::uint64_t Id = 0;
  /// For UndefinedReference: the number that is referred to.
  std::uint64_t Other = 0;
  /// Position in the text, in bytes.
  std::size_t Offset = 0;
};

/// A range of elements for range-based loops.
template <typename T>
struct Part21Range
{
  const T* First = nullptr;
  const T* Last = nullptr;

  const T* begin() const { return this->First; }
  const T* end() const { return this->Last; }
  std::size_t size() const { return static_cast<std::size_t>(this->Last - this->First); }
  const T& operator[](std::size_t i) const { return this->First[i]; }
};

/**
 * A STEP file: its instances in the order of the text, their records, and what each refers to.
 *
 * A simple instance `#1=A(…);` has one record, a complex one `#1=(A(…)B(…));` as many as it names. The type
 * of a record and the text of its parameters are kept; Part21Values reads them when they are asked for.
 * References are resolved to indices when the file is read. Instances of all DATA sections are one list;
 * ANCHOR, REFERENCE and SIGNATURE sections (third edition) are passed over. Names of types are compared in
 * capitals.
 *
 * Time and memory are linear in the text, and nothing is called recursively, so that nested brackets do no
 * harm. Memory besides the text: 24 bytes an instance, 12 a record, 4 a reference (12 while reading), 4 to 12
 * for each number. Text of 4 GiB or more is refused.
 *
 * Damage: an instance with a syntax error is kept up to the error, and IsDamaged() is true for it; parsing
 * continues behind its semicolon, or with the next line that begins like an instance. Instances with the same
 * number are all kept, and all are damaged. An instance with an undefined reference is damaged, too. All
 * defects are counted; the first `ProblemLimit` of each kind are listed.
 *
 * Methods throw only std::bad_alloc. Const methods may be called by several threads.
 */
class SMREADERSPART21_EXPORT Part21File
{
public:
  /// Index of an instance.
  using Index = std::uint32_t;
  static constexpr Index None = 0xffffffffu;
  static constexpr std::size_t ProblemLimit = 100;
  /// Number of bytes at the start of a file in which its header is searched. Bytes before the header are
  /// ignored.
  static constexpr std::size_t HeaderSearch = 1 << 16;

  /// Reads a whole file, as UTF-8 (smTextEncoding.h). Returns false if nothing can be read; GetProblems() has
  /// the reason.
  bool Read(const std::string& path);
  /// The same for text in memory. Parts of `chunk` bytes (0: no parts) are read at a time by each thread; the
  /// result does not depend on it.
  bool Parse(std::string text, std::size_t chunk = 1 << 18);

  std::string_view GetText() const { return this->Text; }
  /// Returns the line of a position in the text, from 1, in time proportional to the offset.
  std::size_t GetLine(std::size_t offset) const;

  ///@{
  /** Instances. */
  Index GetNumberOfInstances() const { return static_cast<Index>(this->Instances.size() - 1); }
  std::uint64_t GetId(Index i) const { return this->Instances[i].Id; }
  /// Returns the index of the instance with this number, or None.
  Index Find(std::uint64_t id) const;
  /// Returns the text of an instance from # to the semicolon.
  std::string_view GetText(Index i) const
  {
    return this->Cut(this->Instances[i].Begin, this->Instances[i].End);
  }
  std::size_t GetOffset(Index i) const { return this->Instances[i].Begin; }
  bool IsDamaged(Index i) const { return this->Damaged[i] != 0; }
  /// Returns true if the instance breaks the syntax: the text behind the damage is not read.
  bool IsMalformed(Index i) const { return (this->Damaged[i] & Malformed) != 0; }
  /// Returns the instances to which the parameters of `i` refer, in the order of the text, with None for
  /// undefined ones.
  Part21Range<Index> GetReferences(Index i) const
  {
    const Index* first = this->References.data();
    return { first + this->Instances[i].FirstReference, first + this->Instances[i + 1].FirstReference };
  }
  ///@}

  ///@{
  /** Records: number `record` of instance `i`, one after the other. */
  bool IsComplex(Index i) const { return this->GetNumberOfRecords(i) != 1; }
  std::size_t GetNumberOfRecords(Index i) const
  {
    return this->Instances[i + 1].FirstRecord - this->Instances[i].FirstRecord;
  }
  /// Index into the names of the types.
  std::uint32_t GetType(Index i, std::size_t record = 0) const { return this->GetRecord(i, record).Type; }
  /// The text between the brackets, for Part21Values.
  std::string_view GetParameters(Index i, std::size_t record = 0) const
  {
    return this->Cut(this->GetRecord(i, record).Begin, this->GetRecord(i, record).End);
  }
  ///@}

  /// Names of all types of records in the file, in capitals, in the order in which they appear.
  const std::vector<std::string>& GetTypeNames() const { return this->TypeNames; }
  /// The names in FILE_SCHEMA, as in the file.
  const std::vector<std::string>& GetSchemas() const { return this->Schemas; }

  const std::vector<Part21Problem>& GetProblems() const { return this->Problems; }
  /// Returns the number of defects of a kind, including those that are not listed.
  std::size_t GetNumberOfProblems(Part21Defect defect) const
  {
    return this->Counts[static_cast<std::size_t>(defect)];
  }
  /// Returns a short description of a kind: "undefined reference".
  static const char* GetName(Part21Defect defect);

private:
  friend class Part21Parser;
  /// Reasons why an instance is damaged, as bits.
  static constexpr unsigned char Malformed = 1;
  static constexpr unsigned char Contradictory = 2;

  struct Instance
  {
    std::uint64_t Id;
    std::uint32_t Begin;
    std::uint32_t End;
    std::uint32_t FirstRecord;
    std::uint32_t FirstReference;
  };
  struct Record
  {
    std::uint32_t Type;
    std::uint32_t Begin;
    std::uint32_t End;
  };
  struct SparseId
  {
    std::uint64_t Id;
    Index Instance;
  };
  const Record& GetRecord(Index i, std::size_t record) const
  {
    return this->Records[this->Instances[i].FirstRecord + record];
  }
  std::string_view Cut(std::uint32_t begin, std::uint32_t end) const
  {
    return std::string_view(this->Text).substr(begin, end - begin);
  }
  void Clear();
  void Add(Part21Defect defect, std::size_t offset, std::uint64_t id = 0, std::uint64_t other = 0);
  void IndexIds();
  void Resolve(const std::vector<std::uint64_t>& ids);

  std::string Text;
  /// The instances, and one more as the end of the last one's records and references.
  std::vector<Instance> Instances = std::vector<Instance>(1);
  std::vector<Record> Records;
  std::vector<Index> References;
  std::vector<unsigned char> Damaged;
  /// Instance of each number below its size; larger ones are in SparseIds, sorted.
  std::vector<Index> DenseIds;
  std::vector<SparseId> SparseIds;
  std::vector<std::string> TypeNames;
  std::vector<std::string> Schemas;
  std::vector<Part21Problem> Problems;
  std::array<std::size_t, static_cast<std::size_t>(Part21Defect::Count)> Counts{};
};
}

#endif
