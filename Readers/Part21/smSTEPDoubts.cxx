#include "smSTEPDoubts.h"

#include "smSTEPFrames.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

namespace sm
{
namespace
{
using Index = Part21File::Index;

/// The parameters of a simple CARTESIAN_TRANSFORMATION_OPERATOR_3D behind its names: two axes, origin, scale,
/// third axis.
constexpr std::size_t OperatorParameters = 5;
constexpr std::size_t AxesOfOperator[] = { 0, 1, 4 };

/// Geometry that does not depend on the x axis of its placement, unless it is trimmed by parameters.
constexpr std::string_view Round[] = { "PLANE", "CYLINDRICAL_SURFACE", "CONICAL_SURFACE", "SPHERICAL_SURFACE",
  "TOROIDAL_SURFACE", "DEGENERATE_TOROIDAL_SURFACE", "CIRCLE" };
constexpr std::string_view Trimming[] = { "TRIMMED_CURVE", "RECTANGULAR_TRIMMED_SURFACE" };

class DoubtFinder
{
public:
  explicit DoubtFinder(const STEPAttributes& entities)
    : Entities(entities)
    , File(entities.File)
  {
  }

  std::vector<STEPDoubt> Find()
  {
    for (Index i = 0; i < this->File.GetNumberOfInstances(); ++i)
    {
      const std::uint64_t roles = this->File.IsDamaged(i) ? 0 : this->Entities.GetRoles(i);
      if (roles & STEPRole::Placement)
      {
        this->CheckPlacement(i);
      }
      else if (roles & STEPRole::Transformation)
      {
        this->CheckOperator(i);
      }
    }
    this->ReportParallel();
    std::sort(this->Doubts.begin(), this->Doubts.end(),
      [](const STEPDoubt& a, const STEPDoubt& b) { return a.Id < b.Id; });
    return std::move(this->Doubts);
  }

private:
  template <std::size_t Count>
  bool IsOneOf(Index i, const std::string_view (&types)[Count]) const
  {
    return !this->File.IsComplex(i) && !this->File.IsDamaged(i) &&
      std::find(std::begin(types), std::end(types), this->File.GetTypeNames()[this->File.GetType(i)]) !=
      std::end(types);
  }

  void CheckPlacement(Index i)
  {
    Vector3 z = { 0.0, 0.0, 1.0 };
    Vector3 reference{};
    Vector3 x{};
    const Part21Value axis = this->Entities.Get(i, AxisOfPlacement);
    const bool hasAxis =
      axis.Kind == Part21Kind::Omitted || ReadSTEPDirection(this->Entities, this->Entities.Follow(axis), z);
    if (hasAxis &&
      ReadSTEPDirection(
        this->Entities, this->Entities.Follow(this->Entities.Get(i, ReferenceOfPlacement)), reference) &&
      !ProjectFirstAxis(z, &reference, x))
    {
      this->Parallel.insert(i);
    }
  }

  void CheckOperator(Index i)
  {
    constexpr std::string_view types[] = { "CARTESIAN_TRANSFORMATION_OPERATOR_3D" };
    if (!this->IsOneOf(i, types))
    {
      return;
    }
    std::vector<Part21Value> values;
    Part21Values parameters(this->File.GetParameters(i));
    for (Part21Value value; parameters.Next(value);)
    {
      values.push_back(value);
    }
    std::array<Vector3, 3> read{};
    std::array<const Vector3*, 3> given{};
    std::array<Vector3, 3> axes{};
    for (std::size_t k = 0; k < 3 && values.size() >= OperatorParameters; ++k)
    {
      const Part21Value& value = values[values.size() - OperatorParameters + AxesOfOperator[k]];
      if (ReadSTEPDirection(this->Entities, this->Entities.Follow(value), read[k]))
      {
        given[k] = &read[k];
      }
    }
    if (!MakeBaseAxes(given, axes))
    {
      this->Doubts.push_back(
        { this->File.GetId(i), "an axis of the operator, or its default, is parallel to another one" });
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
      for (const Index to : this->File.GetReferences(i))
      {
        if (this->Parallel.count(to) > 0 && this->IsOneOf(i, Round))
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
      for (const Index to : this->File.GetReferences(i))
      {
        const auto found = round.find(to);
        if (found != round.end() && this->IsOneOf(i, Trimming))
        {
          needed.insert(found->second);
        }
      }
    }
    for (const Index i : needed)
    {
      this->Doubts.push_back({ this->File.GetId(i),
        "its reference direction is parallel to its axis, so that its x axis is not known" });
    }
  }

  const STEPAttributes& Entities;
  const Part21File& File;
  std::vector<STEPDoubt> Doubts;
  std::unordered_set<Index> Parallel;
};
}

std::vector<STEPDoubt> FindSTEPDoubts(const STEPAttributes& entities)
{
  return DoubtFinder(entities).Find();
}
}
