#include "smReport.h"

#include "smTableText.h"

#include <algorithm>
#include <utility>

namespace
{
using sm::Dump;
using sm::Json;

/// Column names and values of a row.
struct Columns
{
  std::vector<std::pair<std::string, Json>> Cells;

  bool Has(const std::string& head) const
  {
    return std::any_of(this->Cells.begin(), this->Cells.end(),
      [&head](const std::pair<std::string, Json>& cell) { return cell.first == head; });
  }
  void Add(const std::string& head, const Json& value) { this->Cells.emplace_back(head, value); }
  void Add(const std::string& stem, const Json& values, const std::vector<std::string>& suffixes)
  {
    for (size_t i = 0; i < suffixes.size(); ++i)
    {
      this->Add(stem + "_" + suffixes[i], values.is_null() ? Json() : values[i]);
    }
  }
  /// Adds the six different entries of a symmetric matrix.
  void AddMatrix(const std::string& stem, const Json& matrix)
  {
    Json six;
    if (!matrix.is_null())
    {
      six = { matrix[0][0], matrix[1][1], matrix[2][2], matrix[0][1], matrix[1][2], matrix[0][2] };
    }
    this->Add(stem, six, { "xx", "yy", "zz", "xy", "yz", "xz" });
  }
};

/// Additional columns of all files: names of integrals and the numbers of waterlines and sections.
struct Extras
{
  std::vector<std::string> Integrals;
  size_t Waterlines = 0;
  size_t Sections = 0;
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
    extras.Sections = std::max(extras.Sections, file["sections"].size());
  }
  return extras;
}

/// Adds the columns of one section; empty cells if it is null.
void AddSection(const std::string& stem, const Json& section, Columns& columns)
{
  const Json nothing;
  const std::vector<std::string> xyz = { "x", "y", "z" };
  const auto get = [&](const char* key) -> const Json& { return section.is_null() ? nothing : section[key]; };
  const auto addBound = [&](const char* key)
  { columns.Add(stem + "_" + key + "_bound", section.is_null() ? nothing : section["bounds"][key]); };
  columns.Add(stem + "_point", get("point"), xyz);
  columns.Add(stem + "_normal", get("normal"), xyz);
  columns.Add(stem + "_area", get("area"));
  addBound("area");
  columns.Add(stem + "_centroid", get("centroid"), xyz);
  addBound("centroid");
  columns.AddMatrix(stem + "_second_moments", get("second_moments"));
  addBound("second_moments");
  columns.Add(stem + "_principal_moments", get("principal_moments"), { "1", "2" });
  addBound("principal_moments");
  for (const std::string side : { "below", "above" })
  {
    for (const std::string quantity : { "volume", "center", "mass" })
    {
      const std::string key = quantity + "_" + side;
      if (quantity == "center")
      {
        columns.Add(stem + "_" + key, get(key.c_str()), xyz);
      }
      else
      {
        columns.Add(stem + "_" + key, get(key.c_str()));
      }
      addBound(key.c_str());
    }
  }
}

