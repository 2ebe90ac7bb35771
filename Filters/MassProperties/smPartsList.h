/**
 * @file smPartsList.h
 * @brief The parts list (bill of materials) of an input: products with their counts, and the sums of their
 * solids
 */
#ifndef smPartsList_h
#define smPartsList_h

#include "smFiltersMassPropertiesModule.h"
#include "smStatus.h"

#include <limits>
#include <string>
#include <vector>

namespace sm
{
/// The sum of a quantity over the solids that have it, and its bound. If one of the values has no bound
/// (NaN), neither has the sum.
struct SMFILTERSMASSPROPERTIES_EXPORT PartsSum
{
  double Value = 0.0;
  double Bound = 0.0;
  int Terms = 0;

  /// NaN adds nothing.
  void Add(double value, double bound);
  void Add(const PartsSum& other);
  double GetValue() const { return this->Terms > 0 ? this->Value : std::numeric_limits<double>::quiet_NaN(); }
  double GetBound() const { return this->Terms > 0 ? this->Bound : std::numeric_limits<double>::quiet_NaN(); }
};

/// Units: L^3, L^2 and kg. The mass has fewer terms than the volume where some solids have no density.
struct SMFILTERSMASSPROPERTIES_EXPORT PartsSums
{
  PartsSum Volume, Area, Mass;

  void Add(const PartsSums& other);
  /// Every solid with a volume has a mass.
  bool HasWholeMass() const { return this->Mass.Terms == this->Volume.Terms; }
};

/// All equal products below one product. Products are equal if they have the same name and consist of the
/// same models and equal products.
struct PartsListEntry
{
  std::string Name;
  /// Layer of the first product; empty where the file states none.
  std::string Layer;
  bool IsAssembly = false;
  /// Numbers of these products in the product above, and in the whole input.
  int Count = 1;
  int CountInAll = 1;
  /// Number of solids of one product.
  int Solids = 0;
  /// Material, and density in kg/m^3; empty and NaN where the solids differ or have none.
  std::string Material;
  double Density = std::numeric_limits<double>::quiet_NaN();
  /// The worst status of all solids of these products.
  sm::Status Status = sm::Status::None;
  /// Sums over the first product, and over all. Solids whose volume was not computed, and surfaces, add
  /// nothing.
  PartsSums Each, InAll;
  /// Sorted by name.
  std::vector<PartsListEntry> Children;
};
}

#endif
