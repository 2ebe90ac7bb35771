#include "smSTEPProducts.h"

#include "smSTEPCensus.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPUnits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace sm
{
namespace
{
using Index = Part21File::Index;

constexpr STEPAttribute FormationOfDefinition = { "PRODUCT_DEFINITION", 2, 2, "formation" };
constexpr STEPAttribute ProductOfFormation = { "PRODUCT_DEFINITION_FORMATION", 2, 2, "of product" };
constexpr STEPAttribute IdOfProduct = { "PRODUCT", 0, 0, "id" };
constexpr STEPAttribute NameOfProduct = { "PRODUCT", 1, 1, "name" };
constexpr STEPAttribute ShapeOfAspect = { "SHAPE_ASPECT", 2, 2, "of shape" };

/// Returns the text of a string with '' replaced by '.
std::string Unquote(std::string_view text)
{
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    result += text[i];
    i += text[i] == '\'' && i + 1 < text.size() && text[i + 1] == '\'' ? 1 : 0;
  }
  return result;
}

/// Returns true for the name of geometric validation properties, with blanks or underscores.
bool IsValidation(std::string_view name)
{
  constexpr std::string_view expected = "geometric validation property";
  return std::equal(name.begin(), name.end(), expected.begin(), expected.end(),
    [](char a, char b) { return a == b || (a == '_' && b == ' '); });
}

class ProductReader
{
public:
  ProductReader(const Part21File& file, const STEPCensus& census)
    : File(file)
    , Entities(file)
  {
    for (const STEPDensity& density : census.Densities)
    {
      this->WithDensity.insert(density.Product);
    }
    for (const CensusContext& context : census.Contexts)
    {
      this->Millimetres[context.Id] =
        context.Length.Status == CensusUnit::State::Stated ? context.Length.Factor : std::nan("");
    }
  }

  std::vector<STEPProduct> Read()
  {
    this->ForEach("SHAPE_DEFINITION_REPRESENTATION",
      [this](Index shape, Index representation) { this->AddProduct(shape, representation); });
    this->ForEach("PROPERTY_DEFINITION_REPRESENTATION",
      [this](Index property, Index representation)
      {
        if (IsValidation(this->Entities.Get(property, NameOfProperty).Text))
        {
          this->AddProperty(property, representation);
        }
        const Index definition = this->Entities.Follow(this->Entities.Get(property, DefinitionOfProperty));
        const auto found = definition == STEPAttributes::None
          ? this->Products.end()
          : this->Products.find(this->File.GetId(definition));
        if (found != this->Products.end() &&
          this->Entities.Get(representation, NameOfRepresentation).Text == "material name")
        {
          found->second.HasMaterial = true;
        }
      });
    this->AddAspects();
    std::vector<STEPProduct> result;
    for (const auto& [definition, product] : this->Products)
    {
      result.push_back(product);
    }
    return result;
  }

private:
  /// Calls `use` with the two entities that each undamaged entity of the type relates.
  template <typename Use>
  void ForEach(std::string_view type, const Use& use)
  {
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      if (this->File.IsComplex(i) || this->File.IsDamaged(i) ||
        this->File.GetTypeNames()[this->File.GetType(i)] != type)
      {
        continue;
      }
      const Index definition = this->Entities.Follow(this->Entities.Get(i, RepresentedProperty));
      const Index representation = this->Entities.Follow(this->Entities.Get(i, UsedRepresentation));
      if (definition != STEPAttributes::None && representation != STEPAttributes::None)
      {
        use(definition, representation);
      }
    }
  }

  /// Returns the product definition that has this shape.
  Index FindDefinition(Index shape) const
  {
    const Index definition = shape == STEPAttributes::None
      ? STEPAttributes::None
      : this->Entities.Follow(this->Entities.Get(shape, DefinitionOfProperty));
    return this->Entities.Has(definition, STEPRole::ProductDefinition) ? definition : STEPAttributes::None;
  }

  void AddProduct(Index shape, Index representation)
  {
    const Index definition = this->FindDefinition(shape);
    if (definition == STEPAttributes::None || this->Products.count(this->File.GetId(definition)))
    {
      return;
    }
    STEPProduct product;
    product.Definition = this->File.GetId(definition);
    product.Shape = this->File.GetId(shape);
    product.HasDensity = this->WithDensity.count(product.Definition) > 0;
    const Index formation = this->Entities.Follow(this->Entities.Get(definition, FormationOfDefinition));
    const Index named = formation == STEPAttributes::None
      ? STEPAttributes::None
      : this->Entities.Follow(this->Entities.Get(formation, ProductOfFormation));
    if (named != STEPAttributes::None)
    {
      const std::string_view name = this->Entities.Get(named, NameOfProduct).Text;
      product.Name = Unquote(name.empty() ? this->Entities.Get(named, IdOfProduct).Text : name);
    }
    const Index context = this->Entities.Follow(this->Entities.Get(representation, ContextOfRepresentation));
    product.Context = context == STEPAttributes::None ? 0 : this->File.GetId(context);
    product.Millimetres = this->GetMillimetres(context);
    this->Products[product.Definition] = product;
  }

  /// Returns the size of the length unit of a context, also of one that no body has; NaN if it has none.
  double GetMillimetres(Index context)
  {
    if (context == STEPAttributes::None)
    {
      return std::nan("");
    }
    const auto [found, isNew] = this->Millimetres.emplace(this->File.GetId(context), std::nan(""));
    if (isNew)
    {
      CensusContext units;
      units.Id = found->first;
      std::vector<Index> used;
      ReadSTEPUnits(this->Entities, context, units, used);
      found->second = units.Length.Status == CensusUnit::State::Stated ? units.Length.Factor : std::nan("");
    }
    return found->second;
  }

  void AddProperty(Index property, Index representation)
  {
    const Index described = this->Entities.Follow(this->Entities.Get(property, DefinitionOfProperty));
    const Index definition = this->FindDefinition(described);
    const auto found = definition == STEPAttributes::None ? this->Products.end()
                                                          : this->Products.find(this->File.GetId(definition));
    if (found != this->Products.end())
    {
      this->AddItems(representation, found->second);
      return;
    }
    const Index shape = described == STEPAttributes::None
      ? STEPAttributes::None
      : this->Entities.Follow(this->Entities.Get(described, ShapeOfAspect));
    const Index whole = this->FindDefinition(shape);
    if (whole != STEPAttributes::None)
    {
      this->Aspects[this->File.GetId(whole)][this->File.GetId(described)].push_back(representation);
    }
  }

  /// Adds the properties of parts of a shape to products that have none of their own: where only one part of
  /// the shape has properties, it is the whole.
  void AddAspects()
  {
    for (const auto& [definition, aspects] : this->Aspects)
    {
      const auto found = this->Products.find(definition);
      if (found == this->Products.end() || aspects.size() > 1)
      {
        continue;
      }
      const STEPValidation& own = found->second.Stated;
      if (std::isnan(own.Volume) && std::isnan(own.Area) && std::isnan(own.Centroid[0]))
      {
        for (const Index representation : aspects.begin()->second)
        {
          this->AddItems(representation, found->second);
        }
      }
    }
  }

  void AddItems(Index representation, STEPProduct& product)
  {
    Part21Values items(this->Entities.Get(representation, ItemsOfRepresentation).Text);
    for (Part21Value value; items.Next(value);)
    {
      const Index item = this->Entities.Follow(value);
      const Part21Value measure =
        item == STEPAttributes::None ? Part21Value() : this->Entities.Get(item, ValueOfItem);
      if (measure.Kind == Part21Kind::Typed && measure.TypeName == "VOLUME_MEASURE")
      {
        this->Take(item, measure, 3.0, product.Stated.Volume, product.VolumeProblem);
      }
      else if (measure.Kind == Part21Kind::Typed && measure.TypeName == "AREA_MEASURE")
      {
        this->Take(item, measure, 2.0, product.Stated.Area, product.AreaProblem);
      }
      else if (item != STEPAttributes::None &&
        this->File.GetTypeNames()[this->File.GetType(item)] == "CARTESIAN_POINT" &&
        this->Entities.Get(item, NameOfItem).Text == "centre point")
      {
        this->TakePoint(item,
          this->GetMillimetres(
            this->Entities.Follow(this->Entities.Get(representation, ContextOfRepresentation))),
          product);
      }
    }
  }

  /// Sets a value if it was not stated before. A different statement is a problem.
  void Set(double value, double& place, std::string& problem) const
  {
    if (std::isnan(place))
    {
      place = value;
    }
    else if (std::abs(place - value) > 1e-12 * std::abs(place))
    {
      problem = "the same property is stated twice, with different values";
    }
  }

  void Take(Index item, const Part21Value& measure, double power, double& place, std::string& problem) const
  {
    double number = 0.0;
    const double unit = this->ReadUnit(this->Entities.Follow(this->Entities.Get(item, UnitOfItem)), power);
    if (!GetPart21Value(measure.Text, 0).GetNumber(number))
    {
      problem = "#" + std::to_string(this->File.GetId(item)) + " is not a number";
    }
    else if (!(unit > 0.0))
    {
      problem = "#" + std::to_string(this->File.GetId(item)) +
        " has no unit that is a length to the power of " + (power == 3.0 ? "3" : "2");
    }
    else
    {
      this->Set(number * unit, place, problem);
    }
  }

  void TakePoint(Index item, double millimetres, STEPProduct& product) const
  {
    const std::string_view list = this->Entities.Get(item, CoordinatesOfPoint).Text;
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (!GetPart21Value(list, i).GetNumber(point[i]) || !(millimetres > 0.0))
      {
        product.CentroidProblem =
          "#" + std::to_string(this->File.GetId(item)) + " is not a point with a length unit";
        return;
      }
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Set(point[i] * millimetres, product.Stated.Centroid[i], product.CentroidProblem);
    }
  }

  /// Returns the size of a derived unit in millimetres to the given power; 0 if it is not such a unit.
  double ReadUnit(Index unit, double power) const
  {
    double factor = 1.0;
    double sum = 0.0;
    Part21Values elements(
      unit == STEPAttributes::None ? std::string_view() : this->Entities.Get(unit, ElementsOfUnit).Text);
    for (Part21Value value; elements.Next(value);)
    {
      const Index element = this->Entities.Follow(value);
      const Index base = element == STEPAttributes::None
        ? STEPAttributes::None
        : this->Entities.Follow(this->Entities.Get(element, UnitOfElement));
      std::string_view record;
      double exponent = 0.0;
      if (base == STEPAttributes::None ||
        !this->Entities.Get(element, ExponentOfElement).GetNumber(exponent) ||
        !this->Entities.FindRecord(base, "LENGTH_UNIT", record))
      {
        return 0.0;
      }
      std::vector<Index> used;
      const CensusUnit length = ReadSTEPUnit(this->Entities, base, STEPUnitKind::Length, used);
      if (length.Status != CensusUnit::State::Stated)
      {
        return 0.0;
      }
      factor *= std::pow(length.Factor, exponent);
      sum += exponent;
    }
    return sum == power ? factor : 0.0;
  }

  const Part21File& File;
  STEPAttributes Entities;
  std::map<std::uint64_t, double> Millimetres;
  std::set<std::uint64_t> WithDensity;
  std::map<std::uint64_t, STEPProduct> Products;
  /// Representations of properties of parts of shapes, by the product and the SHAPE_ASPECT.
  std::map<std::uint64_t, std::map<std::uint64_t, std::vector<Index>>> Aspects;
};

