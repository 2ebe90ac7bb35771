#include "smArguments.h"

#include "smOutputFiles.h"
#include "smUserIntegrals.h"
#include "smVersion.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <set>

namespace
{
const char* Footer =
  R"(Results are in millimetres unless --unit says otherwise; inertia is about the centre of mass, for unit
density. The number after +/- is the bound of the numerical error; what the model itself leaves open (gaps
between faces, open edges) is said apart. A value that does not exist is null in JSON, empty in CSV.
Each file is read in a process of its own: one that crashes costs only itself.

Examples:
  solidmoments bracket.step
  solidmoments bracket.step --png bracket.png
  solidmoments --unit inch --density 2700 bracket.step
  solidmoments *.step --quiet --json results.json --csv results.csv

Exit status:
  0  all files computed with status ok
  1  wrong usage, or an output (table, JSON, CSV, PNG) could not be written
  2  some file is unreadable
  3  some result is flagged: open, tolerance-not-met, suspect, empty
The first of 1, 2, 3 that applies. 130 after Ctrl-C, 143 when told to end (SIGTERM): then the outputs hold
the files finished before.)";

std::string CheckScheme(const std::string& name)
{
  const std::set<std::string> known = { "adaptive", "midpoint", "gauss2", "gauss3" };
  return known.count(sm::LowerCase(name))
    ? ""
    : "there is no scheme " + name + "; use adaptive, midpoint, gauss2 or gauss3";
}

std::string CheckDeviation(const std::string& name)
{
  return name == "bounded" || name == "sampled"
    ? ""
    : "there is no deviation " + name + "; use bounded or sampled";
}

std::string CheckBackend(const std::string& name)
{
  const bool known = name == "auto" || name == "opengl" || name == "cpu" || name == "egl" || name == "x";
  return known ? "" : "there is no backend " + name + "; use auto, opengl, cpu, x or egl";
}

std::string CheckUnit(const std::string& name)
{
  const std::set<std::string> known = { "mm", "cm", "m", "um", "inch", "in", "ft", "file" };
  return known.count(sm::LowerCase(name))
    ? ""
    : "there is no unit " + name + "; use mm, cm, m, um, inch, ft or file";
}

/// NaN when the text is not a number from end to end.
double ParseNumber(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return text.empty() || *end != '\0' ? std::numeric_limits<double>::quiet_NaN() : value;
}

std::string CheckTolerance(const std::string& text)
{
  const double value = ParseNumber(text);
  return value > 0.0 && value <= 1.0 ? "" : "the tolerance must be a number above 0, at most 1";
}

std::string CheckQuantityTolerance(const std::string& text)
{
  std::string quantity;
  double relative = 0.0;
  double absolute = 0.0;
  return sm::ParseQuantityTolerance(text, quantity, relative, absolute)
    ? ""
    : text + " is no tolerance of a quantity; write for example volume=1e-6 or center=0,1e-3";
}

/// A whole number from 1 to `most`.
std::string CheckFactor(const std::string& what, int most, const std::string& text)
{
  const double value = ParseNumber(text);
  return value >= 1.0 && value <= most && value == std::floor(value)
    ? ""
    : "the number of " + what + " must be a whole number from 1 to " + std::to_string(most);
}

std::string CheckChord(const std::string& text)
{
  const double value = ParseNumber(text);
  return value > 0.0 && value < 1.0 ? "" : "the chord tolerance must be a number above 0 and below 1";
}

std::string CheckEvaluations(const std::string& text)
{
  const double value = ParseNumber(text);
  return value >= 1.0 && value <= 1e18 ? "" : "the number of evaluations must be at least 1, at most 1e18";
}

std::string CheckSeconds(const std::string& text)
{
  const double value = ParseNumber(text);
  return value >= 0.0 && value < 1e300 ? "" : "the seconds must be a number that is not negative";
}

std::string CheckDegree(const std::string& text)
{
  const double value = ParseNumber(text);
  return value >= 0.0 && value <= sm::LargestMomentDegree && value == std::floor(value)
    ? ""
    : "the degree of moments must be a whole number from 0 to " + std::to_string(sm::LargestMomentDegree);
}

