#include "smOCCTRecords.h"

#include "smPart21Cursor.h"

#include <Standard_OutOfMemory.hxx>
#include <StepData_FileRecognizer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepReaderTool.hxx>
#include <StepSelect_WorkLibrary.hxx>

#include <limits>
#include <new>
#include <string_view>
#include <utility>

namespace sm
{
namespace
{
/// The type name that OpenCASCADE's parser gives to a list.
constexpr const char* ListType = "/* (SUB) */";

/// The number of records of the header, and of the parts of complex instances after the first.
constexpr const char* NoIdent = "#0";

bool HasOnly(std::string_view text, const char* characters)
{
  return !text.empty() && text.find_first_not_of(characters) == std::string_view::npos;
}

/// Returns the kind that OpenCASCADE's lexer gives to a number; Interface_ParamMisc if it does not accept it
/// as a number.
Interface_ParamType GetNumberType(std::string_view number, bool real)
{
  const std::size_t exponent = number.find_first_of("Ee");
  return !real                                                                        ? Interface_ParamInteger
    : exponent == std::string_view::npos || (exponent > 1 && number[exponent] == 'E') ? Interface_ParamReal
                                                                                      : Interface_ParamMisc;
}

bool IsPlain(const Part21File& file)
{
  for (int defect = 0; defect < static_cast<int>(Part21Defect::Count); ++defect)
  {
    const auto kind = static_cast<Part21Defect>(defect);
    if (kind != Part21Defect::UndefinedReference && kind != Part21Defect::Junk &&
      file.GetNumberOfProblems(kind) > 0)
    {
      return false;
    }
  }
  return file.GetNumberOfInstances() > 0 && file.GetText().size() < std::numeric_limits<std::uint32_t>::max();
}

class RecordLibrary : public StepSelect_WorkLibrary
{
public:
  explicit RecordLibrary(const KernelRecords& records)
    : Records(records)
  {
  }

  Standard_Integer ReadStream(Standard_CString, std::istream&, Handle(Interface_InterfaceModel) & model,
    const Handle(Interface_Protocol) & general) const override
  {
    try
    {
      return this->Load(model, general);
    }
    catch (const Standard_OutOfMemory&)
    {
      // The session takes OpenCASCADE's exceptions for damage of the file, and lets others pass.
      throw std::bad_alloc();
    }
  }

private:
  Standard_Integer Load(
    Handle(Interface_InterfaceModel) & model, const Handle(Interface_Protocol) & general) const
  {
    const auto protocol = Handle(StepData_Protocol)::DownCast(general);
    auto step = Handle(StepData_StepModel)::DownCast(model);
    if (step.IsNull())
    {
      step = new StepData_StepModel();
    }
    model = step;
    StepData_StepReaderTool tool(this->Records.MakeReaderData(step->SourceCodePage()), protocol);
    tool.SetErrorHandle(true);
    const Handle(StepData_FileRecognizer) none;
    tool.PrepareHeader(none);
    tool.Prepare(none);
    tool.LoadModel(step);
    if (step->Protocol().IsNull())
    {
      step->SetProtocol(protocol);
    }
    tool.Clear();
    return 0;
  }

  const KernelRecords& Records;
};
}

/// Reads the text once and fills the records.
class KernelRecordMaker
{
public:
  using Kind = KernelRecords::Kind;

  KernelRecordMaker(const Part21File& file, KernelRecords& result)
    : File(file)
    , Result(result)
    , Text(file.GetText())
    , Cursor{ this->Text.data(), this->Text.data() + this->Text.size() }
  {
    this->Result.Bytes = this->Text;
  }

  bool Run(const std::vector<bool>& emptied)
  {
    if (!this->ReadHeader())
    {
      return false;
    }
    this->Result.HeaderRecords = this->Result.Records.size();
    for (Part21File::Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      // Other text than blanks between instances, such as the end of a section, is left to OpenCASCADE.
      if (!this->Cursor.SkipBlanks() || this->GetPlace() != this->File.GetOffset(i) ||
        !this->ReadInstance(i, emptied))
      {
        return false;
      }
    }
    constexpr std::size_t most = std::numeric_limits<int>::max();
    const bool isAll =
      this->SkipWord("ENDSEC") && this->Result.Records.size() < most && this->Result.Parameters.size() < most;
    this->AddRecord(Kind::Part, 0, 0);
    return isAll;
  }

private:
  /// A list whose closing bracket has not been read; the outermost one is the record.
  struct OpenList
  {
    Kind IdentKind;
    std::uint32_t Ident;
    std::uint32_t Type;
    std::size_t FirstParameter;
  };

