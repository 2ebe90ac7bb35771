#include "smReport.h"

#include "smFormat.h"
#include "smScheme.h"
#include "smStabilityAnalysis.h"
#include "smToleranceAnalysis.h"
#include "smValidationFile.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
const size_t MaximumSolids = 20;
const size_t MaximumMessages = 12;

/// Returns the rows of defects of the model, which are not part of the bounds: open edges and gaps.
std::string DefectRows(const FileResult& file)
{
  const TotalResult& total = file.Total;
  std::string text;
  if (total.OpenEdges > 0)
  {
    text += Row("open edges",
      std::to_string(total.OpenEdges) + ", closure residual " + Short(total.ClosureResidual), "");
  }
  if (total.ClosureCorrection > 0.0)
  {
    text += Row("gaps of the model",
      "widest " + ShortBound(total.MaxGap) + " " + file.FormatUnit(1) +
        "; closing them changed the volume by " + Short(total.ClosureCorrection) + " " + file.FormatUnit(3),
      "");
  }
  // What is far below the numerical bound is of no interest.
  if (total.Spread.Volume > 1e-3 * total.Volume.Bound)
  {
    text += Row("closed otherwise",
      "volume within " + ShortBound(total.Spread.Volume) + " " + file.FormatUnit(3) + ", area " +
        ShortBound(total.Spread.Area) + " " + file.FormatUnit(2) + ", centre " +
        ShortBound(total.Spread.Center) + " " + file.FormatUnit(1),
      "");
  }
  return text;
}

/// Returns the rows of mass, and of centre and inertia with the densities as weight. If only some solids have
/// a density, the mass is that of these.
std::string MassRows(const FileResult& file)
{
  const TotalResult& total = file.Total;
  if (!total.Mass.IsKnown())
  {
    return total.KnownMass.IsKnown() ? MeasuredRow("mass of " + std::to_string(total.SolidsWithMass) +
                                           " of " + std::to_string(total.SolidsWithVolume),
                                         total.KnownMass, "kg")
                                     : std::string();
  }
  std::string text = MeasuredRow("mass", total.Mass, "kg");
  const auto& [sum, density, gaps, numerical, overridden, tolerance] = total.MassUncertainty;
  const bool isOverridden = total.OverriddenMass > 0.0;
  if (isOverridden)
  {
    text += Row("  of it overridden",
      FormatValue(total.OverriddenMass, Unknown) + " kg as the materials state" +
        (overridden > 0.0 ? "" : ", without a tolerance"),
      "");
  }
  const bool hasTolerances = total.Analyses.Find<ToleranceResult>();
  // The share of gaps is not known for open solids.
  if (density > 0.0 || !(gaps <= 1e-3 * numerical) || overridden > 0.0 || hasTolerances)
  {
    text += Row("mass in doubt",
      (std::isnan(sum) ? "not known" : ShortBound(sum) + " kg") + ": density " + ShortBound(density) +
        ", gaps " + ShortBound(gaps) + ", numerical " + ShortBound(numerical) +
        (isOverridden ? ", overridden masses " + ShortBound(overridden) : "") +
        (hasTolerances ? ", tolerances " + ShortBound(tolerance) : ""),
      "");
  }
  if (HasMixedDensities(total))
  {
    text += MeasuredRow("centre of mass", total.MassCenter, file.FormatUnit(1));
  }
  return text + MatrixRows("mass inertia", total.MassInertia, "kg " + file.FormatUnit(2));
}

