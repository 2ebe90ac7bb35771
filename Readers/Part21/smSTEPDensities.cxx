#include "smSTEPDensities.h"

#include "smSTEPPropertyAttributes.h"
#include "smSTEPUnits.h"
#include "smWeights.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

namespace sm
{
namespace
{
using Index = Part21File::Index;

/// Densities are the same within this, in other units, of which the factors are rounded.
constexpr double Rounding = 1e-9;
constexpr STEPAttribute PlacedProduct = { "PRODUCT_DEFINITION_RELATIONSHIP", 4, 4, "related product" };

bool SaysDensity(std::string_view text)
{
  constexpr std::string_view word = "density";
  return std::search(text.begin(), text.end(), word.begin(), word.end(),
           [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; }) != text.end();
}

/// "#12 states 7850 kg/m^3".
std::string DescribeStatement(const STEPDensity& density)
{
  std::array<char, 40> digits;
  const auto end = std::to_chars(
    digits.data(), digits.data() + digits.size(), density.Density, std::chars_format::general, 10)
                     .ptr;
  return "#" + std::to_string(density.Id) + " states " + std::string(digits.data(), end) + " kg/m^3";
}

class DensityReader
{
public:
  explicit DensityReader(const STEPAttributes& entities)
    : File(entities.File)
    , Entities(entities)
  {
  }

  std::vector<STEPDensity> Read()
  {
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      const std::string& type = this->File.GetTypeNames()[this->File.GetType(i)];
      if (!this->File.IsComplex(i) && !this->File.IsDamaged(i) &&
        (type == "PROPERTY_DEFINITION_REPRESENTATION" || type == "MATERIAL_PROPERTY_REPRESENTATION"))
      {
        this->ReadProperty(i);
      }
    }
    for (const auto& [occurrence, stated] : this->OfOccurrences)
    {
      this->JoinOccurrence(occurrence, stated);
    }
    std::vector<STEPDensity> result;
    for (const auto& [product, found] : this->Found)
    {
      result.push_back(found.Density);
    }
    return result;
  }

private:
  struct Candidate
  {
    STEPDensity Density;
    /// Order of several statements: usable ones come before others, those by the recommended practice before
    /// user-defined ones.
    int Rank = -1;
  };

  void ReadProperty(Index link)
  {
    const Index property = this->Entities.Follow(this->Entities.Get(link, RepresentedProperty));
    const Index representation = this->Entities.Follow(this->Entities.Get(link, UsedRepresentation));
    if (property == STEPAttributes::None || representation == STEPAttributes::None)
    {
      return;
    }
    const Index described = this->FindDescribed(property);
    const bool isOccurrence = this->Entities.Has(described, STEPRole::Occurrence);
    const Index product =
      isOccurrence ? this->Entities.Follow(this->Entities.Get(described, PlacedProduct)) : described;
    if (!this->Entities.Has(product, STEPRole::ProductDefinition))
    {
      return;
    }
    const std::string_view name = this->Entities.Get(property, NameOfProperty).Text;
    const bool recommended = name == "material property";
    const bool named = SaysDensity(name) ||
      SaysDensity(this->Entities.Get(property, DescriptionOfProperty).Text) ||
      SaysDensity(this->Entities.Get(representation, NameOfRepresentation).Text);
    Part21Values items(this->Entities.Get(representation, ItemsOfRepresentation).Text);
    for (Part21Value value; items.Next(value);)
    {
      const Index item = this->Entities.Follow(value);
      if (item != STEPAttributes::None && this->Entities.Get(item, ValueOfItem).Kind == Part21Kind::Typed)
      {
        this->ReadItem(item, product, isOccurrence ? this->File.GetId(described) : 0, recommended,
          named || SaysDensity(this->Entities.Get(item, NameOfItem).Text));
      }
    }
  }

  /// Returns the product or the occurrence that the property describes, directly or through its shape.
  Index FindDescribed(Index property) const
  {
    const Index described = this->Entities.Follow(this->Entities.Get(property, DefinitionOfProperty));
    return this->Entities.Has(described, STEPRole::ProductShape)
      ? this->Entities.Follow(this->Entities.Get(described, DefinitionOfProperty))
      : described;
  }

  /// Reads a density of a product, or of one `occurrence` of it.
  void ReadItem(Index item, Index product, std::uint64_t occurrence, bool recommended, bool named)
  {
    const double unit = this->ReadUnit(this->Entities.Follow(this->Entities.Get(item, UnitOfItem)));
    if (!named && !(recommended && unit > 0.0))
    {
      return;
    }
    STEPDensity density;
    density.Product = this->File.GetId(product);
    density.Id = this->File.GetId(item);
    double number = 0.0;
    const bool isNumber = GetPart21Value(this->Entities.Get(item, ValueOfItem).Text, 0).GetNumber(number);
    if (isNumber && number == 0.0)
    {
      // Some CAD systems write a density of 0 for a part without a material.
      return;
    }
    if (!isNumber)
    {
      density.Problem = "it is not a number";
    }
    else if (!(unit > 0.0))
    {
      density.Problem = "its unit is not a mass by the third power of a length";
    }
    else if (!IsWeight(number * unit))
    {
      density.Problem = std::string("it is not from ") + WeightRange + " kg/m^3";
    }
    else
    {
      density.Density = number * unit;
    }
    if (occurrence != 0)
    {
      this->OfOccurrences.emplace_back(occurrence, density);
      return;
    }
    const int rank = 2 * (density.Problem.empty() ? 1 : 0) + (recommended ? 1 : 0);
    const auto [found, isFirst] = this->Found.try_emplace(density.Product, Candidate{ density, rank });
    if (!isFirst)
    {
      Join({ density, rank }, found->second);
    }
  }