/// Formats a string of Part 21; bytes beyond ASCII become blanks.
std::string Quote(const std::string& text)
{
  std::string result = "'";
  for (const char c : text)
  {
    result += c == '\'' ? "''" : c == '\\' ? "\\\\" : c >= ' ' && c <= '~' ? std::string(1, c) : " ";
  }
  return result + "'";
}

/// Collects new entities, with numbers above the largest one of a file.
class EntityWriter
{
public:
  explicit EntityWriter(const Part21File& file)
  {
    for (Index i = 0; i < file.GetNumberOfInstances(); ++i)
    {
      this->Last = std::max(this->Last, file.GetId(i));
    }
  }

  std::string Add(const std::string& entity)
  {
    const std::string name = "#" + std::to_string(++this->Last);
    this->Text += name + "=" + entity + ";\n";
    return name;
  }

  /// Each unit is written once.
  std::string AddOnce(const std::string& entity)
  {
    const auto [place, isNew] = this->Known.emplace(entity, std::string());
    if (isNew)
    {
      place->second = this->Add(entity);
    }
    return place->second;
  }

  std::string AddPower(const std::string& unit, const char* exponent)
  {
    return this->AddOnce("DERIVED_UNIT_ELEMENT(" + unit + "," + exponent + ")");
  }

