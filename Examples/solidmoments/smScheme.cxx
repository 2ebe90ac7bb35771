#include "smScheme.h"

#include "smArgumentChecks.h"
#include "smOptions.h"
#include "smReportRows.h"
#include "smResults.h"

#include <set>

namespace sm
{
namespace
{
std::string CheckScheme(const std::string& name)
{
  const std::set<std::string> known = { "adaptive", "midpoint", "gauss2", "gauss3" };
  return known.count(LowerCase(name))
    ? ""
    : "there is no scheme " + name + "; use adaptive, midpoint, gauss2 or gauss3";
}

std::string CheckDeviation(const std::string& name)
{
  return name == "bounded" || name == "sampled"
    ? ""
    : "there is no deviation " + name + "; use bounded or sampled";
}

std::string CheckChord(const std::string& text)
{
  const double value = ParseNumber(text);
  return value > 0.0 && value < 1.0 ? "" : "the chord tolerance must be a number above 0 and below 1";
}
}

void Scheme::Declare(CLI::App& app)
{
  app.option_defaults()->group("Schemes of the paper");
  app
    .add_option_function<std::string>(
      "--scheme", [this](const std::string& name) { this->Name = LowerCase(name); },
      "adaptive (default): to the tolerance, with bounds; midpoint, gauss2 or\n"
      "gauss3: those of \"Accurate Moment Computation Using the GPU\", for\n"
      "comparison, with the paper's estimate of the error and without a bound")
    ->type_name("NAME")
    ->check(CheckScheme);
  app
    .add_option(
      "--subpatches", this->SubPatches, "Paper's schemes: K x K sub-patches per knot interval (default 2)")
    ->type_name("K")
    ->check([](const std::string& text) { return CheckFactor("sub-patches", 1024, text); });
  app
    .add_option(
      "--trim-texture", this->TrimTexture, "Paper's schemes: M x M texels per sub-patch (default 4)")
    ->type_name("M")
    ->check([](const std::string& text) { return CheckFactor("texels", 16, text); });
  AddNumberOption(app, "--chord", this->ChordTolerance,
    "Paper's schemes: largest distance of the chords of planar faces' trim\n"
    "curves from these, relative to the size of the solid (default 1e-8)")
    ->check(CheckChord);
  app
    .add_option("--deviation", this->Deviation,
      "Paper's schemes: how the error estimate finds the deviation of a\n"
      "sub-patch: bounded (default), or sampled")
    ->type_name("NAME")
    ->check(CheckDeviation);
  AddFileOption(app, "--trim-textures", this->TextureFolder,
    "Write the trim textures of the paper's schemes to FOLDER, a PNG per face")
    ->type_name("FOLDER");
}

std::string Scheme::FindProblem(const CLI::App& app) const
{
  if (!this->IsAdaptive() && GetMissingModule())
  {
    return std::string("--scheme needs a build with ") + GetMissingModule() + "=ON: this one is without";
  }
  for (const char* option : { "--subpatches", "--trim-texture", "--chord", "--deviation", "--trim-textures" })
  {
    if (app.count(option) > 0 && this->IsAdaptive())
    {
      return std::string(option) + " is for the paper's schemes: add --scheme midpoint, gauss2 or gauss3";
    }
  }
  for (const char* option : { "--tolerance", "--tolerance-of" })
  {
    if (app.count(option) > 0 && !this->IsAdaptive())
    {
      return std::string(option) + " is for --scheme adaptive: the paper's schemes have no tolerance";
    }
  }
  return {};
}

std::string FormatSchemeRows(const FileResult& file)
{
  if (file.Total.SubPatches < 0 || !file.SchemeOptions)
  {
    return {};
  }
  const SchemeResult& options = *file.SchemeOptions;
  const std::string texels = std::to_string(options.TextureFactor);
  return Row("scheme",
           file.Scheme.value_or("-") + ", k = " + std::to_string(options.SubPatchFactor) + ", " + texels +
             " x " + texels + " texels per sub-patch, chords of planes to " + Short(options.ChordTolerance) +
             ", deviations " + options.Deviation,
           "") +
    Row("",
      "on " + std::to_string(file.Total.SubPatches) +
        " sub-patches; the paper's error estimate of the volume (not a bound): " +
        Short(file.Total.PaperErrorEstimate) + " " + file.FormatUnit(3),
      "");
}
}