std::string CheckIntegral(const std::string& text)
{
  std::string name;
  std::string expression;
  return sm::ParseIntegral(text, name, expression)
    ? ""
    : text + " is no integral; write NAME=EXPRESSION, for example 'area=dA'";
}

std::string CheckHeight(const std::string& text)
{
  return std::isfinite(ParseNumber(text)) ? "" : "the height of a waterline must be a finite number";
}

std::string CheckDirection(const std::string& text)
{
  std::array<double, 3> direction;
  return sm::ParseDirection(text, direction)
    ? ""
    : text + " is no direction; write x, y, z, -x, -y, -z, or three numbers such as 0,0.1,-1";
}

std::string CheckDensity(const std::string& text)
{
  const double value = ParseNumber(text);
  return value > 0.0 && value < 1e300 ? "" : "the density must be a positive number, in kg/m^3";
}

void Declare(CLI::App& app, sm::Arguments& arguments)
{
  app.add_option("FILE", arguments.Files, "STEP files")->required()->type_name("");
  app
    .add_option(
      "--json", arguments.Json, "Write all results as JSON; - for standard output, and then no table")
    ->type_name("FILE");
  app.add_option("--csv", arguments.Csv, "Write a row per file and per solid; - as for --json")
    ->type_name("FILE");
  app
    .add_option("--png", arguments.Picture,
      "Draw the part, translucent, with its centre of mass marked. Of several\n"
      "files, each picture has the STEP file's name added: out-bracket.png")
    ->type_name("FILE");
  app
    .add_option("--tolerance", arguments.Job.Tolerance,
      "Tolerance of every result, relative to the size of the solid (default 1e-9)")
    ->type_name("NUMBER")
    ->check(CheckTolerance);
  app
    .add_option("--tolerance-of", arguments.Job.QuantityTolerances,
      "Tolerance of one quantity, volume, area, center or inertia: relative (0:\n"
      "that of --tolerance), or relative and absolute, of which the larger\n"
      "counts; may be given several times: --tolerance-of center=0,1e-6")
    ->type_name("NAME=REL[,ABS]")
    ->check(CheckQuantityTolerance)
    ->take_all()
    ->expected(1);
  app
    .add_option("--max-evaluations", arguments.Job.MaximumEvaluations,
      "Most surface evaluations of a file (default 2e9); where that is too few,\n"
      "the tolerance is loosened and the bounds say by how much")
    ->type_name("NUMBER")
    ->check(CheckEvaluations);
  app
    .add_option("--max-seconds", arguments.Job.MaximumSeconds,
      "Most seconds to integrate a file (default: no limit); faces not reached\n"
      "count as 0, and the bounds hold what they may be")
    ->type_name("NUMBER")
    ->check(CheckSeconds);
  app
    .add_option("--unit", arguments.Job.Unit,
      "Length unit of all results: mm (default), cm, m, um, inch, ft; or file:\n"
      "the one that the file is written in")
    ->type_name("UNIT")
    ->check(CheckUnit);
  app
    .add_option("--density", arguments.Job.Density,
      "Density in kg/m^3, for the mass in kg (default: what the file states)")
    ->type_name("NUMBER")
    ->check(CheckDensity);
  app
    .add_option("--backend", arguments.Job.Backend,
      "opengl: compute shaders, on the X display or through EGL where there is\n"
      "none; x or egl: only that one; cpu: no OpenGL; auto (default): opengl\n"
      "where there is OpenGL 4.3 with doubles, else cpu")
    ->type_name("NAME")
    ->check(CheckBackend);
  app.add_flag("--quiet,-q", arguments.Quiet, "Print no table and no progress, only errors");
  app.set_version_flag("--version", std::string("solidmoments ") + sm::Version);
  app.footer(Footer);
}

