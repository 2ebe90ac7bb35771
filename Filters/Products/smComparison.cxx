#include "smComparison.h"

#include "smPartMatch.h"
#include "smUnitRoundoff.h"
#include "smVector.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
using namespace states;
/// The states in the order of the list.
constexpr const char* States[] = { Changed, Mirrored, Moved, Added, Removed, Unchanged };

template <std::size_t N>
QuantityDifference<N> MakeDifference(const Quantity<N>& before, const Quantity<N>& after)
{
  QuantityDifference<N> difference{ before, after, {} };
  if (before.IsKnown() && after.IsKnown())
  {
    for (std::size_t i = 0; i < N; ++i)
    {
      difference.Change.Value[i] = after.Value[i] - before.Value[i];
    }
    difference.Change.Bound = (before.Bound + after.Bound) * (1.0 + 4.0 * UnitRoundoff) +
      UnitRoundoff * GetLargest(difference.Change.Value);
  }
  return difference;
}

Differences MakeDifferences(const Quantities& before, const Quantities& after)
{
  return { MakeDifference(before.Volume, after.Volume), MakeDifference(before.Area, after.Area),
    MakeDifference(before.Mass, after.Mass), MakeDifference(before.Center, after.Center),
    MakeDifference(before.MassCenter, after.MassCenter), MakeDifference(before.Inertia, after.Inertia),
    MakeDifference(before.MassInertia, after.MassInertia) };
}

template <std::size_t N>
void Visit(Fields& fields, const char* key, QuantityDifference<N>& difference)
{
  const auto visit = [&fields](const char* name, std::array<double, N>& values)
  {
    if (N == 1)
    {
      fields.Number(name, values[0]);
    }
    else
    {
      fields.Numbers(name, values.data(), N / 3, 3);
    }
  };
  fields.Note("", "new minus old, with the sum of both bounds").Begin(key);
  visit("old", difference.Old.Value);
  visit("new", difference.New.Value);
  visit("difference", difference.Change.Value);
  fields.Number("bound", difference.Change.Bound);
  fields.End();
}

void Visit(Fields& fields, Differences& differences)
{
  Visit(fields, "volume", differences.Volume);
  Visit(fields, "area", differences.Area);
  Visit(fields, "center_of_mass", differences.Center);
  Visit(fields, "inertia", differences.Inertia);
  Visit(fields, "mass", differences.Mass);
  Visit(fields, "mass_center", differences.MassCenter);
  Visit(fields, "mass_inertia", differences.MassInertia);
}

void Visit(Fields& fields, ComparedBody& body)
{
  fields.Note("", "`id` of the solid in the old file").Name("old_id", body.OldId);
  fields.Note("", "`id` of the solid in the new file").Name("new_id", body.NewId);
  fields.Note("L", "of two equal shapes").Point("translation", body.Translation);
  fields.Note("L", "length of the translation").Number("distance", body.Distance);
  fields.Note("degrees", "").Number("rotation_angle", body.RotationAngle);
  fields.Note("1", "").Point("rotation_axis", body.RotationAxis);
}

void Visit(Fields& fields, ComparedPart& part)
{
  auto count = static_cast<long long>(part.Bodies.size());
  auto inOld = static_cast<long long>(part.InOld);
  auto inNew = static_cast<long long>(part.InNew);
  fields.Note("", "`unchanged`, `moved`, `mirrored`, `changed`, `added` or `removed`")
    .Text("state", part.State);
  fields.Text("name", part.Name);
  fields.Text("old_name", part.OldName);
  fields.Note("", "number of its solids").Count("count", count);
  fields.Note("", "solids of this name in the old file").Count("in_old", inOld);
  fields.Note("", "solids of this name in the new file").Count("in_new", inNew);
  fields.Note("", "changes other than that of the place").Texts("notes", part.Notes);
  if (fields.Note("", "of the first of its solids").Begin("difference", part.Difference.has_value()))
  {
    part.Difference = part.Difference.value_or(Differences());
    Visit(fields, *part.Difference);
    fields.End();
  }
  fields.Note("", "its solids")
    .List("bodies", part.Bodies, [&fields](ComparedBody& body) { Visit(fields, body); });
}

