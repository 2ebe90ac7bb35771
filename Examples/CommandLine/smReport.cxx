#include "smReport.h"

#include "smFormat.h"
#include "smPartsReport.h"
#include "smReportRows.h"
#include "smTableText.h"
#include "smText.h"

#include <algorithm>
#include <cmath>

namespace
{
using sm::Dump;
using sm::Json;

const size_t MaximumSolids = 20;
const size_t MaximumMessages = 12;

/// Returns the rows of defects of the model, which are not part of the bounds: open edges and gaps.
std::string DefectRows(const Json& total, const Json& file)
{
  std::string text;
  if (total["open_edges"].is_number() && total["open_edges"] != 0)
  {
    text += sm::Row("open edges",
      Dump(total["open_edges"]) + ", closure residual " + sm::Short(total["closure_residual"]), "", nullptr);
  }
  if (total["closure_correction"].is_number() && total["closure_correction"].get<double>() > 0.0)
  {
    text += sm::Row("gaps of the model",
      "widest " + sm::ShortBound(total["max_gap"]) + " " + sm::FormatUnit(file, 1) +
        "; closing them changed the volume by " + sm::Short(total["closure_correction"]) + " " +
        sm::FormatUnit(file, 3),
      "", nullptr);
  }
  return text;
}

/// Returns the rows of mass, and of centre and inertia with the densities as weight. If only some solids have a density, the mass is that
/// of these.
std::string MassRows(const Json& total, const Json& file)
{
  const Json& bounds = total["bounds"];
  const std::string length = sm::FormatUnit(file, 1);
  if (total["mass"].is_null())
  {
    return total["known_mass"].is_null()
      ? std::string()
      : sm::BoundedRow(
          "mass of " + sm::Plain(total["solids_with_mass"]) + " of " + sm::Plain(total["solids_with_volume"]),
          sm::FormatValue(total["known_mass"], bounds["known_mass"]), "kg", bounds["known_mass"]);
  }
  std::string text =
    sm::BoundedRow("mass", sm::FormatValue(total["mass"], bounds["mass"]), "kg", bounds["mass"]);
  const Json& doubt = total["mass_uncertainty"];
  if (doubt.is_object() && (doubt["density"] != 0.0 || doubt["gaps"] != 0.0))
  {
    text += sm::Row("mass in doubt",
      sm::ShortBound(doubt["total"]) + " kg: density " + sm::ShortBound(doubt["density"]) + ", gaps " +
        sm::ShortBound(doubt["gaps"]) + ", numerical " + sm::ShortBound(doubt["numerical"]),
      "", nullptr);
  }
  if (sm::HasMixedDensities(total))
  {
    text += sm::BoundedRow("centre of mass", sm::FormatVector(total["mass_center"], bounds["mass_center"]),
      length, bounds["mass_center"]);
  }
  return text +
    sm::Rows(
      "mass inertia", total["mass_inertia"], bounds["mass_inertia"], "kg " + sm::FormatUnit(file, 2), true);
}

/// Returns the rows of validation properties: the number of those that agree, and each one that does not.
std::string ValidationRows(const Json& file)
{
  if (!file.contains("validation"))
  {
    return {};
  }
  std::string text = sm::Row("validation",
    std::to_string(sm::CountValidation(file, "pass")) + " pass, " +
      std::to_string(sm::CountValidation(file, "fail")) + " fail, " +
      std::to_string(sm::CountValidation(file, "not-comparable")) + " not comparable",
    "", nullptr);
  size_t listed = 0;
  for (const Json& entry : file["validation"])
  {
    if (entry["result"] != "fail" || ++listed > MaximumMessages)
    {
      continue;
    }
    const int power = entry["quantity"] == "volume" ? 3 : entry["quantity"] == "area" ? 2 : 1;
    const auto format = [&entry](const char* key)
    {
      return entry[key].is_array() ? sm::FormatVector(entry[key], nullptr)
                                   : sm::FormatValue(entry[key], nullptr);
    };
    text += sm::Row("",
      sm::Plain(entry["product"]) + ": " + sm::Plain(entry["quantity"]) + " stated " + format("stated") +
        ", computed " + format("computed") + " " + sm::FormatUnit(file, power) + "; differs by " +
        sm::Short(entry["difference"]) + ", limit " + sm::Short(entry["limit"]),
      "", nullptr);
  }
  return text;
}

/// Returns all rows of a file on which the filter ran.
std::string Results(const Json& file)
{
  const Json& total = file["total"];
  const Json& bounds = total["bounds"];
  const std::string length = sm::FormatUnit(file, 1);
  const std::string inertiaUnit = sm::FormatUnit(file, 5);
  const size_t solids = file["solids"].size();
  const std::string renderer = sm::Plain(file["renderer"]);
  const Json& reason = file["backend_reason"];
  std::string text = "  " + sm::Count(solids, "body", "bodies") + ", " +
    sm::Count(file["faces"], "face", "faces") + ", unit " + length + ", backend " +
    sm::Plain(file["backend"]) + (renderer.empty() ? "" : " on " + renderer) +
    (reason.is_null() ? "" : " (" + sm::Plain(reason) + ")") + "\n";
  text += sm::BoundedRow(
    "volume", sm::FormatValue(total["volume"], bounds["volume"]), sm::FormatUnit(file, 3), bounds["volume"]);
  text += sm::BoundedRow(
    "surface area", sm::FormatValue(total["area"], bounds["area"]), sm::FormatUnit(file, 2), bounds["area"]);
  // Where densities differ, the centre of the volume is not that of the mass.
  const bool isMixed = sm::HasMixedDensities(total);
  text += sm::BoundedRow(isMixed ? "centre of volume" : "centre of mass",
    sm::FormatVector(total["center_of_mass"], bounds["center_of_mass"]), length, bounds["center_of_mass"]);
  text += MassRows(total, file);
  text += sm::Rows("inertia about centre", total["inertia"], bounds["inertia"], inertiaUnit, true);
  text += sm::BoundedRow("principal moments", sm::FormatVector(total["principal_moments"], bounds["inertia"]),
    inertiaUnit, bounds["inertia"]);
  text += total["principal_axes_degenerate"] == true
    ? sm::Row("principal axes", "not unique, moments coincide", "", nullptr)
    : sm::Rows("principal axes", total["principal_axes"], 1e-9, "", false);
  text += sm::BoundedRow("radii of gyration",
    sm::FormatVector(total["radii_of_gyration"], bounds["radii_of_gyration"]), length,
    bounds["radii_of_gyration"]);
  const Json& box = total["bounding_box"];
  if (!box.is_null())
  {
    text += sm::BoundedRow("bounding box",
      sm::FormatVector(box[0], bounds["bounding_box"]) + "  to  " +
        sm::FormatVector(box[1], bounds["bounding_box"]),
      length, bounds["bounding_box"]);
  }
  text += sm::AnalysisRows(total, file);
  text += ValidationRows(file);
  text += DefectRows(total, file);
  return text +
    sm::Row("evaluations",
      sm::Plain(file["evaluations"]) + " in " + sm::Count(file["dispatches"], "dispatch", "dispatches"), "",
      nullptr);
}

/// Returns a path of at most 23 characters, with its end, where single instances differ.
std::string ShortenPath(const std::string& path)
{
  const size_t slash = path.rfind('/');
  return path.size() <= 23 || slash == std::string::npos ? sm::Shorten(path, 23)
                                                         : sm::Shorten("..." + path.substr(slash), 23);
}

std::string SolidRows(const Json& file)
{
  const Json& solids = file["solids"];
  if (solids.size() < 2)
  {
    return {};
  }
  const std::string unit = sm::FormatUnit(file, 1);
  const bool hasMass = std::any_of(solids.begin(), solids.end(),
    [](const Json& solid) { return solid["density"].is_number() || solid["material"].is_string(); });
  const auto massCells = [hasMass](
                           const std::string& density, const std::string& mass, const std::string& material)
  {
    return hasMass
      ? sm::Pad(mass, 16, true) + sm::Pad(density, 15, true) + "  " + sm::Pad(sm::Shorten(material, 18), 20)
      : "";
  };
  std::string text = "\n  " + sm::Pad("solid", 24) + sm::Pad("volume " + sm::FormatUnit(file, 3), 18, true) +
    sm::Pad("area " + sm::FormatUnit(file, 2), 18, true) +
    massCells("density kg/m^3", "mass kg", "material") + "  " + sm::Pad("centre of mass " + unit, 40) +
    (solids[0]["stability"].is_object() ? sm::Pad("status", 19) + "stability\n" : "status\n");
  for (size_t i = 0; i < std::min(solids.size(), MaximumSolids); ++i)
  {
    const Json& solid = solids[i];
    const Json& bounds = solid["bounds"];
    std::string name = sm::Plain(solid["path"]);
    name = name.empty() ? sm::Plain(solid["id"]) : name;
    text += "  " + sm::Pad(ShortenPath(name), 24) +
      sm::Pad(sm::FormatBrief(solid["volume"], bounds["volume"]), 18, true) +
      sm::Pad(sm::FormatBrief(solid["area"], bounds["area"]), 18, true) +
      massCells(sm::FormatValue(solid["density"], nullptr, 9), sm::FormatBrief(solid["mass"], bounds["mass"]),
        sm::Plain(solid["material"])) +
      "  " + sm::Pad(sm::FormatBrief(solid["center_of_mass"], bounds["center_of_mass"]), 40) +
      (solid["stability"].is_object()
          ? sm::Pad(sm::Plain(solid["status"]), 19) + sm::Plain(solid["stability"]["verdict"])
          : sm::Plain(solid["status"])) +
      "\n";
  }
  if (solids.size() > MaximumSolids)
  {
    text += "  ... and " + sm::Count(solids.size() - MaximumSolids, "more solid", "more solids") +
      ", see --csv or --json\n";
  }
  return text;
}

bool IsFlat(const Json& value)
{
  return std::none_of(value.begin(), value.end(), [](const Json& item) { return item.is_object(); });
}

std::string WriteJson(const Json& value, const std::string& indent)
{
  if ((!value.is_object() && !value.is_array()) || value.empty() || (value.is_array() && IsFlat(value)))
  {
    return Dump(value);
  }
  const std::string inner = indent + "  ";
  std::string text;
  for (auto item = value.begin(); item != value.end(); ++item)
  {
    text += (text.empty() ? "" : ",") + ("\n" + inner) +
      (value.is_object() ? Dump(Json(item.key())) + ": " : "") + WriteJson(*item, inner);
  }
  return (value.is_object() ? "{" : "[") + text + "\n" + indent + (value.is_object() ? "}" : "]");
}
}

