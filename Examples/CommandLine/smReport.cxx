#include "smReport.h"

#include "smFormat.h"
#include "smPartsReport.h"
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

/// "1 face", "2 faces".
std::string Count(const Json& number, const std::string& one, const std::string& more)
{
  return number.is_null() ? "- " + more : Dump(number) + " " + (number == 1 ? one : more);
}

std::string Plain(const Json& value)
{
  return value.is_string() ? value.get<std::string>() : value.is_null() ? "-" : Dump(value);
}

std::string Short(const Json& value)
{
  return value.is_number() ? sm::FormatDigits(value.get<double>(), 2) : "-";
}

/// The bound with two digits, rounded up.
std::string ShortBound(const Json& value)
{
  return value.is_number() ? sm::FormatBound(value.get<double>(), 2) : "-";
}

// --- the table ---------------------------------------------------------------------------------

std::string Row(
  const std::string& label, const std::string& value, const std::string& unit, const Json& bound)
{
  std::string line = "  " + sm::Pad(label, 22) + value;
  if (value != "-" && !unit.empty())
  {
    line += " " + unit;
  }
  if (bound.is_number())
  {
    line = sm::Pad(line, 80) + "  +/- " + sm::FormatBoundOfShown(bound.get<double>(), 2);
  }
  return line + "\n";
}

/// A row of a value that has a bound, or says that it has none.
std::string BoundedRow(
  const std::string& label, const std::string& value, const std::string& unit, const Json& bound)
{
  const std::string row = Row(label, value, unit, bound);
  return value == "-" || bound.is_number() ? row
                                           : sm::Pad(row.substr(0, row.size() - 1), 80) + "  no bound\n";
}

/// Three rows for a matrix whose entries are known to within `limit`, with the bound in the first; `hasBound` says that there should be one.
std::string Rows(
  const std::string& label, const Json& matrix, const Json& limit, const std::string& unit, bool hasBound)
{
  if (matrix.is_null())
  {
    return Row(label, "-", unit, nullptr);
  }
  size_t width = 0;
  std::string cells[3][3];
  for (size_t i = 0; i < 3; ++i)
  {
    for (size_t j = 0; j < 3; ++j)
    {
      cells[i][j] = sm::FormatValue(matrix[i][j], limit, 10);
      width = std::max(width, cells[i][j].size());
    }
  }
  std::string text;
  for (size_t i = 0; i < 3; ++i)
  {
    const std::string line = sm::Pad(cells[i][0], width, true) + "  " + sm::Pad(cells[i][1], width, true) +
      "  " + sm::Pad(cells[i][2], width, true);
    text += i == 0 ? (hasBound ? BoundedRow(label, line, unit, limit) : Row(label, line, unit, nullptr))
                   : Row("", line, "", nullptr);
  }
  return text;
}

/// Scheme, sub-patches and error estimate of a run with one of the paper's schemes.
std::string SchemeRows(const Json& total, const Json& file)
{
  if (!total["sub_patches"].is_number())
  {
    return {};
  }
  const Json& options = file["scheme_options"];
  const std::string texels = Dump(options["texture_factor"]);
  return Row("scheme",
           Plain(file["scheme"]) + ", k = " + Dump(options["sub_patch_factor"]) + ", " + texels + " x " +
             texels + " texels per sub-patch, chords of planes to " + Short(options["chord_tolerance"]) +
             ", deviations " + Plain(options["deviation"]),
           "", nullptr) +
    Row("",
      "on " + Dump(total["sub_patches"]) +
        " sub-patches; the paper's error estimate of the volume (not a bound): " +
        Short(total["paper_error_estimate"]) + " " + sm::FormatUnit(file, 3),
      "", nullptr);
}

/// The integrals that the user asked for.
std::string IntegralRows(const Json& file)
{
  const size_t most = 40;
  const Json& integrals = file["integrals"];
  std::string text;
  size_t count = 0;
  for (auto item = integrals.begin(); item != integrals.end() && count < most; ++item, ++count)
  {
    const Json& bound = (*item)["bound"];
    text += BoundedRow(item.key(), sm::FormatValue((*item)["value"], bound), "", bound);
  }
  return integrals.size() > most ? text + "  ... and " +
      Count(integrals.size() - most, "more integral", "more integrals") + ", see --json\n"
                                 : text;
}

