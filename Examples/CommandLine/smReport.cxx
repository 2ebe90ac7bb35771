#include "smReport.h"

#include "smFormat.h"
#include "smText.h"

#include <algorithm>
#include <cmath>

namespace
{
using sm::Dump;
using sm::Json;

const size_t MaximumSolids = 20;
const size_t MaximumMessages = 12;

/// True for every byte but those that continue a character of UTF-8.
bool StartsCharacter(char byte)
{
  return (static_cast<unsigned char>(byte) & 0xC0) != 0x80;
}

size_t Length(const std::string& text)
{
  return static_cast<size_t>(std::count_if(text.begin(), text.end(), StartsCharacter));
}

std::string Shorten(const std::string& text, size_t width)
{
  size_t end = 0;
  for (size_t count = 0; end < text.size(); ++end)
  {
    count += StartsCharacter(text[end]) ? 1 : 0;
    if (count > width)
    {
      break;
    }
  }
  return text.substr(0, end);
}

std::string Pad(const std::string& text, size_t width, bool right = false)
{
  const size_t length = Length(text);
  const std::string blanks(length < width ? width - length : 0, ' ');
  return right ? blanks + text : text + blanks;
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
  if (!value.is_number())
  {
    return "-";
  }
  const double bound = value.get<double>();
  double shown = bound;
  std::string text = sm::FormatDigits(shown, 2);
  while (sm::ParseNumber(text) < bound)
  {
    // Half a unit of the second digit is at most a twentieth of the number.
    shown *= 1.01;
    text = sm::FormatDigits(shown, 2);
  }
  return text;
}

// --- the table ---------------------------------------------------------------------------------

std::string Row(
  const std::string& label, const std::string& value, const std::string& unit, const Json& bound)
{
  std::string line = "  " + Pad(label, 22) + value;
  if (value != "-" && !unit.empty())
  {
    line += " " + unit;
  }
  if (bound.is_number())
  {
    line = Pad(line, 80) + "  +/- " + ShortBound(bound);
  }
  return line + "\n";
}

/// A row of a value that has a bound, or says that it has none.
std::string BoundedRow(
  const std::string& label, const std::string& value, const std::string& unit, const Json& bound)
{
  const std::string row = Row(label, value, unit, bound);
  return value == "-" || bound.is_number() ? row : Pad(row.substr(0, row.size() - 1), 80) + "  no bound\n";
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
    const std::string line = Pad(cells[i][0], width, true) + "  " + Pad(cells[i][1], width, true) + "  " +
      Pad(cells[i][2], width, true);
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
  return integrals.size() > most
    ? text + "  ... and " + std::to_string(integrals.size() - most) + " more integrals, see --json\n"
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
    text += BoundedRow("below " + Short(waterline["height"]),
      sm::FormatValue(waterline["volume"], bounds["volume"]), sm::FormatUnit(file, 3), bounds["volume"]);
    text += BoundedRow("  its centre", sm::FormatVector(waterline["center"], bounds["center"]),
      sm::FormatUnit(file, 1), bounds["center"]);
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

/// All rows of a file that the filter ran on.
std::string Results(const Json& file)
{
  const Json& total = file["total"];
  const Json& bounds = total["bounds"];
  const std::string length = sm::FormatUnit(file, 1);
  const std::string inertiaUnit = sm::FormatUnit(file, 5);
  const size_t solids = file["solids"].size();
  const std::string renderer = Plain(file["renderer"]);
  std::string text = "  " + std::to_string(solids) + (solids == 1 ? " body, " : " bodies, ") +
    Plain(file["faces"]) + " faces, unit " + length + ", backend " + Plain(file["backend"]) +
    (renderer.empty() ? "" : " on " + renderer) + "\n";
  text += BoundedRow(
    "volume", sm::FormatValue(total["volume"], bounds["volume"]), sm::FormatUnit(file, 3), bounds["volume"]);
  text += BoundedRow(
    "surface area", sm::FormatValue(total["area"], bounds["area"]), sm::FormatUnit(file, 2), bounds["area"]);
  text += BoundedRow("centre of mass", sm::FormatVector(total["center_of_mass"], bounds["center_of_mass"]),
    length, bounds["center_of_mass"]);
  if (!total["mass"].is_null())
  {
    text += BoundedRow("mass", sm::FormatValue(total["mass"], bounds["mass"]), "kg", bounds["mass"]);
  }
  text += Rows("inertia about centre", total["inertia"], bounds["inertia"], inertiaUnit, true);
  text += BoundedRow("principal moments", sm::FormatVector(total["principal_moments"], bounds["inertia"]),
    inertiaUnit, bounds["inertia"]);
  text += total["principal_axes_degenerate"] == true
    ? Row("principal axes", "not unique, moments coincide", "", nullptr)
    : Rows("principal axes", total["principal_axes"], 1e-9, "", false);
  text += StabilityRows(total, file);
  text += IntegralRows(file);
  text += WaterlineRows(file);
  text += SchemeRows(total, file);
  text += DefectRows(total, file);
  return text +
    Row("evaluations", Plain(file["evaluations"]) + " in " + Plain(file["dispatches"]) + " dispatches", "",
      nullptr);
}

/// At most 9 digits of a number, or of the largest of three numbers; with a ~ when they have no bound.
std::string Brief(const Json& value, const Json& bound)
{
  if (value.is_null())
  {
    return "-";
  }
  double limit = bound.is_number() ? bound.get<double>() : 0.0;
  for (const Json& number : value.is_array() ? value : Json::array({ value }))
  {
    limit = std::max(limit, 1e-9 * std::abs(number.get<double>()));
  }
  return (bound.is_number() ? "" : "~") +
    (value.is_array() ? sm::FormatVector(value, limit) : sm::FormatValue(value, limit));
}

std::string SolidRows(const Json& file)
{
  const Json& solids = file["solids"];
  if (solids.size() < 2)
  {
    return {};
  }
  const std::string unit = sm::FormatUnit(file, 1);
  std::string text = "\n  " + Pad("solid", 24) + Pad("volume " + sm::FormatUnit(file, 3), 18, true) +
    Pad("area " + sm::FormatUnit(file, 2), 18, true) + "  " + Pad("centre of mass " + unit, 40) + "status\n";
  for (size_t i = 0; i < std::min(solids.size(), MaximumSolids); ++i)
  {
    const Json& solid = solids[i];
    const Json& bounds = solid["bounds"];
    std::string name = Plain(solid["name"]);
    name = name.empty() ? Plain(solid["id"]) : name;
    text += "  " + Pad(Shorten(name, 23), 24) + Pad(Brief(solid["volume"], bounds["volume"]), 18, true) +
      Pad(Brief(solid["area"], bounds["area"]), 18, true) + "  " +
      Pad(Brief(solid["center_of_mass"], bounds["center_of_mass"]), 40) + Plain(solid["status"]) + "\n";
  }
  if (solids.size() > MaximumSolids)
  {
    text +=
      "  ... and " + std::to_string(solids.size() - MaximumSolids) + " more solids, see --csv or --json\n";
  }
  return text;
}

std::string Messages(const Json& file)
{
  const Json& messages = file["messages"];
  std::string text;
  for (size_t i = 0; i < std::min(messages.size(), MaximumMessages); ++i)
  {
    text += "  note: " + Plain(messages[i]) + "\n";
  }
  if (messages.size() > MaximumMessages)
  {
    text += "  ... and " + std::to_string(messages.size() - MaximumMessages) + " more notes, see --json\n";
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
std::string FormatValue(const Json& value, const Json& bound, int digits)
{
  if (!value.is_number())
  {
    return "-";
  }
  double number = value.get<double>();
  const double limit = bound.is_number() ? bound.get<double>() : 0.0;
  if (limit > 0.0 && std::isfinite(limit))
  {
    // Entries of a tensor that are 0 within its bound are shown as 0 and not as rounding errors.
    const double unit = std::pow(10.0, std::floor(std::log10(limit)));
    number = std::round(number / unit) * unit;
  }
  const std::string text = FormatDigits(number, digits);
  return text == "-0" ? "0" : text;
}

std::string FormatVector(const Json& values, const Json& bound)
{
  if (values.is_null())
  {
    return "-";
  }
  const int digits = 10;
  return FormatValue(values[0], bound, digits) + "  " + FormatValue(values[1], bound, digits) + "  " +
    FormatValue(values[2], bound, digits);
}

std::string FormatUnit(const Json& file, int power)
{
  const Json& unit = file["length_unit"];
  return unit.is_null() || unit.empty() ? std::string()
    : power == 1                        ? unit.get<std::string>()
                                        : unit.get<std::string>() + "^" + std::to_string(power);
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
  return text + SolidRows(file) + Messages(file);
}

std::string FormatJson(const Json& document)
{
  return Write(document, "") + "\n";
}
}