namespace sm
{
std::string FormatUnit(const Json& file, int power)
{
  const Json& unit = file["length_unit"];
  return unit.is_null() || unit.empty() ? std::string()
    : power == 1                        ? unit.get<std::string>()
                                        : unit.get<std::string>() + "^" + std::to_string(power);
}

int CountValidation(const Json& file, const std::string& result)
{
  const Json list = file.contains("validation") ? file["validation"] : Json::array();
  return static_cast<int>(std::count_if(
    list.begin(), list.end(), [&result](const Json& entry) { return entry["result"] == result; }));
}

std::string FormatMessages(const Json& file)
{
  const Json& messages = file["messages"];
  std::string text;
  for (size_t i = 0; i < std::min(messages.size(), MaximumMessages); ++i)
  {
    text += "  note: " + Plain(messages[i]) + "\n";
  }
  if (messages.size() > MaximumMessages)
  {
    text +=
      "  ... and " + Count(messages.size() - MaximumMessages, "more note", "more notes") + ", see --json\n";
  }
  return text;
}

std::string FormatTable(const Json& file)
{
  std::string text = Plain(file["file"]) + "   " + Plain(file["status"]) + "\n";
  text += file["backend"].is_null() ? std::string() : Results(file);
  const Json& seconds = file["seconds"];
  if (!seconds["start"].is_null())
  {
    text += Row("seconds",
      "start " + Short(seconds["start"]) + ", read " + Short(seconds["read"]) + ", prepare " +
        Short(seconds["prepare"]) + ", integrate " + Short(seconds["integrate"]),
      "", nullptr);
  }
  return text + SolidRows(file) + FormatPartsList(file) + FormatMessages(file);
}

std::string FormatJson(const Json& document)
{
  return WriteJson(document, "") + "\n";
}
}