  std::uint32_t GetPlace() const { return static_cast<std::uint32_t>(this->Cursor.At - this->Text.data()); }

  void AddRecord(Kind kind, std::uint32_t ident, std::uint32_t type)
  {
    this->Result.Records.push_back(
      { kind, ident, type, static_cast<std::uint32_t>(this->Result.Parameters.size()) });
  }

  bool SkipWord(std::string_view word)
  {
    return this->Cursor.SkipBlanks() && this->Cursor.SkipKeyword() == word && this->Skip(';');
  }

  bool Skip(char c)
  {
    const bool isThere = this->Cursor.SkipBlanks() && this->Cursor.Peek() == c;
    this->Cursor.At += isThere ? 1 : 0;
    return isThere;
  }

  /// Writes the zero byte behind the token that ends here, in the copy of the text.
  void EndToken() { this->Result.Bytes[this->GetPlace()] = '\0'; }

  bool ReadHeader()
  {
    const std::size_t start = this->Text.find("ISO-10303-21;");
    if (start == std::string_view::npos)
    {
      return false;
    }
    this->Cursor.At += start + std::string_view("ISO-10303-21;").size();
    if (!this->SkipWord("HEADER"))
    {
      return false;
    }
    for (;;)
    {
      if (!this->Cursor.SkipBlanks())
      {
        return false;
      }
      const std::uint32_t place = this->GetPlace();
      const std::string_view name = this->Cursor.SkipKeyword();
      if (name == "ENDSEC")
      {
        return this->Skip(';') && this->SkipWord("DATA");
      }
      this->EndToken();
      if (name.empty() || !this->ReadParameters({ Kind::Part, 0, place, 0 }) || !this->Skip(';'))
      {
        return false;
      }
    }
  }

  bool ReadInstance(Part21File::Index i, const std::vector<bool>& emptied)
  {
    const std::uint32_t number = this->GetPlace();
    if (!this->ReadReference())
    {
      return false;
    }
    if (!this->Skip('='))
    {
      return false;
    }
    const bool isComplex = this->Skip('(');
    const bool isEmptied = !isComplex && !this->File.IsDamaged(i) && emptied[this->File.GetType(i)];
    Kind kind = Kind::Instance;
    do
    {
      this->Cursor.SkipBlanks();
      const std::uint32_t type = this->GetPlace();
      if (this->Cursor.SkipKeyword().empty())
      {
        return false;
      }
      this->EndToken();
      if (isEmptied)
      {
        this->AddRecord(kind, number, type);
        const std::string_view parameters = this->File.GetParameters(i);
        this->Cursor.At = parameters.data() + parameters.size() + 1;
      }
      else if (!this->ReadParameters({ kind, number, type, 0 }))
      {
        return false;
      }
      kind = Kind::Part;
    } while (isComplex && !this->Skip(')'));
    return this->Skip(';');
  }

  /// Reads the parameters of a record from its bracket on. A list is recorded when its bracket closes; until
  /// then its parameters are in Waiting.
  bool ReadParameters(OpenList record)
  {
    if (!this->Skip('('))
    {
      return false;
    }
    this->Waiting.clear();
    this->Open.assign(1, record);
    std::uint32_t lists = 0;
    bool isExpected = true;
    while (!this->Open.empty())
    {
      if (!this->Cursor.SkipBlanks())
      {
        return false;
      }
      const char c = this->Cursor.Peek();
      const bool isEmpty = this->Open.back().FirstParameter == this->Waiting.size();
      if (c == ')' && (!isExpected || isEmpty))
      {
        ++this->Cursor.At;
        this->CloseList();
        isExpected = false;
      }
      else if (c == ',' && !isExpected)
      {
        ++this->Cursor.At;
        isExpected = true;
      }
      else if (!isExpected)
      {
        return false;
      }
      else if (c == '(' || c == '!' || IsPart21(c, Part21Letter))
      {
        const std::uint32_t type = c == '(' ? 0 : this->GetPlace();
        this->Cursor.SkipKeyword();
        if (type != 0)
        {
          this->EndToken();
        }
        this->Open.push_back({ Kind::List, ++lists, type, this->Waiting.size() });
        if (!this->Skip('('))
        {
          return false;
        }
      }
      else if (!this->ReadValue(c))
      {
        return false;
      }
      else
      {
        isExpected = false;
      }
    }
    return true;
  }