/// Returns true if material, density or mass of two equal shapes differ: the mass by more than the bounds and
/// the limit. Densities are not results and have no bounds.
bool HasOtherMaterial(const Quantities& before, const Quantities& after, double limit)
{
  const double a = before.Density;
  const double b = after.Density;
  if (before.Material != after.Material || std::isnan(a) != std::isnan(b) ||
    (!std::isnan(a) && !(std::abs(b - a) <= limit * std::abs(a))))
  {
    return true;
  }
  const ScalarQuantity change = MakeDifference(before.Mass, after.Mass).Change;
  if (!change.IsKnown())
  {
    return before.Mass.IsKnown() != after.Mass.IsKnown();
  }
  const double scale = std::max(std::abs(before.Mass.Get()), std::abs(after.Mass.Get()));
  const double bound = std::isnan(change.Bound) ? 0.0 : change.Bound;
  return !(std::abs(change.Get()) <= bound + limit * scale);
}

/// Returns true if volumes and principal moments are equal within the bounds and the limit, or not known.
bool HaveSameMoments(const Quantities& before, const Quantities& after, double limit)
{
  const auto areEqual = [limit](const auto& a, const auto& b)
  {
    const auto change = MakeDifference(a, b).Change;
    const double scale = std::max(GetLargest(a.Value), GetLargest(b.Value));
    const double bound = std::isnan(change.Bound) ? 0.0 : change.Bound;
    return !change.IsKnown() || GetLargest(change.Value) <= bound + limit * scale;
  };
  return areEqual(before.Volume, after.Volume) && areEqual(before.PrincipalMoments, after.PrincipalMoments);
}

/// A solid of one of the files.
struct Body
{
  const SolidResults* Solid;
  PlacedPartShape Shape;
  std::array<double, 3> Center{};
  bool IsDone = false;

  const std::string& GetName() const { return this->Solid->Name; }
  bool HasShape() const { return this->Shape.Shape && this->Shape.Shape->Problem.empty(); }
};

std::vector<Body> ListEntries(const ProductResults& results, const ProductShapes& measured)
{
  std::map<std::string, PlacedPartShape> shapes = ReadShapes(measured);
  std::vector<Body> bodies;
  for (const SolidResults& solid : results.Solids)
  {
    Body body{ &solid, shapes[solid.Id] };
    body.Center = body.Shape.Shape ? body.Shape.GetCenter() : body.Center;
    bodies.push_back(std::move(body));
  }
  return bodies;
}

double GetDistance(const Body& a, const Body& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.Center.data(), b.Center.data()));
}

/// The state of a pair of solids, one of which may be null.
struct Outcome
{
  const Body* Old;
  const Body* New;
  const char* State;
  bool HasSameShape = false;
  sm::Rotation Rotation{};
};

/// Returns the diagonal of the larger product.
double GetLargerDiagonal(const ProductResults& a, const ProductResults& b)
{
  return std::max(std::isnan(a.Diagonal) ? 0.0 : a.Diagonal, std::isnan(b.Diagonal) ? 0.0 : b.Diagonal);
}

class Comparison
{
public:
  Comparison(std::vector<Body> before, std::vector<Body> after, double limit, double diagonal,
    std::function<bool()> shouldContinue)
    : ShouldContinue(std::move(shouldContinue))
    , Old(std::move(before))
    , New(std::move(after))
    , Limit(limit)
    , Diagonal(diagonal)
  {
  }

  std::vector<Outcome> Run()
  {
    for (const bool sameName : { true, false })
    {
      this->MatchPlaces(sameName);
    }
    for (const bool sameName : { true, false })
    {
      this->MatchShapes(sameName);
    }
    this->MatchMirrors(true);
    this->MatchNames();
    this->MatchMirrors(false);
    this->MatchOnly();
    for (const Body& body : this->Old)
    {
      if (!body.IsDone)
      {
        this->Outcomes.push_back({ &body, nullptr, Removed });
      }
    }
    for (const Body& body : this->New)
    {
      if (!body.IsDone)
      {
        this->Outcomes.push_back({ nullptr, &body, Added });
      }
    }
    return this->Outcomes;
  }

private:
  void Add(Body& before, Body& after, const char* state, bool hasSameShape, const Rotation& rotation = {})
  {
    before.IsDone = after.IsDone = true;
    const bool isOther =
      hasSameShape && HasOtherMaterial(before.Solid->Values, after.Solid->Values, this->Limit);
    this->Outcomes.push_back({ &before, &after, isOther ? Changed : state, hasSameShape, rotation });
  }

