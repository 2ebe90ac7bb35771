#include "smComparisonTable.h"

#include "smComparison.h"
#include "smFormat.h"
#include "smReport.h"
#include "smTableText.h"
#include "smText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace sm
{
namespace
{
constexpr size_t MostParts = 40;
constexpr size_t NameWidth = 32;

double ToNumber(const Json& value)
{
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// Returns the length of a vector, or the largest entry of a matrix.
double GetSize(const Json& value)
{
  double size = 0.0;
  for (const Json& entry : value)
  {
    for (const Json& number : entry.is_array() ? entry : Json::array())
    {
      size = std::max(size, std::abs(ToNumber(number)));
    }
    size = entry.is_array() ? size : std::hypot(size, ToNumber(entry));
  }
  return size;
}

/// Returns "volume -7.85 mm^3 (+- 1e-9)"; empty without a difference.
std::string FormatDifference(
  const Json& differences, const char* quantity, const std::string& label, const std::string& unit)
{
  const Json& difference = differences[quantity];
  const Json& value = difference["difference"];
  const double bound = ToNumber(difference["bound"]);
  return value.is_null() ? std::string()
                         : ", " + label + " " +
      FormatWithBound(value.is_array() ? GetSize(value) : value.get<double>(), bound, unit);
}

/// Returns "by 12.5 mm", or "by 3 to 12.5 mm"; empty if all values would be shown as 0.
std::string FormatRange(const Json& part, const char* key, const std::string& unit)
{
  double least = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (const Json& body : part["bodies"])
  {
    const double value = ToNumber(body[key]);
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  const std::string low = FormatDigits(least, 6);
  const std::string high = FormatDigits(largest, 6);
  return largest < 1e-9 ? std::string() : (low == high ? low : low + " to " + high) + " " + unit;
}

std::string FormatMotion(const Json& part, const std::string& unit)
{
  const std::string distance = FormatRange(part, "distance", unit);
  std::string angle = FormatRange(part, "rotation_angle", "degrees");
  const Json& axis = part["bodies"][0]["rotation_axis"];
  if (!angle.empty() && part["bodies"].size() == 1)
  {
    angle += " about " + FormatTriple(axis[0].get<double>(), axis[1].get<double>(), axis[2].get<double>());
  }
  return (distance.empty() ? "" : ", by " + distance) + (angle.empty() ? "" : ", rotated by " + angle);
}

/// Returns a text with the differences and notes of a part.
std::string Describe(const Json& part, const Json& newFile)
{
  std::string text;
  const std::string state = part["state"].get<std::string>();
  if (state == states::Changed)
  {
    text += FormatDifference(part["difference"], "volume", "volume", FormatUnit(newFile, 3)) +
      FormatDifference(part["difference"], "area", "area", FormatUnit(newFile, 2)) +
      FormatDifference(part["difference"], "mass", "mass", "kg");
  }
  // The distance of an unchanged part is only rounding.
  if (state != states::Unchanged && part["bodies"][0]["distance"].is_number())
  {
    text += FormatMotion(part, FormatUnit(newFile, 1));
  }
  for (const Json& note : part["notes"])
  {
    text += ", " + note.get<std::string>();
  }
  return text.empty() ? "" : text.substr(2);
}

/// Returns a row of the totals: old, new, difference; for vectors and tensors the size of the difference.
std::string FormatTotal(
  const Json& differences, const char* quantity, const std::string& label, const std::string& unit)
{
  const Json& difference = differences[quantity];
  const Json& value = difference["difference"];
  if (value.is_null() && difference["old"].is_null() && difference["new"].is_null())
  {
    return {};
  }
  const auto show = [](const Json& number)
  { return number.is_array() ? std::string() : FormatValue(number, nullptr); };
  const double bound = ToNumber(difference["bound"]);
  const double size = value.is_array() ? GetSize(value) : ToNumber(value);
  return TrimEnd("  " + Pad(label + " " + unit, 28) + Pad(show(difference["old"]), 20, true) +
           Pad(show(difference["new"]), 20, true) +
           Pad(value.is_null() ? "-" : FormatNumber(size, bound), 20, true) +
           (std::isfinite(bound) ? "  +/- " + FormatBoundOfShown(bound) : std::string())) +
    "\n";
}

std::string FormatTotals(const Json& total, const Json& newFile)
{
  const std::string length = FormatUnit(newFile, 1);
  return "\n  " + Pad("all solids together", 28) + Pad("old", 20, true) + Pad("new", 20, true) +
    Pad("difference", 20, true) + "\n" + FormatTotal(total, "volume", "volume", FormatUnit(newFile, 3)) +
    FormatTotal(total, "area", "surface area", FormatUnit(newFile, 2)) +
    FormatTotal(total, "center_of_mass", "centre of mass", length) +
    FormatTotal(total, "inertia", "inertia about centre", FormatUnit(newFile, 5)) +
    FormatTotal(total, "mass", "mass", "kg") +
    FormatTotal(total, "mass_inertia", "mass inertia", "kg " + FormatUnit(newFile, 2));
}

std::string FormatParts(const Json& parts, const Json& newFile)
{
  std::string text = "\n  " + Pad("part", NameWidth) + Pad("state", 11) + Pad("count", 7, true) +
    Pad("old", 7, true) + Pad("new", 7, true) + "\n";
  for (size_t i = 0; i < std::min(parts.size(), MostParts); ++i)
  {
    const Json& part = parts[i];
    const std::string name = part["name"].get<std::string>();
    text += TrimEnd("  " + Pad(Shorten(name.empty() ? "(no name)" : name, NameWidth - 1), NameWidth) +
              Pad(part["state"].get<std::string>(), 11) + Pad(Dump(part["count"]), 7, true) +
              Pad(Dump(part["in_old"]), 7, true) + Pad(Dump(part["in_new"]), 7, true) + "  " +
              Describe(part, newFile)) +
      "\n";
  }
  return parts.size() > MostParts
    ? text + "  ... and " + std::to_string(parts.size() - MostParts) + " more, see --json\n"
    : text;
}

std::string FormatFile(const char* label, const Json& file)
{
  return std::string(label) + "  " + file["file"].get<std::string>() + "   " +
    file["status"].get<std::string>() + "\n" + FormatMessages(file);
}
}

std::string FormatComparison(const Json& oldFile, const Json& newFile, const Json& comparison)
{
  const std::string head = FormatFile("old", oldFile) + FormatFile("new", newFile);
  if (comparison.is_null())
  {
    return head + "\nthe products cannot be compared\n";
  }
  std::string counts;
  for (const auto& item : comparison["counts"].items())
  {
    if (item.value() != 0)
    {
      counts += (counts.empty() ? "" : ", ") + Dump(item.value()) + " " + item.key();
    }
  }
  return head + FormatParts(comparison["parts"], newFile) + FormatTotals(comparison["total"], newFile) +
    "\nthe products " + (comparison["equal"] == true ? "are equal" : "differ") +
    (counts.empty() ? "" : ": " + counts) + "\n";
}
}