void AddExtras(const Json& row, const Extras& extras, Columns& columns)
{
  const Json nothing;
  for (const std::string& name : extras.Integrals)
  {
    const bool known = row.contains("integrals") && row["integrals"].contains(name);
    const Json& integral = known ? row["integrals"][name] : nothing;
    // An integral of the user may have the name of a column.
    const bool isTaken = columns.Has(name) || columns.Has(name + "_bound");
    const std::string stem = (isTaken ? "integral_" : "") + name;
    columns.Add(stem, known ? integral["value"] : nothing);
    columns.Add(stem + "_bound", known ? integral["bound"] : nothing);
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
  for (size_t i = 0; i < extras.Sections; ++i)
  {
    const bool known = row.contains("sections") && i < row["sections"].size();
    AddSection("section" + std::to_string(i + 1), known ? row["sections"][i] : nothing, columns);
  }
}

void AddMassColumns(const Json& row, Columns& columns)
{
  const std::vector<std::string> xyz = { "x", "y", "z" };
  const Json& bounds = row["bounds"];
  const Json nothing;
  columns.Add("density", row["density"]);
  columns.Add("material", row["material"]);
  const Json& doubt = row["mass_uncertainty"];
  columns.Add("mass_uncertainty", doubt.is_object() ? doubt["total"] : nothing);
  columns.Add("mass_uncertainty_density", doubt.is_object() ? doubt["density"] : nothing);
  columns.Add("mass_uncertainty_gaps", doubt.is_object() ? doubt["gaps"] : nothing);
  columns.Add("mass_center", row["mass_center"], xyz);
  columns.Add("mass_center_bound", bounds["mass_center"]);
  columns.AddMatrix("mass_inertia", row["mass_inertia"]);
  columns.Add("mass_inertia_bound", bounds["mass_inertia"]);
  // Only a total has these columns.
  const bool isTotal = row.contains("known_mass");
  columns.Add("known_mass", isTotal ? row["known_mass"] : nothing);
  columns.Add("known_mass_bound", isTotal ? bounds["known_mass"] : nothing);
  columns.Add("solids_with_mass", isTotal ? row["solids_with_mass"] : nothing);
  columns.Add("solids_with_volume", isTotal ? row["solids_with_volume"] : nothing);
  columns.Add("radius_of_gyration", row["radii_of_gyration"], { "1", "2", "3" });
  columns.Add("radius_of_gyration_bound", bounds["radii_of_gyration"]);
  columns.AddMatrix("inertia_at_origin", row["inertia_at_origin"]);
  columns.Add("inertia_at_origin_bound", bounds["inertia_at_origin"]);
}

void AddBoxColumns(const Json& row, Columns& columns)
{
  const Json nothing;
  const Json& box = row["bounding_box"];
  columns.Add("box", box.is_null() ? nothing : box[0], { "xmin", "ymin", "zmin" });
  columns.Add("box", box.is_null() ? nothing : box[1], { "xmax", "ymax", "zmax" });
  columns.Add("box_bound", row["bounds"]["bounding_box"]);
}

/// Adds the columns of the frame of reference; empty cells without one.
void AddFrameColumns(const Json& about, Columns& columns)
{
  const Json nothing;
  const auto get = [&](const char* key) -> const Json& { return about.is_null() ? nothing : about[key]; };
  const auto getBound = [&](const char* key) -> const Json&
  { return about.is_null() ? nothing : about["bounds"][key]; };
  columns.Add("about_center", get("center_of_mass"), { "x", "y", "z" });
  columns.Add("about_center_bound", getBound("center_of_mass"));
  columns.AddMatrix("about_inertia", get("inertia"));
  columns.Add("about_inertia_bound", getBound("inertia"));
  columns.Add("about_mass_center", get("mass_center"), { "x", "y", "z" });
  columns.Add("about_mass_center_bound", getBound("mass_center"));
  columns.AddMatrix("about_mass_inertia", get("mass_inertia"));
  columns.Add("about_mass_inertia_bound", getBound("mass_inertia"));
}

Columns CsvRow(const Json& file, const Json& row, bool isTotal, const Extras& extras)
{
  Columns columns;
  columns.Add("file", file["file"]);
  columns.Add("row", isTotal ? "total" : "solid");
  columns.Add("name", isTotal ? Json() : row["name"]);
  columns.Add("id", isTotal ? Json() : row["id"]);
  columns.Add("path", isTotal ? Json() : row["path"]);
  columns.Add("status", isTotal ? file["status"] : row["status"]);
  columns.Add("scheme", file["scheme"]);
  columns.Add("length_unit", file["length_unit"]);
  columns.Add("volume", row["volume"]);
  columns.Add("volume_bound", row["bounds"]["volume"]);
  columns.Add("area", row["area"]);
  columns.Add("area_bound", row["bounds"]["area"]);
  columns.Add("center", row["center_of_mass"], { "x", "y", "z" });
  columns.Add("center_bound", row["bounds"]["center_of_mass"]);
  columns.AddMatrix("inertia", row["inertia"]);
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
  AddMassColumns(row, columns);
  AddFrameColumns(row["about"], columns);
  AddBoxColumns(row, columns);
  AddExtras(isTotal ? file : row, extras, columns);
  return columns;
}

/// Returns the cells with these names, in their order; all cells if there are no names.
std::vector<std::pair<std::string, Json>> Select(
  const Columns& columns, const std::vector<std::string>& fields)
{
  if (fields.empty())
  {
    return columns.Cells;
  }
  std::vector<std::pair<std::string, Json>> chosen;
  for (const std::string& field : fields)
  {
    const auto found = std::find_if(columns.Cells.begin(), columns.Cells.end(),
      [&field](const std::pair<std::string, Json>& cell) { return cell.first == field; });
    // Integrals of other files may be missing here.
    chosen.push_back(found == columns.Cells.end() ? std::pair(field, Json()) : *found);
  }
  return chosen;
}

std::string FormatRow(const std::vector<std::pair<std::string, Json>>& cells, bool isHead)
{
  std::string line;
  for (size_t i = 0; i < cells.size(); ++i)
  {
    line += (i > 0 ? "," : "") + sm::FormatCell(isHead ? Json(cells[i].first) : cells[i].second);
  }
  return line + "\n";
}
}

namespace sm
{
std::vector<std::string> ListColumns(const Json& file)
{
  std::vector<std::string> names;
  for (const auto& [name, value] : CsvRow(file, file["total"], true, FindExtras(Json::array({ file }))).Cells)
  {
    names.push_back(name);
  }
  return names;
}

std::string FormatFields(const Json& file, const std::vector<std::string>& fields)
{
  std::string line;
  for (const auto& [name, value] :
    Select(CsvRow(file, file["total"], true, FindExtras(Json::array({ file }))), fields))
  {
    line += (line.empty() ? "" : " ") +
      (value.is_string()    ? value.get<std::string>()
          : value.is_null() ? "nan"
                            : Dump(value));
  }
  return line + "\n";
}

std::string FormatCsv(const Json& files, const std::vector<std::string>& fields)
{
  const Extras extras = FindExtras(files);
  std::string text;
  for (const Json& file : files)
  {
    const auto total = Select(CsvRow(file, file["total"], true, extras), fields);
    text += (text.empty() ? FormatRow(total, true) : "") + FormatRow(total, false);
    for (const Json& solid : file["solids"])
    {
      text += FormatRow(Select(CsvRow(file, solid, false, extras), fields), false);
    }
  }
  return text;
}
}
