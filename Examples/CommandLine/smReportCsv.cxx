#include "smReport.h"

#include <algorithm>

namespace
{
using sm::Dump;
using sm::Json;

std::string Cell(const Json& value)
{
  if (!value.is_string())
  {
    return value.is_null() ? "" : Dump(value);
  }
  std::string text = value.get<std::string>();
  if (text.find_first_of(",\"\n\r") == std::string::npos)
  {
    return text;
  }
  for (size_t i = text.find('"'); i != std::string::npos; i = text.find('"', i + 2))
  {
    text.insert(i, 1, '"');
  }
  return "\"" + text + "\"";
}

/// Adds heads and values of a row together, so that they match.
struct Columns
{
  std::string Head;
  std::string Line;

  void Add(const std::string& head, const Json& value)
  {
    this->Head += (this->Head.empty() ? "" : ",") + head;
    this->Line += (this->Line.empty() ? "" : ",") + Cell(value);
  }
  void Add(const std::string& stem, const Json& values, const std::vector<std::string>& suffixes)
  {
    for (size_t i = 0; i < suffixes.size(); ++i)
    {
      this->Add(stem + "_" + suffixes[i], values.is_null() ? Json() : values[i]);
    }
  }
};

/// Additional columns of all files: names of integrals and the number of waterlines.
struct Extras
{
  std::vector<std::string> Integrals;
  size_t Waterlines = 0;
};

Extras FindExtras(const Json& files)
{
  Extras extras;
  for (const Json& file : files)
  {
    const Json& integrals = file["integrals"];
    for (auto item = integrals.begin(); item != integrals.end(); ++item)
    {
      if (std::find(extras.Integrals.begin(), extras.Integrals.end(), item.key()) == extras.Integrals.end())
      {
        extras.Integrals.push_back(item.key());
      }
    }
    extras.Waterlines = std::max(extras.Waterlines, file["waterlines"].size());
  }
  return extras;
}

void AddExtras(const Json& row, const Extras& extras, Columns& columns)
{
  const Json nothing;
  for (const std::string& name : extras.Integrals)
  {
    const bool known = row.contains("integrals") && row["integrals"].contains(name);
    const Json& integral = known ? row["integrals"][name] : nothing;
    columns.Add(Cell(name), known ? integral["value"] : nothing);
    columns.Add(Cell(name + "_bound"), known ? integral["bound"] : nothing);
  }
  for (size_t i = 0; i < extras.Waterlines; ++i)
  {
    const bool known = row.contains("waterlines") && i < row["waterlines"].size();
    const Json& waterline = known ? row["waterlines"][i] : nothing;
    const std::string stem = "waterline" + std::to_string(i + 1);
    columns.Add(stem + "_height", known ? waterline["height"] : nothing);
    columns.Add(stem + "_volume", known ? waterline["volume"] : nothing);
    columns.Add(stem + "_volume_bound", known ? waterline["bounds"]["volume"] : nothing);
    columns.Add(stem + "_center", known ? waterline["center"] : nothing, { "x", "y", "z" });
    columns.Add(stem + "_center_bound", known ? waterline["bounds"]["center"] : nothing);
  }
}

Columns CsvRow(const Json& file, const Json& row, bool isTotal, const Extras& extras)
{
  Columns columns;
  columns.Add("file", file["file"]);
  columns.Add("row", isTotal ? "total" : "solid");
  columns.Add("name", isTotal ? Json() : row["name"]);
  columns.Add("id", isTotal ? Json() : row["id"]);
  columns.Add("status", isTotal ? file["status"] : row["status"]);
  columns.Add("scheme", file["scheme"]);
  columns.Add("length_unit", file["length_unit"]);
  columns.Add("volume", row["volume"]);
  columns.Add("volume_bound", row["bounds"]["volume"]);
  columns.Add("area", row["area"]);
  columns.Add("area_bound", row["bounds"]["area"]);
  columns.Add("center", row["center_of_mass"], { "x", "y", "z" });
  columns.Add("center_bound", row["bounds"]["center_of_mass"]);
  const Json& inertia = row["inertia"];
  Json six;
  if (!inertia.is_null())
  {
    six = { inertia[0][0], inertia[1][1], inertia[2][2], inertia[0][1], inertia[1][2], inertia[0][2] };
  }
  columns.Add("inertia", six, { "xx", "yy", "zz", "xy", "yz", "xz" });
  columns.Add("inertia_bound", row["bounds"]["inertia"]);
  columns.Add("principal", row["principal_moments"], { "1", "2", "3" });
  for (size_t i = 0; i < 3; ++i)
  {
    const Json& axes = row["principal_axes"];
    columns.Add("axis" + std::to_string(i + 1), axes.is_null() ? Json() : axes[i], { "x", "y", "z" });
  }
  columns.Add("mass", row["mass"]);
  columns.Add("mass_bound", row["bounds"]["mass"]);
  for (const char* key :
    { "closure_correction", "gap_squared", "max_gap", "gap_area", "open_edges", "closure_residual",
      "flipped_shells", "paper_error_estimate", "paper_error_estimate_with_boundary", "sub_patches" })
  {
    columns.Add(key, row[key]);
  }
  AddExtras(isTotal ? file : row, extras, columns);
  return columns;
}
}

namespace sm
{
std::string FormatCsv(const Json& files)
{
  const Extras extras = FindExtras(files);
  std::string text;
  for (const Json& file : files)
  {
    const Columns total = CsvRow(file, file["total"], true, extras);
    text += (text.empty() ? total.Head + "\n" : "") + total.Line + "\n";
    for (const Json& solid : file["solids"])
    {
      text += CsvRow(file, solid, false, extras).Line + "\n";
    }
  }
  return text;
}
}
