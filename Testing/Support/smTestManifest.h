/**
 * @file smTestManifest.h
 * @brief The expected values that smMakeSolids wrote next to the exact solids
 */
#ifndef smTestManifest_h
#define smTestManifest_h

#include <array>
#include <cmath>
#include <memory>
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
  /// NaN where there is no closed form.
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
  /// Throws std::runtime_error when the folder has no manifest.json.
  explicit Manifest(const std::string& folder);
  ~Manifest();

  /// Every variant of a solid; one variant when it is named. Throws std::runtime_error when there is none.
  std::vector<Expected> GetSolid(const std::string& solid, const std::string& variant = "") const;

  /// One variant of every solid.
  std::vector<Expected> GetVariant(const std::string& variant) const { return this->GetSolid("", variant); }

  /// One of the files for special tests: an assembly, an open shell, text that is not STEP …
  Expected GetSpecial(const std::string& name) const;

private:
  struct Content;
  std::unique_ptr<Content> Entries;
};
}

#endif
