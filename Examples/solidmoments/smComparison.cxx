#include "smComparison.h"

#include "smPartMatch.h"
#include "smProductShapes.h"

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
/// Unit roundoff 2^-53: bound of the relative error of one operation, rounded to nearest.
constexpr double Roundoff = 1.1102230246251565e-16;

using namespace states;
/// The states in the order of the list.
constexpr const char* States[] = { Changed, Moved, Added, Removed, Unchanged };

/// Returns new - old of numbers, or of nested arrays of them; null where one is missing.
Json Subtract(const Json& before, const Json& after)
{
  if (before.is_number() && after.is_number())
  {
    return after.get<double>() - before.get<double>();
  }
  Json result;
  for (std::size_t i = 0; before.is_array() && after.is_array() && i < before.size(); ++i)
  {
    result.push_back(Subtract(before[i], after[i]));
  }
  return result;
}

double GetLargest(const Json& value)
{
  double largest = value.is_number() ? std::abs(value.get<double>()) : 0.0;
  for (const Json& entry : value.is_array() ? value : Json::array())
  {
    largest = std::max(largest, GetLargest(entry));
  }
  return largest;
}

/// Returns the difference of a quantity. Its bound is the sum of both bounds and of the rounding of the subtraction.
Json MakeDifference(const Json& before, const Json& after, const char* quantity)
{
  const Json& a = before["bounds"][quantity];
  const Json& b = after["bounds"][quantity];
  Json difference = { { "old", before[quantity] }, { "new", after[quantity] },
    { "difference", Subtract(before[quantity], after[quantity]) }, { "bound", nullptr } };
  if (!difference["difference"].is_null() && a.is_number() && b.is_number())
  {
    difference["bound"] = (a.get<double>() + b.get<double>()) * (1.0 + 4.0 * Roundoff) +
      Roundoff * GetLargest(difference["difference"]);
  }
  return difference;
}

Json MakeDifferences(const Json& before, const Json& after)
{
  Json differences;
  for (const char* quantity :
    { "volume", "area", "center_of_mass", "inertia", "mass", "mass_center", "mass_inertia" })
  {
    differences[quantity] = MakeDifference(before, after, quantity);
  }
  return differences;
}

/// Returns true if a quantity differs by more than the bounds and the limit.
bool IsOther(const Json& before, const Json& after, const char* quantity, double limit)
{
  const Json difference = MakeDifference(before, after, quantity);
  if (difference["difference"].is_null())
  {
    return before[quantity].is_null() != after[quantity].is_null();
  }
  const double scale = std::max(GetLargest(before[quantity]), GetLargest(after[quantity]));
  const double bound = difference["bound"].is_number() ? difference["bound"].get<double>() : 0.0;
  return !(GetLargest(difference["difference"]) <= bound + limit * scale);
}

/// Returns true if material, density or mass of two equal shapes differ. Densities are no results and have no bounds.
bool HasOtherMaterial(const Json& before, const Json& after, double limit)
{
  const Json& a = before["density"];
  const Json& b = after["density"];
  return before["material"] != after["material"] || a.is_null() != b.is_null() ||
    (a.is_number() && !(GetLargest(Subtract(a, b)) <= limit * GetLargest(a))) ||
    IsOther(before, after, "mass", limit);
}

/// A solid of one of the files.
struct Body
{
  const Json* Solid;
  SolidShape Shape;
  std::array<double, 3> Center{};
  bool IsDone = false;

  std::string GetName() const { return (*this->Solid)["name"].get<std::string>(); }
  bool HasShape() const { return this->Shape.Shape && this->Shape.Shape->Problem.empty(); }
};

