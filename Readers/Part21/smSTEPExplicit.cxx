#include "smSTEPExplicit.h"

#include "smPart21Changes.h"
#include "smSTEPFrames.h"
#include "smSTEPKnownForms.h"
#include "smSTEPPropertyAttributes.h"
#include "smSTEPStructureAttributes.h"
#include "smSTEPUnits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace sm
{
namespace
{
constexpr STEPAttribute FirstItem = { "ITEM_DEFINED_TRANSFORMATION", 2, 2, "first item" };
constexpr STEPAttribute SecondItem = { "ITEM_DEFINED_TRANSFORMATION", 3, 3, "second item" };
constexpr STEPAttribute PositionOfCone = { "ELEMENTARY_SURFACE", 0, 1, "position" };
constexpr STEPAttribute RadiusOfCone = { "CONICAL_SURFACE", 0, 2, "radius" };
constexpr STEPAttribute AngleOfCone = { "CONICAL_SURFACE", 1, 3, "angle" };

/// The parameters of a simple CARTESIAN_TRANSFORMATION_OPERATOR_3D behind its names: two axes, origin, scale,
/// third axis.
constexpr std::size_t OperatorParameters = 5;
constexpr std::size_t AxesOfOperator[] = { 0, 1, 4 };

/// Geometry that does not depend on the x axis of its placement, unless it is trimmed by parameters.
constexpr std::string_view Round[] = { "PLANE", "CYLINDRICAL_SURFACE", "CONICAL_SURFACE", "SPHERICAL_SURFACE",
  "TOROIDAL_SURFACE", "DEGENERATE_TOROIDAL_SURFACE", "CIRCLE" };
constexpr std::string_view Trimming[] = { "TRIMMED_CURVE", "RECTANGULAR_TRIMMED_SURFACE" };

class ExplicitMaker
{
public:
  using Index = Part21File::Index;

  explicit ExplicitMaker(const Part21File& file)
    : File(file)
    , Entities(file)
    , Changes(file)
  {
  }

  STEPExplicit Make()
  {
    std::vector<Index> relationships;
    std::vector<Index> mapped;
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      const std::uint64_t roles = this->File.IsDamaged(i) ? 0 : this->Entities.GetRoles(i);
      if (roles & STEPRole::Context)
      {
        this->AddContext(i);
      }
      else if (roles & STEPRole::Placement)
      {
        this->CompletePlacement(i);
      }
      else if (roles & STEPRole::Transformation)
      {
        this->CompleteOperator(i);
      }
      else if (roles & STEPRole::Surface)
      {
        this->CompleteCone(i);
      }
      else if (roles & (STEPRole::Relationship | STEPRole::MappedItem))
      {
        (roles & STEPRole::Relationship ? relationships : mapped).push_back(i);
      }
      else if (roles & STEPRole::Occurrence)
      {
        this->SimplifyOccurrence(i);
      }
    }
    for (const Index i : relationships)
    {
      this->PlaceRelated(i);
    }
    if (!mapped.empty())
    {
      this->PlaceMapped(mapped);
    }
    this->ReportParallel();
    UseKnownForms(this->Entities, this->Changes);
    this->Result.Text = this->Changes.Apply();
    return std::move(this->Result);
  }

private:
  bool IsType(Index i, std::string_view type) const
  {
    return i != Part21File::None && !this->File.IsComplex(i) && !this->File.IsDamaged(i) &&
      this->File.GetTypeNames()[this->File.GetType(i)] == type;
  }

  void AddContext(Index i)
  {
    std::string_view record;
    if (!this->Entities.FindRecord(i, UnitsOfContext.Record, record))
    {
      return;
    }
    CensusContext context;
    context.Id = this->File.GetId(i);
    std::vector<Index> used;
    ReadSTEPUnits(this->Entities, i, context, used);
    if (context.Length.Status == CensusUnit::State::Stated)
    {
      this->Millimetres[i] = context.Length.Factor;
    }
    this->ConvertUnit(context.Length, true);
    this->ConvertUnit(context.Angle, false);
    if (context.Angle.Status == CensusUnit::State::Missing)
    {
      this->AddRadian(i);
    }
    this->Result.Contexts.push_back(std::move(context));
  }

  const std::string& GetRadian()
  {
    if (this->Radian.empty())
    {
      this->Radian = this->Changes.Add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    }
    return this->Radian;
  }

  /// Adds radians to the units of a context that has none of angles: OpenCASCADE would take degrees.
  void AddRadian(Index context)
  {
    const Part21Value units = this->Entities.Get(context, UnitsOfContext);
    Part21Value first;
    if (units.IsList() && Part21Values(units.Text).Next(first))
    {
      this->Changes.Replace(first.Text, this->GetRadian() + "," + std::string(first.Text));
    }
  }

  /// Makes a unit of a context one that OpenCASCADE knows.
  void ConvertUnit(const CensusUnit& stated, bool isLength)
  {
    const Index unit = this->File.Find(stated.Id);
    if (stated.Status != CensusUnit::State::Stated || !this->Converted.insert(unit).second)
    {
      return;
    }
    const std::string kinds = isLength ? "LENGTH_UNIT()NAMED_UNIT(" : "NAMED_UNIT(";
    const std::string behind = isLength ? ")" : ")PLANE_ANGLE_UNIT()";
    const std::string name = "#" + std::to_string(stated.Id) + "=(";
    std::string_view record;
    if (this->Entities.FindRecord(unit, SIName.Record, record))
    {
      if (!this->File.IsComplex(unit))
      {
        const Part21Value prefix = this->Entities.Get(unit, Prefix);
        this->Changes.Replace(this->File.GetText(unit),
          name + kinds + "*" + behind + "SI_UNIT(" +
            (prefix.Kind == Part21Kind::Enumeration ? "." + std::string(prefix.Text) + ".," : "$,") +
            (isLength ? ".METRE." : ".RADIAN.") + "));");
      }
      return;
    }
    const Part21Value factor = this->Entities.Get(unit, ConversionFactor);
    const Index measure = this->Entities.Follow(factor);
    const Index base = this->Entities.Follow(this->Entities.Get(measure, MeasureUnit));
    if (!this->File.IsComplex(unit))
    {
      const Part21Value dimensions = GetPart21Value(this->File.GetParameters(unit), 0);
      this->Changes.Replace(this->File.GetText(unit),
        name + "CONVERSION_BASED_UNIT('" + std::string(this->Entities.Get(unit, ConversionName).Text) + "'," +
          std::string(factor.Text) + ")" + kinds +
          (dimensions.IsReference() ? std::string(dimensions.Text) : "*") + behind + ");");
    }
    const bool isDirect =
      this->Entities.FindRecord(base, SIName.Record, record) && this->File.IsComplex(base);
    if (!isDirect && !this->File.IsComplex(measure) && this->Converted.insert(measure).second)
    {
      if (isLength && this->Millimetre.empty())
      {
        this->Millimetre = this->Changes.Add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
      }
      const std::string& si = isLength ? this->Millimetre : this->GetRadian();
      this->Changes.Replace(this->File.GetText(measure),
        "#" + std::to_string(this->File.GetId(measure)) + "=" +
          (isLength ? "LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE("
                    : "PLANE_ANGLE_MEASURE_WITH_UNIT(PLANE_ANGLE_MEASURE(") +
          FormatPart21Real(stated.Factor) + ")," + si + ");");
    }
  }

  std::string AddDirection(const STEPVector& direction) { return this->AddVector("DIRECTION", direction); }

  std::string AddVector(const std::string& type, const STEPVector& vector)
  {
    return this->Changes.Add(type + "('',(" + FormatPart21Real(vector[0]) + "," +
      FormatPart21Real(vector[1]) + "," + FormatPart21Real(vector[2]) + "))");
  }

  std::string AddFrame(const STEPFrame& frame)
  {
    return this->Changes.Add("AXIS2_PLACEMENT_3D(''," + this->AddVector("CARTESIAN_POINT", frame.Origin) +
      "," + this->AddDirection(frame.Axes[2]) + "," + this->AddDirection(frame.Axes[0]) + ")");
  }

  const std::string& AddOrigin()
  {
    if (this->Origin.empty())
    {
      this->Origin = this->AddFrame(STEPFrame());
    }
    return this->Origin;
  }

  void CompletePlacement(Index i)
  {
    STEPVector z = { 0.0, 0.0, 1.0 };
    if (!this->IsType(i, AxisOfPlacement.Record))
    {
      return;
    }
    const Part21Value axis = this->Entities.Get(i, AxisOfPlacement);
    const Part21Value reference = this->Entities.Get(i, ReferenceOfPlacement);
    if (axis.Kind != Part21Kind::Omitted &&
      !ReadSTEPDirection(this->Entities, this->Entities.Follow(axis), z))
    {
      return;
    }
    STEPVector x{};
    if (reference.Kind == Part21Kind::Omitted)
    {
      constexpr double rounding = 1e-14;
      const STEPVector kernel = GetKernelFirstAxis(z);
      ProjectFirstAxis(z, nullptr, x);
      if (std::fabs(x[0] - kernel[0]) + std::fabs(x[1] - kernel[1]) + std::fabs(x[2] - kernel[2]) > rounding)
      {
        this->Changes.Replace(reference.Text, this->AddDirection(x));
      }
    }
    else if (STEPVector near{}; ReadSTEPDirection(this->Entities, this->Entities.Follow(reference), near) &&
             !ProjectFirstAxis(z, &near, x))
    {
      this->Parallel.insert(i);
    }
  }

  /// A cone without an angle is a cylinder; OpenCASCADE makes it a cone of 1e-12.
  void CompleteCone(Index i)
  {
    double angle = 1.0;
    double radius = 0.0;
    const Part21Value stated = this->Entities.Get(i, RadiusOfCone);
    if (this->IsType(i, AngleOfCone.Record) && this->Entities.Get(i, AngleOfCone).GetNumber(angle) &&
      angle == 0.0 && stated.GetNumber(radius) && radius > 0.0)
    {
      this->Changes.Replace(this->File.GetText(i),
        "#" + std::to_string(this->File.GetId(i)) + "=CYLINDRICAL_SURFACE('',#" +
          std::to_string(this->Entities.Get(i, PositionOfCone).Id) + "," + FormatPart21Real(radius) + ");");
    }
  }

  void SimplifyOccurrence(Index i)
  {
    std::string_view parts[2];
    if (this->Entities.IsOccurrenceInParts(i) &&
      this->Entities.FindRecord(i, "PRODUCT_DEFINITION_RELATIONSHIP", parts[0]) &&
      this->Entities.FindRecord(i, "ASSEMBLY_COMPONENT_USAGE", parts[1]))
    {
      this->Changes.Replace(this->File.GetText(i),
        "#" + std::to_string(this->File.GetId(i)) + "=NEXT_ASSEMBLY_USAGE_OCCURRENCE(" +
          std::string(parts[0]) + "," + std::string(parts[1]) + ");");
    }
  }

  void CompleteOperator(Index i)
  {
    if (!this->IsType(i, "CARTESIAN_TRANSFORMATION_OPERATOR_3D"))
    {
      return;
    }
    std::vector<Part21Value> values;
    Part21Values parameters(this->File.GetParameters(i));
    for (Part21Value value; parameters.Next(value);)
    {
      values.push_back(value);
    }
    if (values.size() < OperatorParameters)
    {
      return;
    }
    const std::size_t first = values.size() - OperatorParameters;
    std::array<STEPVector, 3> read{};
    std::array<const STEPVector*, 3> given{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Part21Value& value = values[first + AxesOfOperator[k]];
      if (value.Kind != Part21Kind::Omitted)
      {
        if (!ReadSTEPDirection(this->Entities, this->Entities.Follow(value), read[k]))
        {
          return;
        }
        given[k] = &read[k];
      }
    }
    std::array<STEPVector, 3> axes{};
    if (!MakeBaseAxes(given, axes))
    {
      this->Result.Doubts.push_back(
        { this->File.GetId(i), "an axis of the operator, or its default, is parallel to another one" });
    }
    else if (!given[0] || !given[1] || !given[2])
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->Changes.Replace(values[first + AxesOfOperator[k]].Text, this->AddDirection(axes[k]));
      }
    }
  }

  double GetMillimetres(Index representation) const
  {
    const Index context = this->Entities.Follow(this->Entities.Get(representation, ContextOfRepresentation));
    const auto found = this->Millimetres.find(context);
    return found == this->Millimetres.end() ? 1.0 : found->second;
  }

  bool HasItem(Index representation, Index item)
  {
    const auto [items, isNew] = this->Items.try_emplace(representation);
    if (isNew)
    {
      Part21Values values(this->Entities.Get(representation, ItemsOfRepresentation).Text);
      for (Part21Value value; values.Next(value);)
      {
        items->second.insert(this->Entities.Follow(value));
      }
    }
    return items->second.count(item) > 0;
  }

  /// Makes the placement that the first representation gets in the second one, if OpenCASCADE would make
  /// another one.
  bool MakePlacement(Index origin, Index target, Index first, Index second, std::string& placement)
  {
    STEPFrame from;
    STEPFrame to;
    if (first == Part21File::None || second == Part21File::None ||
      !ReadSTEPFrame(this->Entities, origin, from) || !ReadSTEPFrame(this->Entities, target, to) ||
      IsSame(from, STEPFrame(), 0.0) || IsSame(to, STEPFrame(), 0.0))
    {
      return false;
    }
    // Some systems interchange the placements. Which is which, is seen by the representation that has them.
    if ((!this->HasItem(first, origin) || !this->HasItem(second, target)) && this->HasItem(first, target) &&
      this->HasItem(second, origin))
    {
      std::swap(from, to);
    }
    double size = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      from.Origin[k] *= this->GetMillimetres(first) / this->GetMillimetres(second);
      size += std::fabs(from.Origin[k]) + std::fabs(to.Origin[k]);
    }
    const STEPFrame inverse = Invert(from);
    const STEPFrame placed = Compose(to, inverse);
    if (IsSame(placed, Compose(inverse, to), size))
    {
      return false;
    }
    placement = this->AddFrame(placed);
    return true;
  }

  void PlaceRelated(Index i)
  {
    const Part21Value value = this->Entities.Get(i, OperatorOfRelationship);
    const Index transformation = this->Entities.Follow(value);
    std::string placement;
    if (this->IsType(transformation, FirstItem.Record) &&
      this->MakePlacement(this->Entities.Follow(this->Entities.Get(transformation, FirstItem)),
        this->Entities.Follow(this->Entities.Get(transformation, SecondItem)),
        this->Entities.Follow(this->Entities.Get(i, FirstRepresentation)),
        this->Entities.Follow(this->Entities.Get(i, SecondRepresentation)), placement))
    {
      this->Changes.Replace(value.Text,
        this->Changes.Add("ITEM_DEFINED_TRANSFORMATION('',''," + this->AddOrigin() + "," + placement + ")"));
    }
  }

  void PlaceMapped(const std::vector<Index>& mapped)
  {
    std::unordered_map<Index, Index> holders;
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      if (!this->Entities.Has(i, STEPRole::Representation) || this->File.IsDamaged(i))
      {
        continue;
      }
      Part21Values values(this->Entities.Get(i, ItemsOfRepresentation).Text);
      for (Part21Value value; values.Next(value);)
      {
        const Index item = this->Entities.Follow(value);
        if (this->Entities.Has(item, STEPRole::MappedItem))
        {
          holders.emplace(item, i);
        }
      }
    }
    std::map<Index, std::string> maps;
    for (const Index i : mapped)
    {
      const Part21Value source = this->Entities.Get(i, MappingSource);
      const Part21Value target = this->Entities.Get(i, MappingTarget);
      const Index map = this->Entities.Follow(source);
      const auto holder = holders.find(i);
      if (map == Part21File::None || this->File.IsDamaged(map) || holder == holders.end())
      {
        continue;
      }
      const Index origin = this->Entities.Follow(this->Entities.Get(map, MappingOrigin));
      const Part21Value shape = this->Entities.Get(map, MappedRepresentation);
      std::string placement;
      STEPFrame from;
      if (this->Entities.Has(this->Entities.Follow(target), STEPRole::Transformation) &&
        ReadSTEPFrame(this->Entities, origin, from) && !IsSame(from, STEPFrame(), 0.0))
      {
        this->Result.Doubts.push_back({ target.Id,
          "the operator is the target of a mapped item whose origin is not that of its representation" });
      }
      else if (this->MakePlacement(origin, this->Entities.Follow(target), this->Entities.Follow(shape),
                 holder->second, placement))
      {
        std::string& moved = maps[map];
        if (moved.empty())
        {
          moved = this->Changes.Add(
            "REPRESENTATION_MAP(" + this->AddOrigin() + "," + std::string(shape.Text) + ")");
        }
        this->Changes.Replace(source.Text, moved);
        this->Changes.Replace(target.Text, placement);
      }
    }
  }

  /// Reports the placements whose x axis is needed but not known.
  void ReportParallel()
  {
    if (this->Parallel.empty())
    {
      return;
    }
    std::unordered_set<Index> needed;
    // Round geometry by its placement.
    std::unordered_map<Index, Index> round;
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      const bool isRound = std::any_of(std::begin(Round), std::end(Round),
        [this, i](std::string_view type) { return this->IsType(i, type); });
      for (const Index to : this->File.GetReferences(i))
      {
        if (this->Parallel.count(to) > 0 && isRound)
        {
          round.emplace(i, to);
        }
        else if (this->Parallel.count(to) > 0 && !this->Entities.Has(i, STEPRole::Representation))
        {
          needed.insert(to);
        }
      }
    }
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      if (std::any_of(std::begin(Trimming), std::end(Trimming),
            [this, i](std::string_view type) { return this->IsType(i, type); }))
      {
        for (const Index to : this->File.GetReferences(i))
        {
          const auto found = round.find(to);
          if (found != round.end())
          {
            needed.insert(found->second);
          }
        }
      }
    }
    for (const Index i : needed)
    {
      this->Result.Doubts.push_back({ this->File.GetId(i),
        "its reference direction is parallel to its axis, so that its x axis is not known" });
    }
    std::sort(this->Result.Doubts.begin(), this->Result.Doubts.end(),
      [](const STEPDoubt& a, const STEPDoubt& b) { return a.Id < b.Id; });
  }

  const Part21File& File;
  STEPAttributes Entities;
  Part21Changes Changes;
  STEPExplicit Result;
  /// Sizes of the length units of contexts.
  std::unordered_map<Index, double> Millimetres;
  /// Units and measures that have been converted.
  std::unordered_set<Index> Converted;
  /// Names of new entities that are used several times; empty until they are.
  std::string Millimetre;
  std::string Radian;
  std::string Origin;
  std::unordered_set<Index> Parallel;
  /// The items of representations that were looked up.
  std::unordered_map<Index, std::unordered_set<Index>> Items;
};
}

STEPExplicit MakeSTEPExplicit(const Part21File& file)
{
  return file.GetNumberOfInstances() == 0 ? STEPExplicit() : ExplicitMaker(file).Make();
}
}
