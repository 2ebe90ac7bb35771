#include "smTestManifest.h"

#include "smJson.h"

#include <fstream>
#include <limits>
#include <stdexcept>

namespace smtest
{
struct Manifest::Content
{
  std::string Folder;
  nlohmann::json Json;

  Expected Convert(const nlohmann::json& entry) const
  {
    Expected expected;
    expected.Path = this->Folder + "/" + entry["file"].get<std::string>();
    expected.Volume = entry["volume"];
    expected.Area =
      entry["area"].is_null() ? std::numeric_limits<double>::quiet_NaN() : entry["area"].get<double>();
    expected.Size = entry["size"];
    for (int i = 0; i < 3; ++i)
    {
      expected.Center[i] = entry["center_of_mass"][i];
      for (int j = 0; j < 3; ++j)
      {
        expected.Inertia[3 * i + j] = entry["inertia"][i][j];
      }
    }
    const nlohmann::json& accuracy = entry["file_accuracy"];
    expected.VolumeAccuracy = accuracy["volume"];
    expected.AreaAccuracy = accuracy["area"];
    expected.CenterAccuracy = accuracy["center_of_mass"];
    expected.InertiaAccuracy = accuracy["inertia"];
    return expected;
  }
};

Manifest::Manifest(const std::string& folder)
  : Entries(new Content)
{
  this->Entries->Folder = folder;
  std::ifstream file(folder + "/manifest.json");
  if (!file)
  {
    throw std::runtime_error("there is no manifest.json in " + folder);
  }
  file >> this->Entries->Json;
}

Manifest::~Manifest() = default;

std::vector<Expected> Manifest::GetSolid(const std::string& solid, const std::string& variant) const
{
  std::vector<Expected> result;
  for (const nlohmann::json& entry : this->Entries->Json["solids"])
  {
    if ((solid.empty() || entry["solid"] == solid) && (variant.empty() || entry["variant"] == variant))
    {
      result.push_back(this->Entries->Convert(entry));
      result.back().Solid = entry["solid"];
      result.back().Variant = entry["variant"];
      result.back().HasPcurves = entry["pcurves"];
    }
  }
  if (result.empty())
  {
    throw std::runtime_error("the manifest has no solid " + solid + " " + variant);
  }
  return result;
}

Expected Manifest::GetSpecial(const std::string& name) const
{
  const nlohmann::json& entry = this->Entries->Json["special"].at(name);
  Expected expected = entry["solids"] > 0 ? this->Entries->Convert(entry) : Expected{};
  expected.Solids = entry["solids"];
  expected.Path = this->Entries->Folder + "/" + entry["file"].get<std::string>();
  return expected;
}
}