/// Integrals besides mass properties.
void DeclareIntegrals(CLI::App& app, sm::Arguments& arguments)
{
  app
    .add_option("--moments", arguments.Job.MomentDegree,
      "Integrals of x^i y^j z^k over the volume, i + j + k up to DEGREE:\n"
      "moment_i_j_k")
    ->type_name("DEGREE")
    ->check(CheckDegree);
  app
    .add_option("--integral", arguments.Job.Integrals,
      "Integral over the faces of an expression (GLSL) of position, normal (of\n"
      "the length of the area element dA), unitNormal, u, v, du, dv, duu, duv,\n"
      "dvv, meanCurvature, gaussianCurvature; with OpenGL only; may be given\n"
      "several times: --integral 'willmore=pow(meanCurvature, 2) * dA'")
    ->type_name("NAME=EXPR")
    ->check(CheckIntegral)
    ->take_all()
    ->expected(1);
}

void DeclareWaterlines(CLI::App& app, sm::Arguments& arguments)
{
  app
    .add_option("--waterline", arguments.Job.Waterlines,
      "Volume below a waterline, and its centre, the centre of buoyancy: the\n"
      "plane at HEIGHT along --up from the origin, in the unit of the results;\n"
      "may be given several times")
    ->type_name("HEIGHT")
    ->check(CheckHeight)
    ->take_all()
    ->expected(1);
  app.add_option("--up", arguments.Up, "Direction out of the water, of any length (default 0,0,1)")
    ->type_name("X,Y,Z")
    ->check(CheckDirection);
}

void DeclareStability(CLI::App& app, sm::Arguments& arguments)
{
  app
    .add_option("--stability", arguments.Job.Stability,
      "Whether the part stands on its lowest points when things fall along DIR,\n"
      "x, y, z, +x .. -z or three numbers: margin of the plumb line inside the\n"
      "contacts, angle and rise of the centre until it tips, with bounds; all\n"
      "solids as one body, and each alone: --stability -z")
    ->type_name("DIR")
    ->check(CheckDirection)
    ->expected(1);
}

/// The schemes of the paper, and what they alone take.
void DeclareSchemes(CLI::App& app, sm::Arguments& arguments)
{
  sm::JobOptions& job = arguments.Job;
  app
    .add_option("--scheme", job.Scheme,
      "adaptive (default): to the tolerance, with bounds; midpoint, gauss2 or\n"
      "gauss3: those of \"Accurate Moment Computation Using the GPU\", for\n"
      "comparison, with the paper's estimate of the error and without a bound")
    ->type_name("NAME")
    ->check(CheckScheme);
  app
    .add_option("--subpatches", job.SubPatches,
      "Of the paper's schemes: K x K sub-patches per knot interval (default 2)")
    ->type_name("K")
    ->check([](const std::string& text) { return CheckFactor("sub-patches", 1024, text); });
  app
    .add_option(
      "--trim-texture", job.TrimTexture, "Of the paper's schemes: M x M texels per sub-patch (default 4)")
    ->type_name("M")
    ->check([](const std::string& text) { return CheckFactor("texels", 16, text); });
  app
    .add_option("--chord", job.ChordTolerance,
      "Of the paper's schemes: how far the chords of planar faces' trim curves\n"
      "may be from these, relative to the size of the solid (default 1e-8)")
    ->type_name("NUMBER")
    ->check(CheckChord);
  app
    .add_option("--deviation", job.Deviation,
      "Of the paper's schemes: how its error estimate finds the deviation of a\n"
      "sub-patch: bounded (default), or sampled")
    ->type_name("NAME")
    ->check(CheckDeviation);
  app
    .add_option("--trim-textures", arguments.TextureFolder,
      "Write the trim textures of the paper's schemes there, a PNG per face")
    ->type_name("FOLDER");
}