std::vector<Body> ListEntries(const Json& file)
{
  std::map<std::string, SolidShape> shapes = ReadShapes(file[ShapesKey]);
  std::vector<Body> bodies;
  for (const Json& solid : file["solids"])
  {
    Body body{ &solid, shapes[solid["id"].get<std::string>()] };
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

class Comparison
{
public:
  Comparison(const Json& oldFile, const Json& newFile, double limit, std::function<bool()> shouldContinue)
    : ShouldContinue(std::move(shouldContinue))
    , Old(ListEntries(oldFile))
    , New(ListEntries(newFile))
    , Limit(limit)
    , Diagonal(std::max(GetLargest(oldFile["diagonal"]), GetLargest(newFile["diagonal"])))
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
    this->MatchNames();
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
    const Json& a = *before.Solid;
    const Json& b = *after.Solid;
    const bool isOther = hasSameShape && HasOtherMaterial(a, b, this->Limit);
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
      const double least = before.Center[0] - slack;
      auto next = std::partition_point(
        sorted.begin(), sorted.end(), [least](const Body* body) { return body->Center[0] < least; });
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

  /// Returns the nearest solid of the new file for which `fits` is true and that has no match yet; null if there is none.
  template <typename Fits>
  Body* FindNearest(const Body& before, const Fits& fits)
  {
    Body* nearest = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (Body& after : this->New)
    {
      const double distance = after.IsDone ? least : GetDistance(before, after);
      if (distance < least && fits(after))
      {
        nearest = &after;
        least = distance;
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
        // FindRotation() tries a limited number of rotations, so that it may find none although the models are congruent.
        const Rotation rotation =
          FindRotation(before.Shape.GetPlaced(), after->Shape.GetPlaced(), this->Limit);
        this->Add(before, *after, rotation.IsFound ? Moved : Changed, rotation.IsFound, rotation);
      }
    }
  }

  /// Matches different shapes of the same name, or the only solids of both files.
  void MatchNames()
  {
    for (Body& before : this->Old)
    {
      const bool isOnly = this->Old.size() == 1 && this->New.size() == 1;
      const std::string name = before.GetName();
      Body* after = before.IsDone || (name.empty() && !isOnly)
        ? nullptr
        : this->FindNearest(before, [&](const Body& body) { return isOnly || body.GetName() == name; });
      if (after)
      {
        this->Add(before, *after, Changed, false);
      }
    }
  }

  std::function<bool()> ShouldContinue;
  std::vector<Body> Old;
  std::vector<Body> New;
  double Limit;
  double Diagonal;
  std::map<std::tuple<std::size_t, bool, std::size_t, bool>, bool> Congruent;
  std::vector<Outcome> Outcomes;
};

/// Returns notes on a solid that is in both files: the changes other than that of its place.
Json MakeNotes(const Outcome& outcome)
{
  Json notes = Json::array();
  const Json& before = *outcome.Old->Solid;
  const Json& after = *outcome.New->Solid;
  if (before["name"] != after["name"])
  {
    notes.push_back("renamed from " + outcome.Old->GetName());
  }
  for (const Body* body : { outcome.Old, outcome.New })
  {
    if (!body->HasShape())
    {
      notes.push_back("the geometry cannot be compared: " +
        (body->Shape.Shape ? body->Shape.Shape->Problem : std::string("it was not measured")));
    }
  }
  const auto say = [](const Json& value) {
    return value.is_string() ? value.get<std::string>() : value.is_null() ? "none" : Dump(value);
  };
  for (const char* key : { "density", "material" })
  {
    if (before[key] != after[key])
    {
      notes.push_back(std::string(key) + " " + say(before[key]) + " -> " + say(after[key]));
    }
  }
  return notes;
}

Json MakeBody(const Outcome& outcome)
{
  const auto getId = [](const Body* body) { return body ? (*body->Solid)["id"] : Json(); };
  Json entry = { { "old_id", getId(outcome.Old) }, { "new_id", getId(outcome.New) },
    { "translation", nullptr }, { "distance", nullptr }, { "rotation_angle", nullptr },
    { "rotation_axis", nullptr } };
  if (outcome.HasSameShape)
  {
    std::array<double, 3> shift;
    vtkMath::Subtract(outcome.New->Center.data(), outcome.Old->Center.data(), shift.data());
    entry["translation"] = shift;
    entry["distance"] = vtkMath::Norm(shift.data());
    entry["rotation_angle"] = vtkMath::DegreesFromRadians(outcome.Rotation.Angle);
    entry["rotation_axis"] = outcome.Rotation.Axis;
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

Json MakeParts(const std::vector<Outcome>& outcomes)
{
  std::map<PartKey, std::vector<const Outcome*>> groups;
  for (const Outcome& outcome : outcomes)
  {
    groups[GetKey(outcome)].push_back(&outcome);
  }
  Json parts = Json::array();
  for (const auto& [key, group] : groups)
  {
    const Outcome& first = *group.front();
    const auto getName = [](const Body* body) { return body ? Json(body->GetName()) : Json(); };
    Json part;
    part["state"] = first.State;
    part["name"] = getName(first.New ? first.New : first.Old);
    part["old_name"] = getName(first.Old);
    part["count"] = group.size();
    part["in_old"] = CountInstances(outcomes, (first.Old ? first.Old : first.New)->GetName(), &Outcome::Old);
    part["in_new"] = CountInstances(outcomes, (first.New ? first.New : first.Old)->GetName(), &Outcome::New);
    part["notes"] = first.Old && first.New ? MakeNotes(first) : Json::array();
    part["difference"] =
      first.Old && first.New ? MakeDifferences(*first.Old->Solid, *first.New->Solid) : Json();
    part["bodies"] = Json::array();
    for (const Outcome* outcome : group)
    {
      part["bodies"].push_back(MakeBody(*outcome));
    }
    parts.push_back(std::move(part));
  }
  return parts;
}
}

Json CompareProducts(
  const Json& oldFile, const Json& newFile, double limit, const std::function<bool()>& shouldContinue)
{
  Comparison comparison(oldFile, newFile, limit, shouldContinue);
  const std::vector<Outcome> outcomes = comparison.Run();
  if (!shouldContinue())
  {
    return {};
  }
  Json counts;
  for (const char* state : States)
  {
    counts[state] = std::count_if(outcomes.begin(), outcomes.end(),
      [state](const Outcome& outcome) { return outcome.State == std::string(state); });
  }
  Json result;
  result["equal"] = counts[Unchanged] == outcomes.size();
  result["limit"] = limit;
  result["length_unit"] = newFile["length_unit"];
  result["counts"] = std::move(counts);
  result["total"] = MakeDifferences(oldFile["total"], newFile["total"]);
  result["parts"] = MakeParts(outcomes);
  return result;
}
}
