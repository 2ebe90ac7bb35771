#include "smArgumentOptions.h"

#include "smArgumentChecks.h"
#include "smTrimText.h"

namespace
{
/// Adds an option that takes words, separated by commas.
CLI::Option* AddListOption(CLI::App& app, const std::string& option, std::vector<std::string>& words,
  const std::string& type, const std::string& help)
{
  return app
    .add_option_function<std::string>(
      option, [&words](const std::string& text) { words = sm::SplitFields(text); }, help)
    ->type_name(type);
}

void DeclareFiles(CLI::App& app, sm::Arguments& arguments)
{
  app.option_defaults()->group("Files and outputs");
  app
    .add_option("FILE", arguments.Files,
      "STEP files, and OpenCASCADE's BREP files, also compressed (.step.gz, .stpz, a\n"
      "ZIP archive with one); - for standard input; a folder for such files in it")
    ->type_name("");
  sm::AddFileOption(
    app, "--json", arguments.Json, "Write all results as JSON; - for standard output, and then no table");
  sm::AddFileOption(app, "--csv", arguments.Csv, "Write a row per file and per solid; - as for --json");
  sm::AddFileOption(app, "--mesh", arguments.Mesh,
    "Write the triangles of the solids, closed where these are: .stl (binary),\n"
    ".obj, .ply or .vtp, in --unit, or .glb, with colours and in metres. With\n"
    "several files as for --png");
  sm::AddNumberOption(app, "--deflection", arguments.Job.Deflection,
    "Largest distance of the triangles of --mesh and --png from the surface, in\n"
    "--unit (default: 0.001 of the diagonal of each solid)")
    ->check(CLI::PositiveNumber);
  sm::AddFileOption(app, "--png", arguments.Picture,
    "Draw the part, translucent, with its centre of mass marked. With several\n"
    "files, each picture has the file's name added: out-bracket.png; with\n"
    "--compare one picture: added solids green, changed amber, moved blue,\n"
    "mirrored purple, removed red");
  AddListOption(app, "--print", arguments.Print, "COLUMN,...",
    "Print only these columns of the CSV, one line per file with the values of\n"
    "all its solids together, for scripts: --print volume; nan where there is none");
  AddListOption(
    app, "--fields", arguments.Fields, "COLUMN,...", "Write these columns of the CSV only, in this order");
  AddListOption(app, "--fail-on", arguments.FailOn, "STATUS,...",
    "Statuses of a file that make the exit status 3: open, tolerance-not-met,\n"
    "suspect, not-computed, empty (default: all of these), or none")
    ->check(sm::CheckFailOn);
  AddListOption(app, "--require", arguments.Require, "WHAT,...",
    "Make the exit status 3 unless every file is this: stable (with --stability),\n"
    "mass (every solid has a density), validation (with --validate: nothing fails)")
    ->check(sm::CheckRequire);
  app
    .add_option("--jobs,-j", arguments.JobsAtOnce,
      "Files to work on at a time (default 1), which share the processors; 0: one\n"
      "for each processor. The outputs have the order of the files all the same")
    ->type_name("NUMBER")
    ->check(CLI::Range(0, 1024));
  app.add_flag("--quiet,-q", arguments.Quiet,
    "Print no table and no progress, only errors and, on the standard error, what\nmakes the exit status 2 "
    "or 3");
}

void DeclareComputation(CLI::App& app, sm::JobOptions& job)
{
  app.option_defaults()->group("Computation");
  sm::AddNumberOption(app, "--tolerance", job.Tolerance,
    "Tolerance of every result, relative to the size of the solid (default 1e-9)")
    ->check(sm::CheckTolerance);
  app
    .add_option("--tolerance-of", job.QuantityTolerances,
      "Tolerance of one quantity, volume, area, center or inertia: relative (0:\n"
      "that of --tolerance), or relative and absolute, of which the larger\n"
      "counts; may be given several times: --tolerance-of center=0,1e-6")
    ->type_name("NAME=REL[,ABS]")
    ->check(sm::CheckQuantityTolerance)
    ->take_all()
    ->allow_extra_args(false);
  sm::AddNumberOption(app, "--max-evaluations", job.MaximumEvaluations,
    "Budget of surface evaluations of a file (default 2e9); where that is too\n"
    "few, the tolerance is loosened and the bounds show by how much; every face\n"
    "gets its coarsest rule at least")
    ->check(sm::CheckEvaluations);
  sm::AddNumberOption(app, "--max-seconds", job.MaximumSeconds,
    "Largest time for a file, from reading to drawing (default: no limit);\n"
    "faces not reached count as 0, and the bounds include their largest\n"
    "possible values. What does not end by itself (a reader, a shader compiler)\n"
    "is ended a quarter of the time later, 2 s at least")
    ->check(sm::CheckSeconds);
  sm::AddNumberOption(app, "--gap-limit", job.GapLimit,
    "Gaps between faces above this fraction of the diagonal, or of the volume\n"
    "that closing them adds, make a result suspect (default 1e-3; 1: none does)")
    ->check(sm::CheckGapLimit);
  app
    .add_option("--unit", job.Unit,
      "Length unit of all results: mm (default), cm, m, um, inch, ft; or file:\n"
      "the one that the file is written in")
    ->type_name("UNIT")
    ->check(sm::CheckUnit);
  app
    .add_option("--input-unit", job.InputUnit,
      "Length unit of BREP files, which state none: mm (default), cm, m, um, inch\n"
      "or ft")
    ->type_name("UNIT")
    ->check(sm::CheckInputUnit);
  app
    .add_option("--search", job.SearchFolders,
      "Folder in which files are looked for that a STEP assembly names as its parts,\n"
      "besides that of the file that names them; may be given several times")
    ->type_name("DIR")
    ->check(CLI::ExistingDirectory)
    ->take_all()
    ->allow_extra_args(false);
  app
    .add_option("--repair", job.Repair,
      "Which solids and shells OpenCASCADE repairs: needed (default): those that are\n"
      "not sound as the file has them, as a message reports; the others are read\n"
      "faster, with trim curves that follow the edges; always: all; or never: none,\n"
      "and those that are not sound have their sound faces only and are suspect")
    ->type_name("WHEN")
    ->check(sm::CheckRepair);
  app
    .add_option("--hidden", job.Hidden,
      "Bodies that a STEP file hides (INVISIBILITY): count (default), with a message;\n"
      "skip leaves them out, only all others; messages have their number and names")
    ->type_name("WHAT")
    ->check(sm::CheckHidden);
  app
    .add_option("--backend", job.Backend,
      "opengl: compute shaders, on the X display or through EGL where there is\n"
      "none; x or egl: only that one; cpu: no OpenGL; auto (default): opengl\n"
      "for expressions, and on a GPU with OpenGL 4.3 and doubles where it is\n"
      "estimated to take less time, with its start, than the CPU; else cpu")
    ->type_name("NAME")
    ->check(sm::CheckBackend);
}

/// Declares the options of densities.
void DeclareMass(CLI::App& app, sm::Arguments& arguments)
{
  app.option_defaults()->group("Materials and frame");
  app
    .add_option("--density", arguments.Density,
      "Density of all solids in kg/m^3, or a material of --list-materials, for the\n"
      "mass in kg (default: what the file states)")
    ->type_name("NUMBER|NAME")
    ->check(sm::CheckDensity);
  app
    .add_option("--density-tolerance", arguments.DensityTolerance,
      "Largest relative deviation of the densities, 1% or 0.01 (default 0), for what\n"
      "is in doubt of the mass: the density, the gaps of the model, the bound")
    ->type_name("NUMBER")
    ->check(sm::CheckShare);
  sm::AddFileOption(app, "--materials", arguments.Materials,
    "Materials by the names of solids, before --density and the file: CSV with\n"
    "lines NAME,MATERIAL,DENSITY[,TOLERANCE[,MASS]], or JSON; in NAME, * and ? stand for\n"
    "any letters; the line of the very name counts, else the first that fits. Without\n"
    "a density: that of --list-materials. MASS, 0.25 or 250 g, overrides volume times\n"
    "density; 250 g per product is that of all solids of each product of that NAME;\n"
    "the MATERIAL \"left out\" leaves these solids out, \"counted once\" all but one of equal\n"
    "products, \"counted once in place\" all but one of coincident solids. A header may give\n"
    "other columns:\n"
    "name,material,mass");
  app.add_flag(
    "--list-materials", arguments.ListMaterials, "Print the common materials with their densities, and end");
}

/// Declares the options of the product structure.
void DeclareProducts(CLI::App& app, sm::Arguments& arguments)
{
  app.option_defaults()->group("Products");
  sm::JobOptions& job = arguments.Job;
  app.add_flag("--bom", job.PartsList,
    "Print the parts list: products with their counts, materials and masses, each\n"
    "and in all; in JSON the key parts");
  sm::AddFileOption(app, "--bom-csv", arguments.PartsCsv, "Write the parts lists of all files as CSV");
  app.add_option("--depth", job.Depth, "Levels of the parts list (default: all); sums include what is below")
    ->type_name("LEVELS")
    ->check([](const std::string& text) { return sm::CheckFactor("levels", 1000, text); });
  app
    .add_option("--only", job.Only,
      "Compute only the products of this name and what is below them; * and ?\n"
      "stand for any letters; may be given several times")
    ->type_name("NAME")
    ->take_all()
    ->allow_extra_args(false);
}

/// Declares the options of robots.
void DeclareRobot(CLI::App& app, sm::Arguments& arguments)
{
  app.option_defaults()->group("Robots");
  app
    .add_option("--robot", arguments.Robot,
      "Write the parts as links of a robot, with masses, inertias and .obj files, in\n"
      "kg and m: urdf, sdf or mjcf, and the file. With several files as for --png")
    ->type_name("FORMAT FILE")
    ->expected(2)
    ->allow_extra_args(false);
  // Hidden: what older versions had, see ParseArguments().
  app.add_option("--urdf")->group("")->expected(0, 1)->allow_extra_args(false);
  sm::AddFileOption(app, "--joints", arguments.Joints,
    "Joints: CSV with lines PARENT,CHILD,TYPE[,axis X,Y,Z[,origin X,Y,Z]], the types\n"
    "fixed, revolute and prismatic, in --unit and the frame of the file; links\n"
    "without a line are fixed to the first");
  app
    .add_option("--fuse", arguments.Job.Fused,
      "Make one link of each product of this name with all below it; * and ? stand\n"
      "for any letters; may be given several times")
    ->type_name("NAME")
    ->take_all()
    ->allow_extra_args(false);
  app
    .add_option("--collision", arguments.Job.Collision,
      "What of a link collides: none (default), or hull: the convex hull of its mesh")
    ->type_name("WHAT")
    ->check(sm::CheckCollision);
}

/// Declares the options of the comparison of two versions of a product.
void DeclareComparison(CLI::App& app, sm::Arguments& arguments)
{
  app.option_defaults()->group("Comparison");
  app.add_flag("--compare", arguments.Compare,
    "Compare two files, the old and the new one: which solids are unchanged,\n"
    "moved, mirrored, changed, added or removed, by exact integrals of their faces and\n"
    "not by their names, and the differences of the results with bounds; in JSON the key\n"
    "comparison. The exit status is 4 if the products differ");
  sm::AddNumberOption(app, "--compare-limit", arguments.CompareLimit,
    "Largest difference that is beyond the bounds and counts as equal, relative to the\n"
    "face, of places to the product (default 1e-9); 1e-6 for files of two systems")
    ->check(sm::CheckValidationLimit);
}

/// Declares the options of validation properties in a file.
void DeclareValidation(CLI::App& app, sm::Arguments& arguments)
{
  app.option_defaults()->group("Validation properties");
  sm::JobOptions& job = arguments.Job;
  app.add_flag("--validate", job.Validate,
    "Compare volume, area and centroid that the file states for its products with\n"
    "the results: pass, fail or not comparable; in JSON the key validation");
  sm::AddNumberOption(app, "--validation-limit", job.ValidationLimit,
    "Largest difference that passes, relative to the stated value, for the centroid\n"
    "to the cube root of the volume, beyond the error bounds (default 1e-3)")
    ->check(sm::CheckValidationLimit);
  sm::AddFileOption(app, "--write-validation", job.ValidationTarget,
    "Write the STEP file again with volume, area, centroid and density of its\n"
    "products, where it does not state them; all other bytes stay as they are");
}

void DeclareFrame(CLI::App& app, sm::Arguments& arguments)
{
  app.option_defaults()->group("Materials and frame");
  app
    .add_option("--about", arguments.About,
      "Inertia and centre of mass in another frame, too: origin, a point X,Y,Z,\n"
      "or nine numbers: a point, the direction of the z axis, that of the x axis")
    ->type_name("FRAME")
    ->check(sm::CheckFrame);
}
}

namespace sm
{
void DeclareOptions(CLI::App& app, Arguments& arguments)
{
  DeclareFiles(app, arguments);
  DeclareComputation(app, arguments.Job);
  app.add_flag("--opengl-probe", arguments.ProbeOpenGL,
    "Print what the OpenGL driver makes of what the shaders rely on, and end");
  DeclareMass(app, arguments);
  DeclareProducts(app, arguments);
  DeclareRobot(app, arguments);
  DeclareComparison(app, arguments);
  DeclareValidation(app, arguments);
  for (const std::shared_ptr<Analysis>& analysis : arguments.Job.Analyses)
  {
    analysis->Declare(app);
  }
  DeclareFrame(app, arguments);
  arguments.Job.Scheme.Declare(app);
}
}
