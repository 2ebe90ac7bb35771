#include "smReference.h"

#include "smColumns.h"
#include "smFileJob.h"
#include "smReport.h"

#include <algorithm>

namespace sm
{
namespace
{
/// Writes a table for each object that it visits. Objects that do not exist are visited, too, and lists as if
/// they had one entry.
class ReferenceFields : public Fields
{
public:
  struct Row
  {
    std::string Key, Kind, Unit, Meaning;
    bool operator==(const Row& other) const
    {
      return this->Key == other.Key && this->Kind == other.Kind && this->Unit == other.Unit &&
        this->Meaning == other.Meaning;
    }
  };
  struct Table
  {
    std::string Path;
    std::vector<Row> Rows;
  };

  explicit ReferenceFields(const std::string& path)
    : Tables{ { path, {} } }
    , Open{ 0 }
  {
  }

  using Fields::Number;
  using Fields::Text;
  Fields& Note(const char* unit, const char* meaning) override
  {
    this->Unit = unit;
    this->Meaning = meaning;
    return *this;
  }
  void Number(const char* key, double&) override { this->Add(key, "number"); }
  void Numbers(const char* key, double*, std::size_t rows, std::size_t columns) override
  {
    this->Add(key, (rows > 1 ? std::to_string(rows) + " x " : "") + std::to_string(columns) + " numbers");
  }
  void Count(const char* key, long long&) override { this->Add(key, "whole number"); }
  void Flag(const char* key, std::optional<bool>&) override { this->Add(key, "true, false"); }
  void Text(const char* key, std::optional<std::string>&) override { this->Add(key, "text"); }
  void Texts(const char* key, std::vector<std::string>&) override { this->Add(key, "list of texts"); }
  bool Begin(const char* key, bool) override
  {
    if (key)
    {
      this->BeginTable(key, "object", "");
    }
    else
    {
      this->Open.push_back(this->Open.back()); // an entry of a list
    }
    return true;
  }
  void End() override { this->Open.pop_back(); }
  std::size_t BeginList(const char* key, std::size_t) override
  {
    this->BeginTable(key, "list", "[]");
    // Parts have parts: one level says all.
    return key == std::string("children") ? 0 : 1;
  }
  void EndList() override { this->Open.pop_back(); }
  bool Has(bool) override { return true; }

  const std::vector<Table>& GetTables() const { return this->Tables; }

private:
  void Add(const char* key, const std::string& kind)
  {
    std::vector<Row>& rows = this->Tables[this->Open.back()].Rows;
    const auto known =
      std::find_if(rows.begin(), rows.end(), [key](const Row& row) { return row.Key == key; });
    // A key that is written a second time takes the place of the first.
    const Row row{ key, kind, this->Unit, this->Meaning };
    if (known == rows.end())
    {
      rows.push_back(row);
    }
    else if (!this->Meaning.empty())
    {
      *known = row;
    }
    this->Unit = this->Meaning = "";
  }
  void BeginTable(const char* key, const char* kind, const char* suffix)
  {
    this->Add(key, kind);
    const std::string path = this->Tables[this->Open.back()].Path + "." + key + suffix;
    const auto known = std::find_if(
      this->Tables.begin(), this->Tables.end(), [&path](const Table& table) { return table.Path == path; });
    this->Open.push_back(static_cast<std::size_t>(known - this->Tables.begin()));
    if (known == this->Tables.end())
    {
      this->Tables.push_back({ path, {} });
    }
  }

  std::vector<Table> Tables;
  std::vector<std::size_t> Open; ///< the tables of the objects that are being visited
  std::string Unit, Meaning;     ///< of the next key
};

using Table = ReferenceFields::Table;

/// Returns the last key of a path.
std::string GetName(const std::string& path)
{
  return path.substr(path.find_last_of('.') + 1);
}

/// Returns the tables without repetitions: a table with the rows of an earlier one of the same name is left
/// out, and so are the rows of a solid that the total has, too.
std::vector<Table> RemoveRepeats(const std::vector<Table>& tables)
{
  std::vector<Table> result;
  for (const Table& table : tables)
  {
    Table kept = table;
    const auto known = std::find_if(result.begin(), result.end(),
      [&table](const Table& other)
      { return GetName(other.Path) == GetName(table.Path) && other.Rows == table.Rows; });
    if (known != result.end())
    {
      continue;
    }
    if (table.Path == "files[].solids[]")
    {
      const std::vector<ReferenceFields::Row> total = std::find_if(result.begin(), result.end(),
        [](const Table& other)
        { return other.Path == "files[].total"; })->Rows;
      const auto isTotal = [&total](const ReferenceFields::Row& row)
      { return std::find(total.begin(), total.end(), row) != total.end(); };
      kept.Rows.erase(std::remove_if(kept.Rows.begin(), kept.Rows.end(), isTotal), kept.Rows.end());
    }
    result.push_back(kept);
  }
  return result;
}

std::string FormatTables(const std::vector<Table>& tables)
{
  std::string text;
  for (const Table& table : RemoveRepeats(tables))
  {
    // The keys of bounds are those of the quantities.
    if (table.Rows.empty() || GetName(table.Path) == "bounds")
    {
      continue;
    }
    text += "### `" + table.Path + "`\n\n| Key | Value | Unit | Meaning |\n|---|---|---|---|\n";
    for (const ReferenceFields::Row& row : table.Rows)
    {
      text += "| `" + row.Key + "` | " + row.Kind + " | " + row.Unit + " | " + row.Meaning + " |\n";
    }
    text += "\n";
  }
  return text;
}
}

std::string FormatReference()
{
  // What is visited gets one entry in each list, so that the columns of one entry are known, too.
  const JobOptions options;
  FileResult file(options);
  ReferenceFields files("files[]");
  file.Visit(files);
  ProductDifference comparison;
  ReferenceFields compared("comparison");
  comparison.Visit(compared);
  return "## Keys of the JSON\n\n" + FormatTables(files.GetTables()) + FormatTables(compared.GetTables()) +
    "## Columns of the CSV\n\n" + FormatColumnReference(file);
}
}
