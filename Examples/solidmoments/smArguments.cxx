#include "smArguments.h"

#include "smArgumentOptions.h"
#include "smFormat.h"
#include "smInputFile.h"
#include "smMaterialFile.h"
#include "smMeshOrigin.h"
#include "smOpenGLProbe.h"
#include "smOptionValues.h"
#include "smOutputFiles.h"
#include "smReport.h"
#include "smVersion.h"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <optional>

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
  solidmoments --compare old.step new.step

Exit status:
  0  all files computed with status ok
  1  wrong usage, or an output (table, JSON, CSV, PNG, mesh, robot) could not be written
  2  some file is unreadable
  3  some result is flagged: open, tolerance-not-met, suspect, not-computed, empty
  4  with --compare: the products differ
The first of 1, 2, 3, 4 that applies. 130 after Ctrl-C, 143 after SIGTERM, 129 when the terminal
has gone (SIGHUP): then the outputs hold the files finished before.)";

/// Returns an error message if a file name is empty; empty otherwise.
std::string FindEmptyName(const CLI::App& app, const sm::Arguments& arguments)
{
  if (std::count(arguments.Files.begin(), arguments.Files.end(), "") > 0)
  {
    return "a file name is empty; name a STEP or BREP file";
  }
  if (arguments.Files.empty())
  {
    return "FILE is required: name a STEP or BREP file";
  }
  for (const char* option : { "--json", "--csv", "--mesh", "--png", "--trim-textures", "--materials",
         "--bom-csv", "--joints", "--write-validation" })
  {
    if (app.count(option) > 0 && app[option]->as<std::string>().empty())
    {
      return std::string("the file name of ") + option + " is empty";
    }
  }
  return {};
}

/// Returns an error message about an analysis that this build is without; empty otherwise.
std::string FindMissingModule(const sm::Arguments& arguments)
{
  for (const std::shared_ptr<sm::Analysis>& analysis : arguments.Job.Analyses)
  {
    if (analysis->IsWanted() && analysis->GetMissingModule())
    {
      return std::string(analysis->GetOption()) + " needs a build with " + analysis->GetMissingModule() +
        "=ON: this one is without";
    }
  }
  return {};
}

/// Returns an error message if two products cannot be compared with these options; empty otherwise.
std::string FindWrongComparison(const CLI::App& app, const sm::Arguments& arguments)
{
  if (!arguments.Compare)
  {
    return app.count("--compare-limit") > 0 ? "--compare-limit is for --compare: add it" : "";
  }
  if (arguments.Files.size() != 2)
  {
    return "--compare takes two files, the old and the new one; there are " +
      std::to_string(arguments.Files.size());
  }
  if (sm::LowerCase(arguments.Job.Unit) == "file")
  {
    return "--compare needs results in one unit: name it instead of --unit file";
  }
  if (!arguments.Picture.empty() && std::count(arguments.Files.begin(), arguments.Files.end(), "-") > 0)
  {
    return "--compare with --png reads both files twice: neither can be the standard input";
  }
  for (const char* option : { "--scheme", "--print" })
  {
    if (app.count(option) > 0)
    {
      return std::string("--compare excludes ") + option;
    }
  }
  return {};
}

/// Returns an error message for an invalid column or expression, or for a required result that is not
/// computed; empty otherwise.
std::string FindWrongRequest(const CLI::App& app, const sm::Arguments& arguments)
{
  const std::vector<std::string> known = sm::ListColumns(sm::FileResult(arguments.Job));
  for (const std::vector<std::string>& columns : { arguments.Print, arguments.Fields })
  {
    for (const std::string& column : columns)
    {
      if (std::find(known.begin(), known.end(), column) == known.end())
      {
        return "there is no column \"" + column +
          "\"; the user guide has them, for example volume or center_x";
      }
    }
  }
  const auto wants = [&arguments](const char* word)
  { return std::find(arguments.Require.begin(), arguments.Require.end(), word) != arguments.Require.end(); };
  const sm::AnalysisList& analyses = arguments.Job.Analyses;
  const bool hasStability = std::any_of(analyses.begin(), analyses.end(),
    [](const auto& analysis)
    { return analysis->GetKey() == std::string("stability") && analysis->IsWanted(); });
  if (wants("stable") && !hasStability)
  {
    return "--require stable is for --stability: add the direction of gravity, for example -z";
  }
  if (app.count("--depth") > 0 && !arguments.Job.PartsList)
  {
    return "--depth is for the parts list: add --bom";
  }
  if (app.count("--validation-limit") > 0 && !arguments.Job.Validate)
  {
    return "--validation-limit is for --validate";
  }
  if (wants("validation") && !arguments.Job.Validate)
  {
    return "--require validation is for --validate: add it";
  }
  if (!arguments.Job.ValidationTarget.empty() && arguments.Files.size() > 1)
  {
    return "--write-validation writes one file: name one file to read";
  }
  if (arguments.Job.ValidationTarget == "-")
  {
    return "--write-validation cannot go to standard output";
  }
  for (const char* option : { "--joints", "--fuse", "--collision" })
  {
    if (app.count(option) > 0 && arguments.Robot.empty())
    {
      return std::string(option) + " is for a robot: add --robot";
    }
  }
  if (arguments.PartsCsv == "-")
  {
    return "the parts list needs a file: --bom-csv cannot go to standard output";
  }
  if (app.count("--fields") > 0 && arguments.Csv.empty())
  {
    return "--fields is for --csv: add a file name";
  }
  return !arguments.Print.empty() && (arguments.Json == "-" || arguments.Csv == "-")
    ? "only one of --print, --json and --csv can go to standard output"
    : "";
}

