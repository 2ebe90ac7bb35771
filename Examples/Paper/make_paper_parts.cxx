// Models the parts of Table 1 and writes them as STEP files, with parts.json: counts and exact values of each
// part.
#include "smJson.h"
#include "smOptions.h"
#include "smPaperParts.h"
#include "smPartFile.h"
#include "smSafeFile.h"

#include <Standard_Failure.hxx>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace
{
using sm::Json;

struct Recipe
{
  const char* Name;
  smpaper::PaperPart (*Make)();
};

const Recipe Recipes[] = { { "quarter_cylinder", smpaper::MakeQuarterCylinder },
  { "slanted_block", smpaper::MakeSlantedBlock }, { "trefoil_tube", smpaper::MakeTrefoilTube },
  { "free_form", smpaper::MakeFreeForm }, { "propeller", smpaper::MakePropeller },
  { "crank", smpaper::MakeCrank }, { "engine_block", smpaper::MakeEngineBlock },
  { "gear_train", smpaper::MakeGearTrain } };

Json Describe(const smpaper::PaperPart& part)
{
  const smpaper::PartCounts counts = smpaper::Count(part);
  Json entry = { { "id", part.Name }, { "solids", counts.Solids }, { "faces", counts.Faces },
    { "trimmed_faces", counts.TrimmedFaces }, { "distinct_faces", counts.DistinctFaces } };
  if (part.Exact)
  {
    entry["volume"] = part.Exact->Volume;
    entry["area"] = part.Exact->Area;
    entry["center_of_mass"] = part.Exact->CenterOfMass;
  }
  return entry;
}

/// Writes a part and returns its entry of parts.json. Throws the exceptions of smPartFile.h and OpenCASCADE.
Json MakePart(const Recipe& recipe, const std::filesystem::path& folder)
{
  const smpaper::PaperPart part = recipe.Make();
  smpaper::Check(part);
  smpaper::WriteStep(part, (folder / (part.Name + ".step")).string());
  const Json entry = Describe(part);
  std::cout << part.Name << ": solids " << entry["solids"] << ", faces " << entry["faces"] << ", trimmed "
            << entry["trimmed_faces"] << std::endl;
  return entry;
}

void Complain(const std::string& message)
{
  std::cerr << "make_paper_parts: " << message << "\n";
}

/// Makes a part and adds its entry to `parts`. Returns false, after a message, if it failed.
bool TryPart(const Recipe& recipe, const std::filesystem::path& folder, Json& parts)
{
  try
  {
    parts.push_back(MakePart(recipe, folder));
    return true;
  }
  catch (const Standard_Failure& failure)
  {
    Complain(std::string(recipe.Name) + ": OpenCASCADE: " + failure.DynamicType()->Name() + " " +
      failure.GetMessageString());
  }
  catch (const std::exception& failure)
  {
    Complain(std::string(recipe.Name) + ": " + failure.what());
  }
  return false;
}

/// Makes the wanted parts, or all when none is named. Returns the exit status.
int MakeParts(const std::filesystem::path& folder, const std::vector<std::string>& wanted)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  bool allMade = true;
  for (const std::string& name : wanted)
  {
    const auto hasName = [&name](const Recipe& recipe) { return name == recipe.Name; };
    if (std::none_of(std::begin(Recipes), std::end(Recipes), hasName))
    {
      Complain("no part has the name " + name);
      allMade = false;
    }
  }
  Json parts = Json::array();
  smpaper::QuietOpenCascade();
  for (const Recipe& recipe : Recipes)
  {
    if (wanted.empty() || std::find(wanted.begin(), wanted.end(), recipe.Name) != wanted.end())
    {
      allMade = TryPart(recipe, folder, parts) && allMade;
    }
  }
  const std::string list = (folder / "parts.json").string();
  const std::string problem = sm::SaveFile(list, Json{ { "parts", parts } }.dump(1) + "\n");
  if (!problem.empty())
  {
    Complain(list + " cannot be written: " + problem);
    return 1;
  }
  return allMade ? 0 : 1;
}
}

int main(int argc, char** argv)
{
  CLI::App app(
    "Model the parts of the paper's Table 1 and write them as STEP files, with parts.json: the counts and\n"
    "exact values of each part.",
    "make_paper_parts");
  app.footer("Exit status: 0 when every part is valid and written; 1 otherwise: parts that fail are named, "
             "the others\n"
             "are written.");
  std::string folder;
  std::vector<std::string> wanted;
  app.add_option("FOLDER", folder, "Folder to write to")->required()->type_name("");
  app.add_option("NAME", wanted, "Parts to make (default: all)")->type_name("");
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : 1;
  }
  return MakeParts(folder, wanted);
}
