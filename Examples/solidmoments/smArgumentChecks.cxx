#include "smArgumentChecks.h"

#include "smMaterialFile.h"
#include "smOptionValues.h"
#include "smText.h"
#include "smTrimText.h"
#include "smWeights.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace sm
{
std::string CheckBackend(const std::string& name)
{
  const bool known = name == "auto" || name == "opengl" || name == "cpu" || name == "egl" || name == "x";
  return known ? "" : "there is no backend " + name + "; use auto, opengl, cpu, x or egl";
}

std::string CheckCollision(const std::string& word)
{
  return word == "none" || word == "hull" ? "" : "--collision " + word + " is not known; use none or hull";
}

std::string CheckRepair(const std::string& word)
{
  const bool known = word == "always" || word == "needed" || word == "never";
  return known ? "" : "--repair " + word + " is not known; use always, needed or never";
}

std::string CheckHidden(const std::string& word)
{
  return word == "count" || word == "skip" || word == "only" ? "" : "choose count, skip or only";
}

std::string CheckUnit(const std::string& name)
{
  const std::set<std::string> known = { "mm", "cm", "m", "um", "inch", "in", "ft", "file" };
  return known.count(LowerCase(name)) ? ""
                                      : "there is no unit " + name + "; use mm, cm, m, um, inch, ft or file";
}

std::string CheckInputUnit(const std::string& name)
{
  return LowerCase(name) == "file" ? "there is no unit file; use mm, cm, m, um, inch or ft" : CheckUnit(name);
}

std::string CheckTolerance(const std::string& text)
{
  const double value = ParseNumber(text);
  return value > 0.0 && value <= 1.0 ? "" : "the tolerance must be a number above 0, at most 1";
}

std::string CheckGapLimit(const std::string& text)
{
  const double value = ParseNumber(text);
  return value >= 0.0 && value <= 1.0 ? "" : "the limit of gaps must be a number from 0 to 1";
}

std::string CheckValidationLimit(const std::string& text)
{
  const double value = ParseNumber(text);
  return value >= 0.0 && value <= 1.0 ? "" : "the limit of differences must be a number from 0 to 1";
}

std::string CheckQuantityTolerance(const std::string& text)
{
  std::string quantity;
  double relative = 0.0;
  double absolute = 0.0;
  return ParseQuantityTolerance(text, quantity, relative, absolute)
    ? ""
    : text + " is not the tolerance of a quantity; write for example volume=1e-6 or center=0,1e-3";
}

/// Checks that a text is a whole number from 1 to `maximum`.
std::string CheckFactor(const std::string& what, int maximum, const std::string& text)
{
  const double value = ParseNumber(text);
  return value >= 1.0 && value <= maximum && value == std::floor(value)
    ? ""
    : "the number of " + what + " must be a whole number from 1 to " + std::to_string(maximum);
}

std::string CheckEvaluations(const std::string& text)
{
  const double value = ParseNumber(text);
  return value >= 1.0 && value <= 1e18 ? "" : "the number of evaluations must be at least 1, at most 1e18";
}

std::string CheckSeconds(const std::string& text)
{
  const double value = ParseNumber(text);
  return value > 0.0 && value < 1e300 ? ""
                                      : "the seconds must be a number above 0; without the option there "
                                        "is no limit";
}

std::string CheckDensity(const std::string& text)
{
  return ParseDensity(text).Density > 0.0 ? ""
                                          : std::string("the density must be a number from ") + WeightRange +
      ", in kg/m^3, or a material of --list-materials";
}

std::string CheckShare(const std::string& text)
{
  return ParseShare(text) >= 0.0 ? "" : "the tolerance must be relative, from 0 to 1 or 0% to 100%";
}

std::string CheckFrame(const std::string& text)
{
  std::vector<double> frame;
  return ParseFrame(text, frame)
    ? ""
    : text + " is not a frame; write origin, a point X,Y,Z, or nine numbers: origin, z axis and x axis";
}

/// Returns an error message if the text is not a list of known words.
static std::string CheckWords(const std::string& text, const std::set<std::string>& known)
{
  std::string all;
  for (const std::string& word : known)
  {
    all += (all.empty() ? "" : ", ") + word;
  }
  for (const std::string& word : SplitFields(text))
  {
    if (!known.count(word))
    {
      return "\"" + word + "\" is none of " + all;
    }
  }
  return {};
}

std::string CheckFailOn(const std::string& text)
{
  return CheckWords(text, { "open", "tolerance-not-met", "suspect", "not-computed", "empty", "none" });
}

std::string CheckRequire(const std::string& text)
{
  return CheckWords(text, { "stable", "mass", "validation" });
}
}
