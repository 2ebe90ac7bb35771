#include "smArguments.h"

#include "smOutputFiles.h"
#include "smUserIntegrals.h"
#include "smVersion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <iterator>
#include <set>

namespace
{
const char* Footer =
  R"(Results are in millimetres unless --unit says otherwise; inertia is about the centre of mass, for unit
density. The number after +/- is the bound of the numerical error; defects of the model (gaps between faces,
open edges) are reported separately. A value that does not exist is null in JSON, empty in CSV. In JSON a file
name is UTF-8; when it has other bytes, they are U+FFFD in "file", and "file_bytes" has the name percent-encoded
(otherwise null). Each file is read in a process of its own: when one crashes, the others are still computed.
An output replaces the file of its name when it is whole; JSON and CSV are written anew after every file.

Examples:
  solidmoments bracket.step
  solidmoments bracket.step --png bracket.png
  solidmoments --unit inch --density 2700 bracket.step
  solidmoments *.step --quiet --json results.json --csv results.csv

Exit status:
  0  all files computed with status ok
  1  wrong usage, or an output (table, JSON, CSV, PNG) could not be written
  2  some file is unreadable
  3  some result is flagged: open, tolerance-not-met, suspect, not-computed, empty
The first of 1, 2, 3 that applies. 130 after Ctrl-C, 143 when told to end (SIGTERM), 129 when the terminal has
gone (SIGHUP): then the outputs hold the files finished before.)";

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

std::string CheckRepair(const std::string& word)
{
  return word == "always" || word == "needed" ? std::string()
                                              : "--repair " + word + " is not known; use always or needed";
}

std::string CheckUnit(const std::string& name)
{
  const std::set<std::string> known = { "mm", "cm", "m", "um", "inch", "in", "ft", "file" };
  return known.count(sm::LowerCase(name))
    ? ""
    : "there is no unit " + name + "; use mm, cm, m, um, inch, ft or file";
}

std::string CheckTolerance(const std::string& text)
{
  const double value = sm::ParseNumber(text);
  return value > 0.0 && value <= 1.0 ? "" : "the tolerance must be a number above 0, at most 1";
}

std::string CheckGapLimit(const std::string& text)
{
  const double value = sm::ParseNumber(text);
  return value >= 0.0 && value <= 1.0 ? "" : "the limit of gaps must be a number from 0 to 1";
}

std::string CheckQuantityTolerance(const std::string& text)
{
  std::string quantity;
  double relative = 0.0;
  double absolute = 0.0;
  return sm::ParseQuantityTolerance(text, quantity, relative, absolute)
    ? ""
    : text + " is not the tolerance of a quantity; write for example volume=1e-6 or center=0,1e-3";
}

/// The text must be a whole number from 1 to `most`.
std::string CheckFactor(const std::string& what, int most, const std::string& text)
{
  const double value = sm::ParseNumber(text);
  return value >= 1.0 && value <= most && value == std::floor(value)
    ? ""
    : "the number of " + what + " must be a whole number from 1 to " + std::to_string(most);
}

std::string CheckChord(const std::string& text)
{
  const double value = sm::ParseNumber(text);
  return value > 0.0 && value < 1.0 ? "" : "the chord tolerance must be a number above 0 and below 1";
}

std::string CheckEvaluations(const std::string& text)
{
  const double value = sm::ParseNumber(text);
  return value >= 1.0 && value <= 1e18 ? "" : "the number of evaluations must be at least 1, at most 1e18";
}

std::string CheckSeconds(const std::string& text)
{
  const double value = sm::ParseNumber(text);
  return value >= 0.0 && value < 1e300 ? "" : "the seconds must be a number that is not negative";
}

std::string CheckDegree(const std::string& text)
{
  const double value = sm::ParseNumber(text);
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
    : text + " is not an integral; write NAME=EXPRESSION, for example 'area=dA'";
}

std::string CheckHeight(const std::string& text)
{
  return std::isfinite(sm::ParseNumber(text)) ? "" : "the height of a waterline must be a finite number";
}