/// Returns the rows of validation properties: the number of those that agree, and each one that does not.
std::string ValidationRows(const FileResult& file)
{
  if (!file.Validation)
  {
    return {};
  }
  std::string text = Row("validation",
    std::to_string(CountValidation(file, "pass")) + " pass, " +
      std::to_string(CountValidation(file, "fail")) + " fail, " +
      std::to_string(CountValidation(file, "not-comparable")) + " not comparable",
    "");
  size_t listed = 0;
  for (const ValidationEntry& entry : *file.Validation)
  {
    if (entry.Result != "fail" || ++listed > MaximumMessages)
    {
      continue;
    }
    const int power = entry.Quantity == "volume" ? 3 : entry.Quantity == "area" ? 2 : 1;
    const auto format = [](const std::vector<double>& values)
    { return values.size() == 3 ? FormatVector(values.data(), Unknown) : FormatValue(values[0], Unknown); };
    text += Row("",
      entry.Product + ": " + entry.Quantity + " stated " + format(entry.Stated) + ", computed " +
        format(entry.Computed) + " " + file.FormatUnit(power) + "; differs by " + Short(entry.Difference) +
        ", limit " + Short(entry.Limit),
      "");
  }
  return text;
}

/// Returns centre and inertia in the frame of reference of the options.
std::string FrameRows(const FileResult& file)
{
  if (!file.Total.About)
  {
    return {};
  }
  const FrameQuantities& about = *file.Total.About;
  const std::string length = file.FormatUnit(1);
  const bool isMixed = HasMixedDensities(file.Total);
  std::string text = Row("in the frame", "at " + FormatVector(file.Frame.data(), Unknown), length);
  text += MeasuredRow(isMixed ? "  centre of volume" : "  centre of mass", about.Center, length);
  text += isMixed ? MeasuredRow("  centre of mass", about.MassCenter, length) : "";
  text += MatrixRows("  inertia", about.Inertia, file.FormatUnit(5));
  return about.MassInertia.IsKnown()
    ? text + MatrixRows("  mass inertia", about.MassInertia, "kg " + file.FormatUnit(2))
    : text;
}

/// Returns the rows of the mass properties of all solids together.
std::string TotalRows(const FileResult& file)
{
  const TotalResult& total = file.Total;
  const std::string length = file.FormatUnit(1);
  const std::string inertiaUnit = file.FormatUnit(5);
  std::string text = MeasuredRow("volume", total.Volume, file.FormatUnit(3));
  text += MeasuredRow("surface area", total.Area, file.FormatUnit(2));
  // Where densities differ, the centre of the volume is not that of the mass.
  text += MeasuredRow(HasMixedDensities(total) ? "centre of volume" : "centre of mass", total.Center, length);
  text += MassRows(file);
  text += MatrixRows("inertia about centre", total.Inertia, inertiaUnit);
  VectorQuantity moments = total.PrincipalMoments;
  moments.Bound = total.Inertia.Bound;
  text += MeasuredRow("principal moments", moments, inertiaUnit);
  TensorQuantity axes = total.PrincipalAxes;
  axes.Bound = 1e-9;
  text += total.PrincipalAxesDegenerate == true ? Row("principal axes", "not unique, moments coincide", "")
                                                : MatrixRows("principal axes", axes, "", false);
  text += MeasuredRow("radii of gyration", total.RadiiOfGyration, length);
  if (total.LowCorner.IsKnown())
  {
    text += BoundedRow("bounding box",
      FormatVector(total.LowCorner.Value, total.LowCorner.Bound) + "  to  " +
        FormatVector(total.HighCorner.Value, total.LowCorner.Bound),
      length, total.LowCorner.Bound);
  }
  return text;
}

/// Returns all rows of a file on which the filter ran.
std::string Results(const FileResult& file)
{
  const std::string renderer = file.Renderer.value_or("-");
  std::string text = "  " + Count(static_cast<long long>(file.Solids.size()), "body", "bodies") + ", " +
    Count(file.Faces, "face", "faces") + ", unit " + file.FormatUnit(1) + ", backend " +
    file.Backend.value_or("-") + (renderer.empty() ? "" : " on " + renderer) +
    (file.BackendReason ? " (" + *file.BackendReason + ")" : "") + "\n";
  text += TotalRows(file) + FrameRows(file) + file.FormatAnalyses() + FormatSchemeRows(file);
  text += ValidationRows(file);
  text += DefectRows(file);
  return text +
    Row("evaluations",
      std::to_string(file.Evaluations) + " in " + Count(file.Dispatches, "dispatch", "dispatches"), "");
}

