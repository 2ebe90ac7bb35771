// Rows of the table for results other than the mass properties.
#include "smReport.h"
#include "smReportRows.h"

#include "smFormat.h"
#include "smTableText.h"

namespace sm
{
namespace
{
/// Returns scheme, sub-patches and error estimate of a run with one of the paper's schemes.
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
        Short(total["paper_error_estimate"]) + " " + FormatUnit(file, 3),
      "", nullptr);
}

/// Returns the rows of the integrals of the options.
std::string IntegralRows(const Json& file)
{
  const size_t most = 40;
  const Json& integrals = file["integrals"];
  std::string text;
  size_t count = 0;
  for (auto item = integrals.begin(); item != integrals.end() && count < most; ++item, ++count)
  {
    const Json& bound = (*item)["bound"];
    text += BoundedRow(item.key(), FormatValue((*item)["value"], bound), "", bound);
  }
  return integrals.size() > most ? text + "  ... and " +
      Count(integrals.size() - most, "more integral", "more integrals") + ", see --json\n"
                                 : text;
}

/// Returns the rows of static stability, if it was requested.
std::string StabilityRows(const Json& total, const Json& file)
{
  const Json& found = total["stability"];
  if (found.is_null())
  {
    return {};
  }
  const std::string length = FormatUnit(file, 1);
  const Json& bounds = found["bounds"];
  const bool rolls = found["decided_by"] == "rolling";
  const std::string support = Plain(found["support"]);
  std::string text = Row("stability",
    Plain(found["verdict"]) +
      (support == "none" ? std::string()
                         : ", rests on " + std::string(support == "area" ? "an area" : "a " + support)) +
      (rolls ? ", decided by its curvature" : ""),
    "", nullptr);
  text += BoundedRow("stability margin", FormatValue(found["stability_margin"], bounds["stability_margin"]),
    length, bounds["stability_margin"]);
  if (rolls)
  {
    return text +
      BoundedRow("rolling margin", FormatValue(found["rolling_margin"], bounds["rolling_margin"]), length,
        bounds["rolling_margin"]);
  }
  text += BoundedRow("smallest tip angle", FormatValue(found["tip_angle"], bounds["tip_angle"]), "degrees",
    bounds["tip_angle"]);
  text += BoundedRow("rise before tipping",
    FormatValue(found["center_of_mass_rise"], bounds["center_of_mass_rise"]), length,
    bounds["center_of_mass_rise"]);
  return found["tip_energy"].is_null()
    ? text
    : text + Row("energy to tip", FormatValue(found["tip_energy"], nullptr, 9), "J", nullptr);
}

/// Returns volume and centre of buoyancy below each waterline.
std::string WaterlineRows(const Json& file)
{
  std::string text;
  for (const Json& waterline : file["waterlines"])
  {
    const Json& bounds = waterline["bounds"];
    text += BoundedRow("below " + Short(waterline["height"]) + " " + FormatUnit(file, 1),
      FormatValue(waterline["volume"], bounds["volume"]), FormatUnit(file, 3), bounds["volume"]);
    text += BoundedRow("  its centre", FormatVector(waterline["center"], bounds["center"]),
      FormatUnit(file, 1), bounds["center"]);
  }
  return text;
}

/// Returns the moments of each section, and volumes and centres on its sides.
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
          value += (value.empty() ? "" : "  ") + FormatValue(number, bounds[key]);
        }
        text += BoundedRow(label, value, power > 0 ? FormatUnit(file, power) : "kg", bounds[key]);
      }
    };
    text += Row("section at",
      FormatVector(section["point"], 1e-9) + "  normal  " + FormatVector(section["normal"], 1e-9), "",
      nullptr);
    text += BoundedRow(
      "  its area", FormatValue(section["area"], bounds["area"]), FormatUnit(file, 2), bounds["area"]);
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

/// Returns centre and inertia in the frame of reference of the options.
std::string FrameRows(const Json& total, const Json& file)
{
  const Json& about = total["about"];
  if (about.is_null())
  {
    return {};
  }
  const Json& bounds = about["bounds"];
  const std::string length = FormatUnit(file, 1);
  const bool isMixed = HasMixedDensities(total);
  std::string text =
    Row("in the frame", "at " + FormatVector(file["frame"]["origin"], nullptr), length, nullptr);
  text += BoundedRow(isMixed ? "  centre of volume" : "  centre of mass",
    FormatVector(about["center_of_mass"], bounds["center_of_mass"]), length, bounds["center_of_mass"]);
  if (isMixed)
  {
    text += BoundedRow("  centre of mass", FormatVector(about["mass_center"], bounds["mass_center"]), length,
      bounds["mass_center"]);
  }
  text += Rows("  inertia", about["inertia"], bounds["inertia"], FormatUnit(file, 5), true);
  return about["mass_inertia"].is_null() ? text
                                         : text +
      Rows(
        "  mass inertia", about["mass_inertia"], bounds["mass_inertia"], "kg " + FormatUnit(file, 2), true);
}
}

std::string AnalysisRows(const Json& total, const Json& file)
{
  return FrameRows(total, file) + StabilityRows(total, file) + IntegralRows(file) + WaterlineRows(file) +
    SectionRows(file) + SchemeRows(total, file);
}
}