std::string CheckDirection(const std::string& text)
{
  std::array<double, 3> direction;
  return sm::ParseDirection(text, direction)
    ? ""
    : text + " is not a direction; write x, y, z, -x, -y, -z, or three numbers such as 0,0.1,-1";
}

std::string CheckDensity(const std::string& text)
{
  const double value = sm::ParseNumber(text);
  return value > 0.0 && value < 1e300 ? "" : "the density must be a positive number, in kg/m^3";
}

void DeclareFiles(CLI::App& app, sm::Arguments& arguments)
{
  app.add_option("FILE", arguments.Files, "STEP files")->required()->type_name("");
  sm::AddFileOption(
    app, "--json", arguments.Json, "Write all results as JSON; - for standard output, and then no table");
  sm::AddFileOption(app, "--csv", arguments.Csv, "Write a row per file and per solid; - as for --json");
  sm::AddFileOption(app, "--png", arguments.Picture,
    "Draw the part, translucent, with its centre of mass marked. With several\n"
    "files, each picture has the STEP file's name added: out-bracket.png");
  app.add_flag("--quiet,-q", arguments.Quiet, "Print no table and no progress, only errors");
}

void DeclareComputation(CLI::App& app, sm::JobOptions& job)
{
  sm::AddNumberOption(app, "--tolerance", job.Tolerance,
    "Tolerance of every result, relative to the size of the solid (default 1e-9)")
    ->check(CheckTolerance);
  app
    .add_option("--tolerance-of", job.QuantityTolerances,
      "Tolerance of one quantity, volume, area, center or inertia: relative (0:\n"
      "that of --tolerance), or relative and absolute, of which the larger\n"
      "counts; may be given several times: --tolerance-of center=0,1e-6")
    ->type_name("NAME=REL[,ABS]")
    ->check(CheckQuantityTolerance)
    ->take_all()
    ->allow_extra_args(false);
  sm::AddNumberOption(app, "--max-evaluations", job.MaximumEvaluations,
    "Largest number of surface evaluations of a file (default 2e9); where that\n"
    "is too few, the tolerance is loosened and the bounds say by how much")
    ->check(CheckEvaluations);
  sm::AddNumberOption(app, "--max-seconds", job.MaximumSeconds,
    "Largest time for a file, from reading to drawing (default: no limit);\n"
    "faces not reached count as 0, and the bounds include their largest\n"
    "possible values. What does not end by itself (a reader, a shader compiler)\n"
    "is ended a quarter of the time later, 2 s at least")
    ->check(CheckSeconds);
  sm::AddNumberOption(app, "--gap-limit", job.GapLimit,
    "Gaps between faces above this fraction of the diagonal, or of the volume\n"
    "that closing them adds, make a result suspect (default 1e-3; 1: none does)")
    ->check(CheckGapLimit);
  app
    .add_option("--unit", job.Unit,
      "Length unit of all results: mm (default), cm, m, um, inch, ft; or file:\n"
      "the one that the file is written in")
    ->type_name("UNIT")
    ->check(CheckUnit);
  app
    .add_option("--repair", job.Repair,
      "Which solids and shells OpenCASCADE repairs: always (default), or needed:\n"
      "only those that are not sound as the file has them, which a message tells;\n"
      "the others are read faster, with exact trim curves")
    ->type_name("WHEN")
    ->check(CheckRepair);
  sm::AddNumberOption(
    app, "--density", job.Density, "Density in kg/m^3, for the mass in kg (default: that of the file)")
    ->check(CheckDensity);
  app
    .add_option("--backend", job.Backend,
      "opengl: compute shaders, on the X display or through EGL where there is\n"
      "none; x or egl: only that one; cpu: no OpenGL; auto (default): opengl\n"
      "where there is OpenGL 4.3 with doubles, else cpu")
    ->type_name("NAME")
    ->check(CheckBackend);
}

/// Integrals beside the mass properties.
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
    ->allow_extra_args(false);
}