/// Returns the verdict of static stability; empty if it was not requested.
std::string GetVerdict(const BodyResult& body)
{
  const auto* stability = body.Analyses.Find<StabilityResult>();
  return stability ? stability->Verdict : std::string();
}

/// Returns a path of at most 23 characters, with its end, where single instances differ.
std::string ShortenPath(const std::string& path)
{
  const size_t slash = path.rfind('/');
  return path.size() <= 23 || slash == std::string::npos ? Shorten(path, 23)
                                                         : Shorten("..." + path.substr(slash), 23);
}

std::string SolidRows(const FileResult& file)
{
  const std::vector<SolidResult>& solids = file.Solids;
  if (solids.size() < 2)
  {
    return {};
  }
  const std::string unit = file.FormatUnit(1);
  const bool hasMass = std::any_of(solids.begin(), solids.end(),
    [](const SolidResult& solid)
    { return solid.Mass.IsKnown() || !std::isnan(solid.Density) || !solid.Material.empty(); });
  const auto massCells = [hasMass](
                           const std::string& density, const std::string& mass, const std::string& material)
  {
    return hasMass ? Pad(mass, 16, true) + Pad(density, 15, true) + "  " + Pad(Shorten(material, 18), 20)
                   : "";
  };
  const bool hasVerdict = !GetVerdict(solids[0]).empty();
  std::string text = "\n  " + Pad("solid", 24) + Pad("volume " + file.FormatUnit(3), 18, true) +
    Pad("area " + file.FormatUnit(2), 18, true) + massCells("density kg/m^3", "mass kg", "material") + "  " +
    Pad("centre of mass " + unit, 40) + (hasVerdict ? Pad("status", 19) + "stability\n" : "status\n");
  for (size_t i = 0; i < std::min(solids.size(), MaximumSolids); ++i)
  {
    const SolidResult& solid = solids[i];
    const std::string verdict = GetVerdict(solid);
    text += "  " + Pad(ShortenPath(solid.Path.empty() ? solid.Id : solid.Path), 24) +
      Pad(FormatBrief(solid.Volume.Get(), solid.Volume.Bound), 18, true) +
      Pad(FormatBrief(solid.Area.Get(), solid.Area.Bound), 18, true) +
      massCells(FormatValue(solid.Density, Unknown, 9), FormatBrief(solid.Mass.Get(), solid.Mass.Bound),
        solid.OverriddenMass > 0.0 ? "mass stated"
          : solid.Material.empty() ? "-"
                                   : solid.Material) +
      "  " + Pad(FormatBrief(solid.Center), 40) +
      (verdict.empty() ? solid.Status : Pad(solid.Status, 19) + verdict) + "\n";
  }
  if (solids.size() > MaximumSolids)
  {
    text += "  ... and " +
      Count(static_cast<long long>(solids.size() - MaximumSolids), "more solid", "more solids") +
      ", see --csv or --json\n";
  }
  return text;
}
}

std::string FormatMessages(const FileResult& file)
{
  std::string text;
  for (size_t i = 0; i < std::min(file.Messages.size(), MaximumMessages); ++i)
  {
    text += "  note: " + file.Messages[i] + "\n";
  }
  if (file.Messages.size() > MaximumMessages)
  {
    text += "  ... and " +
      Count(static_cast<long long>(file.Messages.size() - MaximumMessages), "more note", "more notes") +
      ", see --json\n";
  }
  return text;
}

std::string FormatTable(const FileResult& file)
{
  std::string text = file.File + "   " + file.Status + "\n";
  text += file.Backend ? Results(file) : std::string();
  const StageSeconds& seconds = file.Seconds;
  if (!std::isnan(seconds.Start))
  {
    text += Row("seconds",
      "start " + Short(seconds.Start) + ", read " + Short(seconds.Read) + ", prepare " +
        Short(seconds.Prepare) + ", integrate " + Short(seconds.Integrate),
      "");
  }
  return text + SolidRows(file) + FormatPartsList(file) + FormatMessages(file);
}
}
