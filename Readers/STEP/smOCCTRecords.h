/**
 * @file smOCCTRecords.h
 * @brief Makes the records from which OpenCASCADE loads its model of a STEP file
 */
#ifndef smOCCTRecords_h
#define smOCCTRecords_h

#include "smPart21File.h"
#include "smReadersSTEPModule.h"

#include <IFSelect_WorkLibrary.hxx>
#include <Interface_ParamType.hxx>
#include <Resource_FormatType.hxx>
#include <StepData_StepReaderData.hxx>

#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
/**
 * The records that OpenCASCADE's own lexer and parser would make of the text, in the same order: one for each
 * entity of the header, for each record of an instance, and for each list or typed value within, which comes
 * before the record that has it. They are made in a twentieth of the time.
 */
class SMREADERSSTEP_EXPORT KernelRecords
{
public:
  /// Makes the records. Returns false if OpenCASCADE may read the text differently (damage, a second DATA
  /// section, numbers beyond 31 bits, numbers like 1e5, and enumerations in lower case), so that its own
  /// parser must be used. Instances of types whose flag in `emptied` is set get no parameters.
  bool Make(const Part21File& file, const std::vector<bool>& emptied);

  /// Makes OpenCASCADE's data object, which refers to texts of this object.
  Handle(StepData_StepReaderData) MakeReaderData(Resource_FormatType codePage) const;

private:
  friend class KernelRecordMaker;

  enum class Kind : unsigned char
  {
    Instance, ///< Ident is the position of its number in Bytes
    Part,     ///< an entity of the header, or a record of a complex instance after the first
    List      ///< Ident is its number in the record, from 1
  };
  struct Parameter
  {
    Interface_ParamType Type;
    /// Position in Bytes, or the number of a list.
    std::uint32_t Text;
  };
  struct Record
  {
    Kind IdentKind;
    std::uint32_t Ident;
    /// Position in Bytes; 0 for a list without a type.
    std::uint32_t Type;
    std::uint32_t FirstParameter;
  };

  const char* GetListName(std::uint32_t number) const { return this->ListNames[number].c_str(); }

  /// The text, with a zero byte behind each token.
  std::string Bytes;
  std::vector<Parameter> Parameters;
  /// The records, and one more as the end of the last one's parameters.
  std::vector<Record> Records;
  /// Names of lists: "$1" at index 1, and so on.
  std::vector<std::string> ListNames;
  std::size_t HeaderRecords = 0;
};

/// Makes a library for a session's SetLibrary() that loads the model from `records`, which must outlive the
/// reading, and does not read the stream.
SMREADERSSTEP_EXPORT Handle(IFSelect_WorkLibrary) MakeRecordLibrary(const KernelRecords& records);
}

#endif