  /// Takes the better of two statements of one product. Where they differ, the other one is named; of equal
  /// rank, none counts.
  static void Join(Candidate other, Candidate& found)
  {
    if (other.Rank > found.Rank)
    {
      std::swap(other, found);
      found.Density.Others = std::move(other.Density.Others);
    }
    STEPDensity& kept = found.Density;
    const bool areUsable = kept.Problem.empty() && other.Density.Problem.empty();
    if (kept.Problem.empty() && !areUsable)
    {
      kept.Others += " #" + std::to_string(other.Density.Id) + " is not used: " + other.Density.Problem + ".";
    }
    else if (areUsable &&
      std::fabs(kept.Density - other.Density.Density) > Rounding * std::fabs(kept.Density))
    {
      if (other.Rank < found.Rank)
      {
        kept.Others += " " + DescribeStatement(other.Density) + " and is not used.";
      }
      else
      {
        kept.Problem = DescribeStatement(kept) + ", and " + DescribeStatement(other.Density);
        kept.Density = 0.0;
        kept.Contradicted = true;
      }
    }
  }

  /// An instance has the density of its product. If the file states another one for it, the product has none.
  void JoinOccurrence(std::uint64_t occurrence, const STEPDensity& stated)
  {
    const std::string place = " for the occurrence #" + std::to_string(occurrence) + " alone";
    Candidate& found = this->Found.try_emplace(stated.Product, Candidate{ stated, 0 }).first->second;
    STEPDensity& kept = found.Density;
    if (!stated.Problem.empty())
    {
      kept.Others += kept.Id == stated.Id
        ? ""
        : " #" + std::to_string(stated.Id) + place + " is not used: " + stated.Problem + ".";
    }
    else if (kept.Id == stated.Id ||
      (kept.Problem.empty() && std::fabs(kept.Density - stated.Density) > Rounding * std::fabs(kept.Density)))
    {
      kept.Problem = (kept.Id == stated.Id ? std::string() : DescribeStatement(kept) + ", and ") +
        DescribeStatement(stated) + place + "; densities of single occurrences are not read";
      kept.Density = 0.0;
      kept.Contradicted = true;
    }
  }

  /// Returns the size of the unit in kg/m^3; 0 if it is not a unit of density.
  double ReadUnit(Index unit) const
  {
    if (unit == STEPAttributes::None)
    {
      return 0.0;
    }
    double mass = 0.0;
    double length = 0.0;
    double massExponent = 0.0;
    double lengthExponent = 0.0;
    Part21Values elements(this->Entities.Get(unit, ElementsOfUnit).Text);
    for (Part21Value value; elements.Next(value);)
    {
      const Index element = this->Entities.Follow(value);
      const Index base = element == STEPAttributes::None
        ? STEPAttributes::None
        : this->Entities.Follow(this->Entities.Get(element, UnitOfElement));
      std::string_view record;
      double exponent = 0.0;
      if (base == STEPAttributes::None || !this->Entities.Get(element, ExponentOfElement).GetNumber(exponent))
      {
        return 0.0;
      }
      const bool isMass = this->Entities.FindRecord(base, "MASS_UNIT", record);
      if (!isMass && !this->Entities.FindRecord(base, "LENGTH_UNIT", record))
      {
        return 0.0;
      }
      std::vector<Index> used;
      const CensusUnit read =
        ReadSTEPUnit(this->Entities, base, isMass ? STEPUnitKind::Mass : STEPUnitKind::Length, used);
      if (read.Status != CensusUnit::State::Stated || (isMass ? massExponent : lengthExponent) != 0.0)
      {
        return 0.0;
      }
      (isMass ? mass : length) = read.Factor;
      (isMass ? massExponent : lengthExponent) = exponent;
    }
    const bool kernel = massExponent == 3.0 && lengthExponent == 2.0 && mass == 1e-3 && length == 10.0;
    const bool density = massExponent == 1.0 && std::fabs(lengthExponent) == 3.0;
    return kernel || density ? 1e9 * mass / (length * length * length) : 0.0;
  }

  const Part21File& File;
  const STEPAttributes& Entities;
  std::map<std::uint64_t, Candidate> Found;
  /// Densities of single occurrences, with the number of each.
  std::vector<std::pair<std::uint64_t, STEPDensity>> OfOccurrences;
};
}

std::vector<STEPDensity> ReadSTEPDensities(const STEPAttributes& entities)
{
  return DensityReader(entities).Read();
}
}