/// Returns an error message if outputs exclude each other or have a wrong name; empty otherwise.
std::string FindWrongOutput(const sm::Arguments& arguments)
{
  if (arguments.Json == "-" && arguments.Csv == "-")
  {
    return "only one of --json and --csv can go to standard output";
  }
  if (!arguments.Mesh.empty() && !sm::IsMeshName(arguments.Mesh))
  {
    return "--mesh writes STL, OBJ, PLY, VTP and GLB files: the name must end in .stl, .obj, .ply, .vtp or "
           ".glb, and " +
      arguments.Mesh + " does not";
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

void PrintMaterials()
{
  for (const sm::Material& material : sm::GetCommonMaterials())
  {
    std::cout << std::left << std::setw(18) << material.Name << sm::FormatDigits(material.Density, 6)
              << " kg/m^3\n";
  }
}

/// Parses densities and frame into the job. Returns an error message if the materials cannot be read; empty
/// otherwise.
std::string TakeMass(sm::Arguments& arguments)
{
  sm::JobOptions& job = arguments.Job;
  if (!arguments.About.empty())
  {
    sm::ParseFrame(arguments.About, job.About);
  }
  if (!arguments.Materials.empty())
  {
    const std::string problem = sm::ReadMaterialFile(arguments.Materials, job.Materials);
    if (!problem.empty())
    {
      return problem;
    }
  }
  job.Shapes = arguments.Compare;
  job.PartsList = job.PartsList || !arguments.PartsCsv.empty();
  job.DensityTolerance = sm::ParseShare(arguments.DensityTolerance);
  const sm::Material material = sm::ParseDensity(arguments.Density);
  if (material.Name.empty())
  {
    job.Density = material.Density;
  }
  else
  {
    job.Materials.push_back({ "*", material });
  }
  return {};
}

/// Takes the format and the name of a robot, and reads its joints. Returns an error message; empty if all is
/// well.
std::string TakeRobot(sm::Arguments& arguments)
{
  if (arguments.Robot.empty())
  {
    return {};
  }
  const std::optional<sm::RobotFormat> format = sm::ParseRobotFormat(sm::LowerCase(arguments.Robot[0]));
  if (!format)
  {
    return "--robot writes urdf, sdf or mjcf, not " + arguments.Robot[0] + "; write --robot urdf FILE";
  }
  arguments.RobotName = arguments.Robot[1];
  arguments.Job.RobotFormat = *format;
  const size_t slash = arguments.RobotName.find_last_of('/');
  if (arguments.RobotName.find('.', slash == std::string::npos ? 0 : slash) == std::string::npos)
  {
    return "--robot " + arguments.Robot[0] + " " + arguments.RobotName +
      ": the name of the file needs an ending, as ." +
      (*format == sm::RobotFormat::Mjcf ? "xml" : arguments.Robot[0]);
  }
  if (arguments.Joints.empty())
  {
    return {};
  }
  const std::optional<std::string> text = sm::ReadTextFile(arguments.Joints);
  if (!text)
  {
    return "the joints " + arguments.Joints + " cannot be read";
  }
  const std::string problem = sm::ParseRobotJoints(*text, arguments.Job.Joints);
  return problem.empty() ? problem : arguments.Joints + ", " + problem;
}

/// Returns an error message if arguments contradict each other; empty otherwise.
std::string FindProblem(const CLI::App& app, const sm::Arguments& arguments)
{
  for (const std::string& problem : { FindEmptyName(app, arguments), FindMissingModule(arguments),
         arguments.Job.Scheme.FindProblem(app), FindWrongComparison(app, arguments) })
  {
    if (!problem.empty())
    {
      return problem;
    }
  }
  for (const std::shared_ptr<sm::Analysis>& analysis : arguments.Job.Analyses)
  {
    const std::string problem = analysis->FindProblem(app);
    if (!problem.empty())
    {
      return problem;
    }
  }
  const std::string wrongRequest = FindWrongRequest(app, arguments);
  if (!wrongRequest.empty())
  {
    return wrongRequest;
  }
  const std::string problem = FindWrongOutput(arguments);
  return problem.empty() ? sm::MakeTextureFolder(arguments) : problem;
}
}

namespace sm
{
std::optional<int> ParseArguments(int argc, char** argv, Arguments& arguments)
{
  CLI::App app(
    "Volume, area, centre of mass and inertia of the parts in STEP and BREP files, from their exact NURBS\n"
    "geometry, integrated on the GPU, with error bounds.",
    "solidmoments");
  app.set_version_flag("--version,-V", std::string("solidmoments ") + Version);
  app.footer(Footer);
  DeclareOptions(app, arguments);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? AllOk : UsageOrOutput;
  }
  if (arguments.ListMaterials)
  {
    PrintMaterials();
    return AllOk;
  }
  if (arguments.ProbeOpenGL)
  {
    return PrintOpenGLProbe();
  }
  arguments.Files = ExpandFolders(arguments.Files);
  std::string problem = app.count("--urdf") > 0
    ? "--urdf is gone: write --robot urdf FILE, and --fuse '*' for one link"
    : TakeMass(arguments);
  problem = problem.empty() ? TakeRobot(arguments) : problem;
  problem = problem.empty() ? FindProblem(app, arguments) : problem;
  if (!problem.empty())
  {
    return Complain(problem);
  }
  for (std::string* unit : { &arguments.Job.Unit, &arguments.Job.InputUnit })
  {
    *unit = LowerCase(*unit);
    *unit = *unit == "in" ? "inch" : *unit;
  }
  return std::nullopt;
}

int Complain(const std::string& message)
{
  std::cerr << "solidmoments: " << message << "\n";
  return UsageOrOutput;
}
}