  void CloseList()
  {
    const OpenList list = this->Open.back();
    this->Open.pop_back();
    this->AddRecord(list.IdentKind, list.Ident, list.Type);
    const auto first = this->Waiting.begin() + static_cast<std::ptrdiff_t>(list.FirstParameter);
    this->Result.Parameters.insert(this->Result.Parameters.end(), first, this->Waiting.end());
    this->Waiting.erase(first, this->Waiting.end());
    if (list.IdentKind == Kind::List)
    {
      this->Waiting.push_back({ Interface_ParamSub, list.Ident });
      while (this->Result.ListNames.size() <= list.Ident)
      {
        this->Result.ListNames.push_back("$" + std::to_string(this->Result.ListNames.size()));
      }
    }
  }

  /// Reads # and a number of at most 31 bits that is not 0.
  bool ReadReference()
  {
    std::uint64_t id = 0;
    bool fits = false;
    const bool isRead = this->Cursor.Peek() == '#' && this->Cursor.SkipReference(id, fits) && fits &&
      id > 0 && id <= static_cast<std::uint64_t>(std::numeric_limits<int>::max());
    this->EndToken();
    return isRead;
  }

  bool ReadValue(char c)
  {
    const char* begin = this->Cursor.At;
    const std::uint32_t place = this->GetPlace();
    const auto getToken = [&](std::size_t ends)
    { return std::string_view(begin + ends, static_cast<std::size_t>(this->Cursor.At - begin) - 2 * ends); };
    const bool isPoint = c == '.' && this->Cursor.End - begin > 1 && !IsPart21(begin[1], Part21Digit);
    Interface_ParamType type = Interface_ParamMisc;
    bool isRead = true;
    bool isReal = false;
    if (c == '#')
    {
      type = Interface_ParamIdent;
      isRead = this->ReadReference();
    }
    else if (c == '\'')
    {
      type = Interface_ParamText;
      isRead = this->Cursor.SkipString();
    }
    else if (c == '$' || c == '*')
    {
      type = c == '$' ? Interface_ParamVoid : Interface_ParamMisc;
      ++this->Cursor.At;
    }
    else if (isPoint)
    {
      type = Interface_ParamEnum;
      isRead =
        this->Cursor.SkipEnumeration() && HasOnly(getToken(1), "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
    }
    else if (c == '"')
    {
      type = Interface_ParamHexa;
      isRead = this->Cursor.SkipBinary() && HasOnly(getToken(1), "0123456789ABCDEF");
    }
    else
    {
      isRead = this->Cursor.SkipNumber(isReal);
      type = isRead ? GetNumberType(getToken(0), isReal) : type;
      isRead = isRead && type != Interface_ParamMisc;
    }
    if (isRead)
    {
      this->EndToken();
      this->Waiting.push_back({ type, place });
    }
    return isRead;
  }

  const Part21File& File;
  KernelRecords& Result;
  std::string_view Text;
  Part21Cursor Cursor;
  std::vector<OpenList> Open;
  std::vector<KernelRecords::Parameter> Waiting;
};

bool KernelRecords::Make(const Part21File& file, const std::vector<bool>& emptied)
{
  const bool isMade = IsPlain(file) && KernelRecordMaker(file, *this).Run(emptied);
  if (!isMade)
  {
    // Frees the memory for OpenCASCADE's own parser, which is used instead.
    *this = KernelRecords();
  }
  return isMade;
}

Handle(StepData_StepReaderData) KernelRecords::MakeReaderData(Resource_FormatType codePage) const
{
  const std::size_t count = this->Records.size() - 1;
  const Handle(StepData_StepReaderData) data =
    new StepData_StepReaderData(static_cast<int>(this->HeaderRecords), static_cast<int>(count),
      static_cast<int>(this->Parameters.size()), codePage);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Record& record = this->Records[i];
    const std::uint32_t end = this->Records[i + 1].FirstParameter;
    const int number = static_cast<int>(i) + 1;
    const char* ident = record.IdentKind == Kind::Instance ? this->Bytes.c_str() + record.Ident
      : record.IdentKind == Kind::Part                     ? NoIdent
                                                           : this->GetListName(record.Ident);
    data->SetRecord(number, ident, record.Type != 0 ? this->Bytes.c_str() + record.Type : ListType,
      static_cast<int>(end - record.FirstParameter));
    for (std::uint32_t k = record.FirstParameter; k < end; ++k)
    {
      const Parameter& parameter = this->Parameters[k];
      data->AddStepParam(number,
        parameter.Type == Interface_ParamSub ? this->GetListName(parameter.Text)
                                             : this->Bytes.c_str() + parameter.Text,
        parameter.Type);
    }
    data->InitParams(number);
  }
  return data;
}

Handle(IFSelect_WorkLibrary) MakeRecordLibrary(const KernelRecords& records)
{
  return new RecordLibrary(records);
}
}