/// An option whose module this program was built without, in a sentence; empty when there is none.
std::string FindMissingModule(const CLI::App& app, const sm::Arguments& arguments)
{
  const auto say = [](const char* option, const char* module)
  { return std::string(option) + " needs a build with " + module + "=ON: this one is without"; };
#ifndef SM_HAS_BUOYANCY
  if (app.count("--waterline") > 0)
  {
    return say("--waterline", "SOLIDMOMENTS_ENABLE_BUOYANCY");
  }
#endif
#ifndef SM_HAS_STABILITY
  if (app.count("--stability") > 0)
  {
    return say("--stability", "SOLIDMOMENTS_ENABLE_STABILITY");
  }
#endif
#ifndef SM_HAS_MOMENT_SCHEMES
  if (arguments.Job.Scheme != "adaptive")
  {
    return say("--scheme", "SOLIDMOMENTS_ENABLE_MOMENT_SCHEMES");
  }
#endif
  (void)app;
  (void)arguments;
  (void)say;
  return {};
}

/// What is wrong with arguments that are well-formed one by one; empty when nothing is.
std::string FindProblem(const CLI::App& app, const sm::Arguments& arguments)
{
  if (std::count(arguments.Files.begin(), arguments.Files.end(), "") > 0)
  {
    return "a file name is empty; name a STEP file";
  }
  for (const char* option : { "--json", "--csv", "--png", "--trim-textures" })
  {
    if (app.count(option) > 0 && app[option]->as<std::string>().empty())
    {
      return std::string("the file name of ") + option + " is empty";
    }
  }
  for (const char* option : { "--subpatches", "--trim-texture", "--chord", "--deviation", "--trim-textures" })
  {
    if (app.count(option) > 0 && arguments.Job.Scheme == "adaptive")
    {
      return std::string(option) + " is for the paper's schemes: add --scheme midpoint, gauss2 or gauss3";
    }
  }
  for (const char* option : { "--tolerance", "--tolerance-of" })
  {
    if (app.count(option) > 0 && arguments.Job.Scheme != "adaptive")
    {
      return std::string(option) + " is for --scheme adaptive: the paper's schemes know no tolerance";
    }
  }
  const std::string missing = FindMissingModule(app, arguments);
  if (!missing.empty())
  {
    return missing;
  }
  const std::string clash = sm::FindClash(arguments.Job);
  if (!clash.empty())
  {
    return "two results would be called " + clash + ": give an integral another name";
  }
  if (app.count("--up") > 0 && arguments.Job.Waterlines.empty())
  {
    return "--up is for --waterline: add a height";
  }
  if (arguments.Json == "-" && arguments.Csv == "-")
  {
    return "only one of --json and --csv can go to standard output";
  }
  if (arguments.Picture == "-")
  {
    return "a picture needs a file: --png cannot go to standard output";
  }
  const std::string picture = sm::LowerCase(arguments.Picture);
  if (!picture.empty() && (picture.size() < 4 || picture.compare(picture.size() - 4, 4, ".png") != 0))
  {
    return "--png writes PNG files only: the name must end in .png, and " + arguments.Picture + " does not";
  }
  const std::string problem = sm::CheckOutputs(arguments);
  return problem.empty() ? sm::MakeTextureFolder(arguments) : problem;
}
}

namespace sm
{
std::optional<int> ParseArguments(int argc, char** argv, Arguments& arguments)
{
  CLI::App app("Volume, area, centre of mass and inertia of the parts in STEP files, from their exact NURBS\n"
               "geometry, integrated on the GPU, with error bounds.",
    "solidmoments");
  Declare(app, arguments);
  DeclareIntegrals(app, arguments);
  DeclareWaterlines(app, arguments);
  DeclareStability(app, arguments);
  DeclareSchemes(app, arguments);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? AllOk : UsageOrOutput;
  }
  ParseDirection(arguments.Up, arguments.Job.Up);
  arguments.Job.Scheme = LowerCase(arguments.Job.Scheme);
  const std::string problem = FindProblem(app, arguments);
  if (!problem.empty())
  {
    return Complain(problem);
  }
  arguments.Job.Unit = LowerCase(arguments.Job.Unit);
  if (arguments.Job.Unit == "in")
  {
    arguments.Job.Unit = "inch";
  }
  return std::nullopt;
}

int Complain(const std::string& what)
{
  std::cerr << "solidmoments: " << what << "\n";
  return UsageOrOutput;
}

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

std::string Stem(const std::string& path)
{
  const size_t slash = path.find_last_of('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const size_t dot = name.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}
}
