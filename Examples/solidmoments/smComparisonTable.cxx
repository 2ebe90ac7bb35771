#include "smComparisonTable.h"

#include "smFormat.h"
#include "smReport.h"
#include "smResults.h"
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
constexpr size_t MaxParts = 40;
constexpr size_t NameWidth = 32;

/// Returns the number itself, the length of a vector, or the largest entry of a matrix.
template <std::size_t N>
double GetSize(const std::array<double, N>& value)
{
  double size = 0.0;
  for (const double number : value)
  {
    size = N == 3 ? std::hypot(size, number) : std::max(size, std::abs(number));
  }
  return N == 1 ? value[0] : size;
}

/// Returns "volume -7.85 mm^3 (+- 1e-9)"; empty without a difference.
std::string FormatDifference(
  const QuantityDifference<1>& difference, const std::string& label, const std::string& unit)
{
  return difference.Change.IsKnown()
    ? ", " + label + " " + FormatWithBound(difference.Change.Get(), difference.Change.Bound, unit)
    : std::string();
}

/// Returns "by 12.5 mm", or "by 3 to 12.5 mm"; empty if all values would be shown as 0.
std::string FormatRange(const ComparedPart& part, double ComparedBody::*member, const std::string& unit)
{
  double minimum = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (const ComparedBody& body : part.Bodies)
  {
    const double value = body.*member;
    minimum = std::min(minimum, value);
    largest = std::max(largest, value);
  }
  const std::string low = FormatDigits(minimum, 6);
  const std::string high = FormatDigits(largest, 6);
  return largest < 1e-9 ? std::string() : (low == high ? low : low + " to " + high) + " " + unit;
}

std::string FormatMotion(const ComparedPart& part, const std::string& unit)
{
  const std::string distance = FormatRange(part, &ComparedBody::Distance, unit);
  std::string angle = FormatRange(part, &ComparedBody::RotationAngle, "degrees");
  if (!angle.empty() && part.Bodies.size() == 1)
  {
    const std::array<double, 3>& axis = part.Bodies[0].RotationAxis;
    angle += " about " + FormatTriple(axis[0], axis[1], axis[2]);
  }
  return (distance.empty() ? "" : ", by " + distance) + (angle.empty() ? "" : ", rotated by " + angle);
}

/// Returns a text with the differences and notes of a part.
std::string Describe(const ComparedPart& part, const FileResult& newFile)
{
  std::string text;
  if (part.State == states::Changed && part.Difference)
  {
    text += FormatDifference(part.Difference->Volume, "volume", newFile.FormatUnit(3)) +
      FormatDifference(part.Difference->Area, "area", newFile.FormatUnit(2)) +
      FormatDifference(part.Difference->Mass, "mass", "kg");
  }
  // The distance of an unchanged part is only rounding.
  if (part.State != states::Unchanged && !std::isnan(part.Bodies[0].Distance))
  {
    text += FormatMotion(part, newFile.FormatUnit(1));
  }
  for (const std::string& note : part.Notes)
  {
    text += ", " + note;
  }
  return text.empty() ? "" : text.substr(2);
}

/// Returns a row of the totals: old, new, difference; for vectors and tensors the size of the difference.
template <std::size_t N>
std::string FormatTotal(
  const QuantityDifference<N>& difference, const std::string& label, const std::string& unit)
{
  if (!difference.Old.IsKnown() && !difference.New.IsKnown())
  {
    return {};
  }
  const auto show = [](const Quantity<N>& quantity)
  { return N > 1 && quantity.IsKnown() ? std::string() : FormatValue(quantity.Get(), Unknown); };
  const double bound = difference.Change.Bound;
  return TrimEnd("  " + Pad(label + " " + unit, 28) + Pad(show(difference.Old), 20, true) +
           Pad(show(difference.New), 20, true) +
           Pad(difference.Change.IsKnown() ? FormatNumber(GetSize(difference.Change.Value), bound) : "-", 20,
             true) +
           (std::isfinite(bound) ? "  +/- " + FormatBoundOfShown(bound) : std::string())) +
    "\n";
}

std::string FormatTotals(const Differences& total, const FileResult& newFile)
{
  const std::string length = newFile.FormatUnit(1);
  return "\n  " + Pad("all solids together", 28) + Pad("old", 20, true) + Pad("new", 20, true) +
    Pad("difference", 20, true) + "\n" + FormatTotal(total.Volume, "volume", newFile.FormatUnit(3)) +
    FormatTotal(total.Area, "surface area", newFile.FormatUnit(2)) +
    FormatTotal(total.Center, "centre of mass", length) +
    FormatTotal(total.Inertia, "inertia about centre", newFile.FormatUnit(5)) +
    FormatTotal(total.Mass, "mass", "kg") +
    FormatTotal(total.MassInertia, "mass inertia", "kg " + newFile.FormatUnit(2));
}

std::string FormatParts(const std::vector<ComparedPart>& parts, const FileResult& newFile)
{
  const auto count = [](std::size_t number) { return Pad(std::to_string(number), 7, true); };
  std::string text = "\n  " + Pad("part", NameWidth) + Pad("state", 11) + Pad("count", 7, true) +
    Pad("old", 7, true) + Pad("new", 7, true) + "\n";
  for (std::size_t i = 0; i < std::min(parts.size(), MaxParts); ++i)
  {
    const ComparedPart& part = parts[i];
    text +=
      TrimEnd("  " + Pad(Shorten(part.Name.empty() ? "(no name)" : part.Name, NameWidth - 1), NameWidth) +
        Pad(part.State, 11) + count(part.Bodies.size()) + count(part.InOld) + count(part.InNew) + "  " +
        Describe(part, newFile)) +
      "\n";
  }
  return parts.size() > MaxParts
    ? text + "  ... and " + std::to_string(parts.size() - MaxParts) + " more, see --json\n"
    : text;
}

std::string FormatFile(const char* label, const FileResult& file)
{
  return std::string(label) + "  " + file.File + "   " + file.Status + "\n" + FormatMessages(file);
}
}

std::string FormatComparison(
  const FileResult& oldFile, const FileResult& newFile, const std::optional<ProductDifference>& comparison)
{
  const std::string head = FormatFile("old", oldFile) + FormatFile("new", newFile);
  if (!comparison)
  {
    return head + "\nthe products cannot be compared\n";
  }
  std::string counts;
  for (const auto& [state, count] : comparison->Counts)
  {
    counts += count == 0 ? "" : (counts.empty() ? "" : ", ") + std::to_string(count) + " " + state;
  }
  return head + FormatParts(comparison->Parts, newFile) + FormatTotals(comparison->Total, newFile) +
    "\nthe products " + (comparison->IsEqual ? "are equal" : "differ") +
    (counts.empty() ? "" : ": " + counts) + "\n";
}
}