  /// Matches equal shapes at the same place.
  void MatchPlaces(bool sameName)
  {
    std::vector<Body*> sorted;
    for (Body& body : this->New)
    {
      if (!body.IsDone && body.HasShape())
      {
        sorted.push_back(&body);
      }
    }
    std::sort(
      sorted.begin(), sorted.end(), [](const Body* a, const Body* b) { return a->Center[0] < b->Center[0]; });
    const double slack = this->Limit * this->Diagonal;
    for (Body& before : this->Old)
    {
      if (before.IsDone || !before.HasShape() || !this->ShouldContinue())
      {
        continue;
      }
      const double minimum = before.Center[0] - slack;
      auto next = std::partition_point(
        sorted.begin(), sorted.end(), [minimum](const Body* body) { return body->Center[0] < minimum; });
      for (; next != sorted.end() && (*next)->Center[0] <= before.Center[0] + slack; ++next)
      {
        Body& after = **next;
        if (!after.IsDone && GetDistance(before, after) <= slack &&
          (!sameName || before.GetName() == after.GetName()) &&
          AreParallel(before.Shape.GetPlaced(), after.Shape.GetPlaced(), this->Limit))
        {
          this->Add(before, after, Unchanged, true);
          break;
        }
      }
    }
  }

  /// Returns true if one shape is the other one, rotated; determined once for all instances of two models.
  bool AreCongruent(const Body& before, const Body& after)
  {
    const auto key = std::make_tuple(
      before.Shape.Model, before.Shape.IsMirrored(), after.Shape.Model, after.Shape.IsMirrored());
    const auto [known, isNew] = this->Congruent.emplace(key, false);
    if (isNew)
    {
      known->second = this->ShouldContinue() &&
        MayBeEqual(*before.Shape.Shape, *after.Shape.Shape, this->Limit) &&
        FindRotation(before.Shape.GetPlaced(), after.Shape.GetPlaced(), this->Limit).IsFound;
    }
    return known->second;
  }

  /// Returns the nearest solid of the new file for which `fits` is true and that has no match yet; null if
  /// there is none.
  template <typename Fits>
  Body* FindNearest(const Body& before, const Fits& fits)
  {
    Body* nearest = nullptr;
    double minimum = std::numeric_limits<double>::infinity();
    for (Body& after : this->New)
    {
      const double distance = after.IsDone ? minimum : GetDistance(before, after);
      if (distance < minimum && fits(after))
      {
        nearest = &after;
        minimum = distance;
      }
    }
    return nearest;
  }

  /// Matches equal shapes at different places.
  void MatchShapes(bool sameName)
  {
    for (Body& before : this->Old)
    {
      if (before.IsDone || !before.HasShape() || !this->ShouldContinue())
      {
        continue;
      }
      Body* after = this->FindNearest(before,
        [&](const Body& body)
        {
          return body.HasShape() && (!sameName || before.GetName() == body.GetName()) &&
            this->AreCongruent(before, body);
        });
      if (after)
      {
        // FindRotation() tries a limited number of rotations, so that it may find none although the models
        // are congruent.
        const Rotation rotation =
          FindRotation(before.Shape.GetPlaced(), after->Shape.GetPlaced(), this->Limit);
        this->Add(before, *after, rotation.IsFound ? Moved : Changed, rotation.IsFound, rotation);
      }
    }
  }

  /// Returns true if one solid is the mirror image of the other one; determined once for all instances of two
  /// models, apart from volumes and moments.
  bool AreImages(const Body& before, const Body& after)
  {
    const auto key = std::make_tuple(
      before.Shape.Model, before.Shape.IsMirrored(), after.Shape.Model, after.Shape.IsMirrored());
    const auto [known, isNew] = this->Images.emplace(key, false);
    if (isNew)
    {
      known->second = this->ShouldContinue() &&
        MayBeEqual(*before.Shape.Shape, *after.Shape.Shape, this->Limit) &&
        AreMirrored(before.Shape.GetPlaced(), after.Shape.GetPlaced(), this->Limit);
    }
    return known->second && HaveSameMoments(before.Solid->Values, after.Solid->Values, this->Limit);
  }