void DeclareWaterlines(CLI::App& app, sm::Arguments& arguments)
{
  app
    .add_option_function<std::vector<std::string>>(
      "--waterline",
      [&heights = arguments.Job.Waterlines](const std::vector<std::string>& texts)
      { std::transform(texts.begin(), texts.end(), std::back_inserter(heights), sm::ParseNumber); },
      "Volume below a waterline, and its centre, the centre of buoyancy: the\n"
      "plane at HEIGHT along --up from the origin, in the unit of the results;\n"
      "may be given several times")
    ->type_name("HEIGHT")
    ->check(CheckHeight)
    ->take_all()
    ->allow_extra_args(false);
  app.add_option("--up", arguments.Up, "Upward normal of the waterlines, of any length (default 0,0,1)")
    ->type_name("X,Y,Z")
    ->check(CheckDirection);
}

void DeclareStability(CLI::App& app, sm::Arguments& arguments)
{
  app
    .add_option("--stability", arguments.Job.Stability,
      "Static stability of the part, resting on its lowest points, under gravity\n"
      "along DIR, x, y, z, +x .. -z or three numbers: the stability margin\n"
      "(signed distance from the projected centre of mass to the nearest edge\n"
      "of the support polygon), tip angle and rise of the centre of mass before\n"
      "tipping, with bounds; for all solids as one body, and for each alone:\n"
      "--stability -z")
    ->type_name("DIR")
    ->check(CheckDirection)
    ->expected(1);
}

/// The schemes of the paper and their own options.
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
    .add_option(
      "--subpatches", job.SubPatches, "Paper's schemes: K x K sub-patches per knot interval (default 2)")
    ->type_name("K")
    ->check([](const std::string& text) { return CheckFactor("sub-patches", 1024, text); });
  app
    .add_option("--trim-texture", job.TrimTexture, "Paper's schemes: M x M texels per sub-patch (default 4)")
    ->type_name("M")
    ->check([](const std::string& text) { return CheckFactor("texels", 16, text); });
  sm::AddNumberOption(app, "--chord", job.ChordTolerance,
    "Paper's schemes: largest distance of the chords of planar faces' trim\n"
    "curves from these, relative to the size of the solid (default 1e-8)")
    ->check(CheckChord);
  app
    .add_option("--deviation", job.Deviation,
      "Paper's schemes: how the error estimate finds the deviation of a\n"
      "sub-patch: bounded (default), or sampled")
    ->type_name("NAME")
    ->check(CheckDeviation);
  sm::AddFileOption(app, "--trim-textures", arguments.TextureFolder,
    "Write the trim textures of the paper's schemes to FOLDER, a PNG per face")
    ->type_name("FOLDER");
}

/// An error message when a file name is empty; empty otherwise.
std::string FindEmptyName(const CLI::App& app, const sm::Arguments& arguments)
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
  return {};
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

/// An error message when an option does not belong to the scheme; empty otherwise.
std::string FindForeignOption(const CLI::App& app, const sm::Arguments& arguments)
{
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
      return std::string(option) + " is for --scheme adaptive: the paper's schemes have no tolerance";
    }
  }
  return {};
}

/// An error message when outputs exclude each other or have a wrong name; empty otherwise.
std::string FindWrongOutput(const sm::Arguments& arguments)
{
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
  return sm::CheckOutputs(arguments);
}

/// An error message when arguments that are well-formed one by one do not fit together; empty otherwise.
std::string FindProblem(const CLI::App& app, const sm::Arguments& arguments)
{
  for (const std::string& problem :
    { FindEmptyName(app, arguments), FindMissingModule(app, arguments), FindForeignOption(app, arguments) })
  {
    if (!problem.empty())
    {
      return problem;
    }
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
  const std::string problem = FindWrongOutput(arguments);
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
  app.set_version_flag("--version", std::string("solidmoments ") + Version);
  app.footer(Footer);
  DeclareFiles(app, arguments);
  DeclareComputation(app, arguments.Job);
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

int Complain(const std::string& message)
{
  std::cerr << "solidmoments: " << message << "\n";
  return UsageOrOutput;
}
}
