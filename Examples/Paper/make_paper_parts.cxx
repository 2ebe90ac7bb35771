// Models the parts of Table 1 and writes them as STEP, with parts.json: what is known of each without integrating it.
//   make_paper_parts FOLDER [NAME...]
// Exit status 0 when every part is valid and written, 1 else; parts that fail are named, the others written.
#include "smPaperParts.h"
#include "smPartFile.h"

#include <Standard_Failure.hxx>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace
{
using Json = nlohmann::ordered_json;

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

/// The entry of parts.json; throws what smPartFile.h and OpenCASCADE throw.
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
}

int main(int argc, char** argv)
{
  if (argc < 2 || argv[1][0] == '-')
  {
    std::cerr << "usage: make_paper_parts FOLDER [NAME...]\n";
    return 1;
  }
  const std::filesystem::path folder(argv[1]);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::vector<std::string> wanted(argv + 2, argv + argc);
  std::size_t found = 0;
  bool allMade = true;
  Json parts = Json::array();
  smpaper::QuietOpenCascade();
  for (const Recipe& recipe : Recipes)
  {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), recipe.Name) == wanted.end())
    {
      continue;
    }
    ++found;
    try
    {
      parts.push_back(MakePart(recipe, folder));
    }
    catch (const Standard_Failure& failure)
    {
      std::cerr << "make_paper_parts: " << recipe.Name << ": OpenCASCADE: " << failure.DynamicType()->Name()
                << " " << failure.GetMessageString() << "\n";
      allMade = false;
    }
    catch (const std::exception& failure)
    {
      std::cerr << "make_paper_parts: " << recipe.Name << ": " << failure.what() << "\n";
      allMade = false;
    }
  }
  if (found < wanted.size())
  {
    std::cerr << "make_paper_parts: some name is no part's\n";
    allMade = false;
  }
  std::ofstream file(folder / "parts.json");
  file << Json{ { "parts", parts } }.dump(1) << "\n";
  if (!file.flush())
  {
    std::cerr << "make_paper_parts: " << (folder / "parts.json").string() << " cannot be written\n";
    return 1;
  }
  return allMade ? 0 : 1;
}