  /// Matches solids with their mirror images.
  void MatchMirrors(bool sameName)
  {
    for (Body& before : this->Old)
    {
      if (before.IsDone || !before.HasShape() || !this->ShouldContinue())
      {
        continue;
      }
      Body* after = this->FindNearest(before,
        [&](const Body& body)
        {
          return body.HasShape() && (!sameName || before.GetName() == body.GetName()) &&
            this->AreImages(before, body);
        });
      if (after)
      {
        before.IsDone = after->IsDone = true;
        this->Outcomes.push_back({ &before, after, Mirrored });
      }
    }
  }

  /// Matches different shapes of the same name.
  void MatchNames()
  {
    for (Body& before : this->Old)
    {
      const std::string& name = before.GetName();
      Body* after = before.IsDone || name.empty()
        ? nullptr
        : this->FindNearest(before, [&name](const Body& body) { return body.GetName() == name; });
      if (after)
      {
        this->Add(before, *after, Changed, false);
      }
    }
  }

  /// Matches the only solids of both files.
  void MatchOnly()
  {
    if (this->Old.size() == 1 && this->New.size() == 1 && !this->Old[0].IsDone && !this->New[0].IsDone)
    {
      this->Add(this->Old[0], this->New[0], Changed, false);
    }
  }

  std::function<bool()> ShouldContinue;
  std::vector<Body> Old;
  std::vector<Body> New;
  double Limit;
  double Diagonal;
  std::map<std::tuple<std::size_t, bool, std::size_t, bool>, bool> Congruent;
  std::map<std::tuple<std::size_t, bool, std::size_t, bool>, bool> Images;
  std::vector<Outcome> Outcomes;
};

/// Returns notes on a solid that is in both files: the changes other than that of its place.
std::vector<std::string> MakeNotes(const Outcome& outcome, const std::function<std::string(double)>& format)
{
  std::vector<std::string> notes;
  const SolidResults& before = *outcome.Old->Solid;
  const SolidResults& after = *outcome.New->Solid;
  if (before.Name != after.Name)
  {
    notes.push_back("renamed from " + before.Name);
  }
  for (const Body* body : { outcome.Old, outcome.New })
  {
    if (!body->HasShape())
    {
      notes.push_back("the geometry cannot be compared: " +
        (body->Shape.Shape ? body->Shape.Shape->Problem : std::string("it was not measured")));
    }
  }
  const auto add = [&notes](const char* key, const std::string& old, const std::string& now)
  {
    if (old != now)
    {
      notes.push_back(std::string(key) + " " + old + " -> " + now);
    }
  };
  const auto say = [&format](double density) { return std::isnan(density) ? "none" : format(density); };
  add("density", say(before.Values.Density), say(after.Values.Density));
  add("material", before.Values.Material.empty() ? "none" : before.Values.Material,
    after.Values.Material.empty() ? "none" : after.Values.Material);
  return notes;
}

ComparedBody MakeBody(const Outcome& outcome)
{
  ComparedBody entry;
  entry.OldId = outcome.Old ? outcome.Old->Solid->Id : "";
  entry.NewId = outcome.New ? outcome.New->Solid->Id : "";
  if (outcome.HasSameShape || outcome.State == std::string(Mirrored))
  {
    vtkMath::Subtract(outcome.New->Center.data(), outcome.Old->Center.data(), entry.Translation.data());
    entry.Distance = vtkMath::Norm(entry.Translation.data());
  }
  if (outcome.HasSameShape)
  {
    entry.RotationAngle = vtkMath::DegreesFromRadians(outcome.Rotation.Angle);
    entry.RotationAxis = outcome.Rotation.Axis;
  }
  return entry;
}

/// Returns the number of solids of that name in one of the files.
std::size_t CountInstances(
  const std::vector<Outcome>& outcomes, const std::string& name, const Body* Outcome::*side)
{
  return static_cast<std::size_t>(std::count_if(outcomes.begin(), outcomes.end(),
    [&](const Outcome& outcome) { return outcome.*side && (outcome.*side)->GetName() == name; }));
}