  void AddProperty(const std::string& name, const std::string& described, const std::string& representation,
    const std::string& item, std::uint64_t context)
  {
    const std::string property = this->Add("PROPERTY_DEFINITION(" + name + "," + described + ")");
    const std::string shown =
      this->Add("REPRESENTATION(" + representation + ",(" + item + "),#" + std::to_string(context) + ")");
    this->Add("PROPERTY_DEFINITION_REPRESENTATION(" + property + "," + shown + ")");
  }

  std::string Text;

private:
  std::uint64_t Last = 0;
  std::map<std::string, std::string> Known;
};

/// Returns the position of the end of the section whose last instance ends at `at`: only blanks and comments
/// are between them.
std::size_t FindEndOfSection(std::string_view text, std::size_t at)
{
  constexpr std::string_view word = "ENDSEC";
  while (at < text.size() && text.compare(at, word.size(), word) != 0)
  {
    const std::size_t comment = text.compare(at, 2, "/*") == 0 ? text.find("*/", at + 2) : at;
    at = comment == std::string_view::npos ? text.size() : comment == at ? at + 1 : comment + 2;
  }
  return at < text.size() ? at : std::string_view::npos;
}

void AddStatement(const STEPStatement& statement, EntityWriter& writer)
{
  const STEPProduct& product = statement.Product;
  const std::string shape = "#" + std::to_string(product.Shape);
  const std::string validation = "'geometric validation property',''";
  const std::string millimetre = "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))";
  if (std::isfinite(statement.Values.Volume))
  {
    const std::string unit =
      writer.AddOnce("DERIVED_UNIT((" + writer.AddPower(writer.AddOnce(millimetre), "3.") + "))");
    const std::string item = writer.Add("MEASURE_REPRESENTATION_ITEM('volume measure',VOLUME_MEASURE(" +
      FormatPart21Real(statement.Values.Volume) + ")," + unit + ")");
    writer.AddProperty(validation, shape, "'volume'", item, product.Context);
  }
  if (std::isfinite(statement.Values.Area))
  {
    const std::string unit =
      writer.AddOnce("DERIVED_UNIT((" + writer.AddPower(writer.AddOnce(millimetre), "2.") + "))");
    const std::string item = writer.Add("MEASURE_REPRESENTATION_ITEM('surface area measure',AREA_MEASURE(" +
      FormatPart21Real(statement.Values.Area) + ")," + unit + ")");
    writer.AddProperty(validation, shape, "'surface area'", item, product.Context);
  }
  const std::array<double, 3>& c = statement.Values.Centroid;
  if (std::isfinite(c[0] + c[1] + c[2]) && product.Millimetres > 0.0)
  {
    const auto format = [&](double x) { return FormatPart21Real(x / product.Millimetres); };
    const std::string item = writer.Add(
      "CARTESIAN_POINT('centre point',(" + format(c[0]) + "," + format(c[1]) + "," + format(c[2]) + "))");
    writer.AddProperty(validation, shape, "'centroid'", item, product.Context);
  }
  if (statement.Density > 0.0 && std::isfinite(statement.Density))
  {
    const std::string kilogram = writer.AddOnce("(MASS_UNIT()NAMED_UNIT(*)SI_UNIT(.KILO.,.GRAM.))");
    const std::string metre = writer.AddOnce("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))");
    const std::string unit = writer.AddOnce(
      "DERIVED_UNIT((" + writer.AddPower(kilogram, "1.") + "," + writer.AddPower(metre, "-3.") + "))");
    const std::string item =
      writer.Add("MEASURE_REPRESENTATION_ITEM('density measure',POSITIVE_RATIO_MEASURE(" +
        FormatPart21Real(statement.Density) + ")," + unit + ")");
    const std::string definition = "#" + std::to_string(product.Definition);
    writer.AddProperty("'material property','density'", definition, "'density'", item, product.Context);
    if (!statement.Material.empty() && !product.HasMaterial)
    {
      writer.AddProperty("'material property','material name'", definition, "'material name'",
        writer.Add("DESCRIPTIVE_REPRESENTATION_ITEM(" + Quote(statement.Material) + ",'')"), product.Context);
    }
  }
}
}

std::vector<STEPProduct> ReadSTEPProducts(const Part21File& file)
{
  return ReadSTEPProducts(file, TakeSTEPCensus(file));
}

std::vector<STEPProduct> ReadSTEPProducts(const Part21File& file, const STEPCensus& census)
{
  return ProductReader(file, census).Read();
}

std::string AppendSTEPValidation(const Part21File& file, const std::vector<STEPStatement>& statements)
{
  const std::string_view text = file.GetText();
  const Index count = file.GetNumberOfInstances();
  const std::size_t at = count == 0
    ? std::string_view::npos
    : FindEndOfSection(text, file.GetOffset(count - 1) + file.GetText(count - 1).size());
  if (at == std::string_view::npos)
  {
    return {};
  }
  EntityWriter writer(file);
  for (const STEPStatement& statement : statements)
  {
    AddStatement(statement, writer);
  }
  return std::string(text.substr(0, at)) + writer.Text + std::string(text.substr(at));
}
}