/// Static stability, where the user asked for it.
std::string StabilityRows(const Json& total, const Json& file)
{
  const Json& found = total["stability"];
  if (found.is_null())
  {
    return {};
  }
  const std::string length = sm::FormatUnit(file, 1);
  const Json& bounds = found["bounds"];
  const bool rolls = found["decided_by"] == "rolling";
  const std::string support = Plain(found["support"]);
  std::string text = Row("stability",
    Plain(found["verdict"]) +
      (support == "none" ? std::string()
                         : ", rests on " + std::string(support == "area" ? "an area" : "a " + support)) +
      (rolls ? ", decided by its curvature" : ""),
    "", nullptr);
  text +=
    BoundedRow("stability margin", sm::FormatValue(found["stability_margin"], bounds["stability_margin"]),
      length, bounds["stability_margin"]);
  if (rolls)
  {
    return text +
      BoundedRow("rolling margin", sm::FormatValue(found["rolling_margin"], bounds["rolling_margin"]), length,
        bounds["rolling_margin"]);
  }
  text += BoundedRow("smallest tip angle", sm::FormatValue(found["tip_angle"], bounds["tip_angle"]),
    "degrees", bounds["tip_angle"]);
  text += BoundedRow("rise before tipping",
    sm::FormatValue(found["center_of_mass_rise"], bounds["center_of_mass_rise"]), length,
    bounds["center_of_mass_rise"]);
  return found["tip_energy"].is_null()
    ? text
    : text + Row("energy to tip", sm::FormatValue(found["tip_energy"], nullptr, 9), "J", nullptr);
}

/// Volume and centre of buoyancy below each waterline.
std::string WaterlineRows(const Json& file)
{
  std::string text;
  for (const Json& waterline : file["waterlines"])
  {
    const Json& bounds = waterline["bounds"];
    text += BoundedRow("below " + Short(waterline["height"]) + " " + sm::FormatUnit(file, 1),
      sm::FormatValue(waterline["volume"], bounds["volume"]), sm::FormatUnit(file, 3), bounds["volume"]);
    text += BoundedRow("  its centre", sm::FormatVector(waterline["center"], bounds["center"]),
      sm::FormatUnit(file, 1), bounds["center"]);
  }
  return text;
}

/// Moments of each section, and what lies on its sides.
std::string SectionRows(const Json& file)
{
  std::string text;
  for (const Json& section : file["sections"])
  {
    const Json& bounds = section["bounds"];
    const auto add = [&](const char* label, const char* key, int power)
    {
      if (!section[key].is_null())
      {
        std::string value;
        for (const Json& number : section[key].is_array() ? section[key] : Json::array({ section[key] }))
        {
          value += (value.empty() ? "" : "  ") + sm::FormatValue(number, bounds[key]);
        }
        text += BoundedRow(label, value, power > 0 ? sm::FormatUnit(file, power) : "kg", bounds[key]);
      }
    };
    text += Row("section at",
      sm::FormatVector(section["point"], 1e-9) + "  normal  " + sm::FormatVector(section["normal"], 1e-9), "",
      nullptr);
    text += BoundedRow("  its area", sm::FormatValue(section["area"], bounds["area"]),
      sm::FormatUnit(file, 2), bounds["area"]);
    add("  its centroid", "centroid", 1);
    add("  second moments", "principal_moments", 4);
    add("  volume below", "volume_below", 3);
    add("  centre below", "center_below", 1);
    add("  mass below", "mass_below", 0);
    add("  volume above", "volume_above", 3);
    add("  centre above", "center_above", 1);
    add("  mass above", "mass_above", 0);
  }
  return text;
}