/// Common properties of the solids of one part.
using PartKey = std::tuple<std::size_t, std::string, std::string, std::size_t, std::size_t>;

PartKey GetKey(const Outcome& outcome)
{
  const auto none = std::numeric_limits<std::size_t>::max();
  const auto state = std::find(std::begin(States), std::end(States), std::string(outcome.State));
  const auto getName = [](const Body* body) { return body ? body->GetName() : std::string(); };
  return { static_cast<std::size_t>(state - std::begin(States)), getName(outcome.New), getName(outcome.Old),
    outcome.Old ? outcome.Old->Shape.Model : none, outcome.New ? outcome.New->Shape.Model : none };
}

std::vector<ComparedPart> MakeParts(
  const std::vector<Outcome>& outcomes, const std::function<std::string(double)>& format)
{
  std::map<PartKey, std::vector<const Outcome*>> groups;
  for (const Outcome& outcome : outcomes)
  {
    groups[GetKey(outcome)].push_back(&outcome);
  }
  std::vector<ComparedPart> parts;
  for (const auto& [key, group] : groups)
  {
    const Outcome& first = *group.front();
    ComparedPart part;
    part.State = first.State;
    part.Name = (first.New ? first.New : first.Old)->GetName();
    part.OldName = first.Old ? std::optional(first.Old->GetName()) : std::nullopt;
    part.InOld = CountInstances(outcomes, (first.Old ? first.Old : first.New)->GetName(), &Outcome::Old);
    part.InNew = CountInstances(outcomes, part.Name, &Outcome::New);
    if (first.Old && first.New)
    {
      part.Notes = MakeNotes(first, format);
      part.Difference = MakeDifferences(first.Old->Solid->Values, first.New->Solid->Values);
    }
    for (const Outcome* outcome : group)
    {
      part.Bodies.push_back(MakeBody(*outcome));
    }
    parts.push_back(std::move(part));
  }
  return parts;
}
}

void ProductDifference::Visit(Fields& fields)
{
  std::optional<bool> isEqual = this->IsEqual;
  fields.Note("", "true: all solids are unchanged").Flag("equal", isEqual);
  fields.Note("1", "of `--compare-limit`").Number("limit", this->Limit);
  fields.Text("length_unit", this->LengthUnit);
  fields.Note("", "number of solids by their state").Begin("counts");
  for (const auto& [state, number] : this->Counts)
  {
    auto count = static_cast<long long>(number);
    fields.Count(state, count);
  }
  fields.End();
  fields.Note("", "differences of all solids together").Begin("total");
  sm::Visit(fields, this->Total);
  fields.End();
  fields.Note("", "a part has all solids of one state, name and shape")
    .List("parts", this->Parts, [&fields](ComparedPart& part) { sm::Visit(fields, part); });
}

std::optional<ProductDifference> CompareProducts(const ProductResults& before, const ProductShapes& oldShapes,
  const ProductResults& after, const ProductShapes& newShapes, double limit,
  const std::function<std::string(double)>& format, const std::function<bool()>& shouldContinue)
{
  Comparison comparison(ListEntries(before, oldShapes), ListEntries(after, newShapes), limit,
    GetLargerDiagonal(before, after), shouldContinue);
  const std::vector<Outcome> outcomes = comparison.Run();
  if (!shouldContinue())
  {
    return std::nullopt;
  }
  ProductDifference result;
  for (const char* state : States)
  {
    const auto count = std::count_if(outcomes.begin(), outcomes.end(),
      [state](const Outcome& outcome) { return outcome.State == std::string(state); });
    result.Counts.emplace_back(state, static_cast<std::size_t>(count));
    result.IsEqual = result.IsEqual ||
      (state == std::string(Unchanged) && static_cast<std::size_t>(count) == outcomes.size());
  }
  result.Limit = limit;
  result.LengthUnit = after.LengthUnit;
  result.Total = MakeDifferences(before.Total, after.Total);
  result.Parts = MakeParts(outcomes, format);
  return result;
}
}
