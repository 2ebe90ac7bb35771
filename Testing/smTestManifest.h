/**
 * @file smTestManifest.h
 * @brief The expected values that smMakeSolids wrote beside the exact solids
 */
#ifndef smTestManifest_h
#define smTestManifest_h

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace smtest
{
struct Expected
{
  std::string Solid;
  std::string Variant;
  std::string Path;
  double Volume = 0;
  /// NaN: no closed form.
  double Area = 0;
  std::array<double, 3> Center{};
  std::array<double, 9> Inertia{};
  /// Diagonal of the bounding box.
  double Size = 0;
  /// False: the file has no trim curves, the reader gets projections of the edges from OCCT, good to 1e-4 mm.
  bool HasPcurves = true;
  /// How far the digits in the file can move a value.
  double VolumeAccuracy = 0;
  double AreaAccuracy = 0;
  double CenterAccuracy = 0;
  double InertiaAccuracy = 0;
  int Solids = 1;

  double GetDistance() const { return std::hypot(this->Center[0], this->Center[1], this->Center[2]); }
  double GetInertiaTrace() const { return this->Inertia[0] + this->Inertia[4] + this->Inertia[8]; }
};

class Manifest
{
public:
  explicit Manifest(const std::string& folder)
    : Folder(folder)
  {
    std::ifstream file(folder + "/manifest.json");
    if (!file)
    {
      throw std::runtime_error("there is no manifest.json in " + folder);
    }
    file >> this->Content;
  }

  /// Every variant of a solid; one variant when it is named.
  std::vector<Expected> GetSolid(const std::string& solid, const std::string& variant = "") const
  {
    std::vector<Expected> result;
    for (const nlohmann::json& entry : this->Content["solids"])
    {
      if ((solid.empty() || entry["solid"] == solid) && (variant.empty() || entry["variant"] == variant))
      {
        result.push_back(this->Convert(entry));
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

  /// One variant of every solid.
  std::vector<Expected> GetVariant(const std::string& variant) const { return this->GetSolid("", variant); }

  /// One of the files for special tests: an assembly, an open shell, text that is not STEP …
  Expected GetSpecial(const std::string& name) const
  {
    const nlohmann::json& entry = this->Content["special"].at(name);
    Expected expected = entry["solids"] > 0 ? this->Convert(entry) : Expected{};
    expected.Solids = entry["solids"];
    expected.Path = this->Folder + "/" + entry["file"].get<std::string>();
    return expected;
  }

private:
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

  std::string Folder;
  nlohmann::json Content;
};
}

#endif