/// Defects of the model, which are not part of the bounds: open edges and gaps.
std::string DefectRows(const Json& total, const Json& file)
{
  std::string text;
  if (total["open_edges"].is_number() && total["open_edges"] != 0)
  {
    text += Row("open edges",
      Dump(total["open_edges"]) + ", closure residual " + Short(total["closure_residual"]), "", nullptr);
  }
  if (total["closure_correction"].is_number() && total["closure_correction"].get<double>() > 0.0)
  {
    text += Row("gaps of the model",
      "widest " + ShortBound(total["max_gap"]) + " " + sm::FormatUnit(file, 1) +
        "; closing them changed the volume by " + Short(total["closure_correction"]) + " " +
        sm::FormatUnit(file, 3),
      "", nullptr);
  }
  return text;
}

/// True if all densities are known and not all the same.
bool HasMixedDensities(const Json& total)
{
  return total["mass"].is_number() && total["density"].is_null();
}

/// Mass, and what the densities are the weight of; of the solids that have a density where not all have one.
std::string MassRows(const Json& total, const Json& file)
{
  const Json& bounds = total["bounds"];
  const std::string length = sm::FormatUnit(file, 1);
  if (total["mass"].is_null())
  {
    return total["known_mass"].is_null()
      ? std::string()
      : BoundedRow(
          "mass of " + Plain(total["solids_with_mass"]) + " of " + Plain(total["solids_with_volume"]),
          sm::FormatValue(total["known_mass"], bounds["known_mass"]), "kg", bounds["known_mass"]);
  }
  std::string text = BoundedRow("mass", sm::FormatValue(total["mass"], bounds["mass"]), "kg", bounds["mass"]);
  const Json& doubt = total["mass_uncertainty"];
  if (doubt.is_object() && (doubt["density"] != 0.0 || doubt["gaps"] != 0.0))
  {
    text += Row("mass in doubt",
      ShortBound(doubt["total"]) + " kg: density " + ShortBound(doubt["density"]) + ", gaps " +
        ShortBound(doubt["gaps"]) + ", numerical " + ShortBound(doubt["numerical"]),
      "", nullptr);
  }
  if (HasMixedDensities(total))
  {
    text += BoundedRow("centre of mass", sm::FormatVector(total["mass_center"], bounds["mass_center"]),
      length, bounds["mass_center"]);
  }
  return text +
    Rows(
      "mass inertia", total["mass_inertia"], bounds["mass_inertia"], "kg " + sm::FormatUnit(file, 2), true);
}

/// Centre and inertia in the frame that the user asked for.
std::string FrameRows(const Json& total, const Json& file)
{
  const Json& about = total["about"];
  if (about.is_null())
  {
    return {};
  }
  const Json& bounds = about["bounds"];
  const std::string length = sm::FormatUnit(file, 1);
  const bool isMixed = HasMixedDensities(total);
  std::string text =
    Row("in the frame", "at " + sm::FormatVector(file["frame"]["origin"], nullptr), length, nullptr);
  text += BoundedRow(isMixed ? "  centre of volume" : "  centre of mass",
    sm::FormatVector(about["center_of_mass"], bounds["center_of_mass"]), length, bounds["center_of_mass"]);
  if (isMixed)
  {
    text += BoundedRow("  centre of mass", sm::FormatVector(about["mass_center"], bounds["mass_center"]),
      length, bounds["mass_center"]);
  }
  text += Rows("  inertia", about["inertia"], bounds["inertia"], sm::FormatUnit(file, 5), true);
  return about["mass_inertia"].is_null() ? text
                                         : text +
      Rows("  mass inertia", about["mass_inertia"], bounds["mass_inertia"], "kg " + sm::FormatUnit(file, 2),
        true);
}

/// How many of the file's validation properties are right, and those that are not.
std::string ValidationRows(const Json& file)
{
  if (!file.contains("validation"))
  {
    return {};
  }
  std::string text = Row("validation",
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
    text += Row("",
      Plain(entry["product"]) + ": " + Plain(entry["quantity"]) + " stated " + format("stated") +
        ", computed " + format("computed") + " " + sm::FormatUnit(file, power) + "; differs by " +
        Short(entry["difference"]) + ", limit " + Short(entry["limit"]),
      "", nullptr);
  }
  return text;
}

/// All rows of a file that the filter ran on.
std::string Results(const Json& file)
{
  const Json& total = file["total"];
  const Json& bounds = total["bounds"];
  const std::string length = sm::FormatUnit(file, 1);
  const std::string inertiaUnit = sm::FormatUnit(file, 5);
  const size_t solids = file["solids"].size();
  const std::string renderer = Plain(file["renderer"]);
  std::string text = "  " + Count(solids, "body", "bodies") + ", " + Count(file["faces"], "face", "faces") +
    ", unit " + length + ", backend " + Plain(file["backend"]) + (renderer.empty() ? "" : " on " + renderer) +
    "\n";
  text += BoundedRow(
    "volume", sm::FormatValue(total["volume"], bounds["volume"]), sm::FormatUnit(file, 3), bounds["volume"]);
  text += BoundedRow(
    "surface area", sm::FormatValue(total["area"], bounds["area"]), sm::FormatUnit(file, 2), bounds["area"]);
  // Where densities differ, the centre of the volume is not that of the mass.
  const bool isMixed = HasMixedDensities(total);
  text += BoundedRow(isMixed ? "centre of volume" : "centre of mass",
    sm::FormatVector(total["center_of_mass"], bounds["center_of_mass"]), length, bounds["center_of_mass"]);
  text += MassRows(total, file);
  text += Rows("inertia about centre", total["inertia"], bounds["inertia"], inertiaUnit, true);
  text += BoundedRow("principal moments", sm::FormatVector(total["principal_moments"], bounds["inertia"]),
    inertiaUnit, bounds["inertia"]);
  text += total["principal_axes_degenerate"] == true
    ? Row("principal axes", "not unique, moments coincide", "", nullptr)
    : Rows("principal axes", total["principal_axes"], 1e-9, "", false);
  text +=
    BoundedRow("radii of gyration", sm::FormatVector(total["radii_of_gyration"], bounds["radii_of_gyration"]),
      length, bounds["radii_of_gyration"]);
  const Json& box = total["bounding_box"];
  if (!box.is_null())
  {
    text += BoundedRow("bounding box",
      sm::FormatVector(box[0], bounds["bounding_box"]) + "  to  " +
        sm::FormatVector(box[1], bounds["bounding_box"]),
      length, bounds["bounding_box"]);
  }
  text += FrameRows(total, file);
  text += StabilityRows(total, file);
  text += IntegralRows(file);
  text += WaterlineRows(file);
  text += SectionRows(file);
  text += SchemeRows(total, file);
  text += ValidationRows(file);
  text += DefectRows(total, file);
  return text +
    Row("evaluations",
      Plain(file["evaluations"]) + " in " + Count(file["dispatches"], "dispatch", "dispatches"), "", nullptr);
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
    std::string name = Plain(solid["name"]);
    name = name.empty() ? Plain(solid["id"]) : name;
    text += "  " + sm::Pad(sm::Shorten(name, 23), 24) +
      sm::Pad(sm::FormatBrief(solid["volume"], bounds["volume"]), 18, true) +
      sm::Pad(sm::FormatBrief(solid["area"], bounds["area"]), 18, true) +
      massCells(sm::FormatValue(solid["density"], nullptr, 9), sm::FormatBrief(solid["mass"], bounds["mass"]),
        Plain(solid["material"])) +
      "  " + sm::Pad(sm::FormatBrief(solid["center_of_mass"], bounds["center_of_mass"]), 40) +
      (solid["stability"].is_object()
          ? sm::Pad(Plain(solid["status"]), 19) + Plain(solid["stability"]["verdict"])
          : Plain(solid["status"])) +
      "\n";
  }
  if (solids.size() > MaximumSolids)
  {
    text += "  ... and " + Count(solids.size() - MaximumSolids, "more solid", "more solids") +
      ", see --csv or --json\n";
  }
  return text;
}

// --- JSON and CSV ------------------------------------------------------------------------------

bool IsFlat(const Json& value)
{
  return std::none_of(value.begin(), value.end(), [](const Json& item) { return item.is_object(); });
}

std::string Write(const Json& value, const std::string& indent)
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
      (value.is_object() ? Dump(Json(item.key())) + ": " : "") + Write(*item, inner);
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
  return text + SolidRows(file) + sm::FormatPartsList(file) + FormatMessages(file);
}

std::string FormatJson(const Json& document)
{
  return Write(document, "") + "\n";
}
}
