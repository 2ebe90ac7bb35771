#include "Detail/smMirroredTwins.h"

#include "Detail/smTotalMass.h"
#include "smFormat.h"
#include "smMassIntegrands.h"
#include "smPartMatch.h"
#include "smPartShape.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace sm
{
namespace
{
/// Relative tolerance of the integrals of shapes, and relative difference of equal ones.
constexpr double TwinTolerance = 1e-12;
constexpr double TwinLimit = 1e-9;
/// Largest number of shapes without a material that are compared: the integrals of each take seconds.
constexpr std::size_t MaxTwins = 1000;
/// Largest number of pairs of shapes that are compared by their faces, which takes about 10 s.
constexpr std::size_t MaxTwinPairs = 100000;

bool AreNearlyEqual(const BodyIntegrals& a, const BodyIntegrals& b, int integrand)
{
  const double x = std::abs(a.Value[integrand]);
  const double y = std::abs(b.Value[integrand]);
  return std::abs(x - y) <= a.Bound[integrand] + b.Bound[integrand] + TwinLimit * std::max(x, y);
}

/// Returns true if numbers that are known already do not distinguish two solids.
bool MayBeTwins(const BodyIntegrals& a, const BodyIntegrals& b)
{
  return a.Faces && b.Faces && a.IsSolid() && b.IsSolid() && a.Faces->size() == b.Faces->size() &&
    AreNearlyEqual(a, b, MassVolume) && AreNearlyEqual(a, b, MassArea);
}

std::string Describe(const Material& material)
{
  const std::string weight = material.Mass > 0.0 ? FormatDigits(material.Mass, 10) + " kg"
                                                 : FormatDigits(material.Density, 10) + " kg/m^3";
  return (material.Name.empty() ? "" : material.Name + ", ") + weight;
}

/// The solids of one model in placements of one hand, and with one material.
struct TwinGroup
{
  std::vector<const BodyIntegrals*> Solids;
  sm::Material Material;

  const BodyIntegrals& GetFirst() const { return *this->Solids.front(); }

  /// Returns "bolt", or "bolt and 2 more solids of its shape".
  std::string GetLabel() const
  {
    const std::size_t more = this->Solids.size() - 1;
    return this->GetFirst().GetLabel() +
      (more == 0 ? std::string()
                 : " and " + FormatCount(more, "more solid", "more solids") + " of its shape");
  }
};

bool IsMirrored(const BodyIntegrals& body)
{
  const auto& m = body.Placement;
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
    m[2] * (m[4] * m[9] - m[5] * m[8]) <
    0.0;
}

/// Collects solids in groups, in the order of their first ones.
class TwinGroups
{
public:
  void Add(const BodyIntegrals& body, const Material& material)
  {
    // Solids that were not integrated in time have nothing to compare, and form a group of their own.
    const auto key = std::make_tuple(body.Model.GetPointer(), IsMirrored(body), body.Faces == nullptr,
      material.Name, material.Density, material.Mass, material.Tolerance);
    const auto [found, isNew] = this->Indices.emplace(key, this->List.size());
    if (isNew)
    {
      this->List.push_back({ {}, material });
    }
    this->List[found->second].Solids.push_back(&body);
  }
  const std::vector<TwinGroup>& Get() const { return this->List; }

private:
  using Key = std::tuple<vtkTrimmedNURBSModel*, bool, bool, std::string, double, double, double>;
  std::map<Key, std::size_t> Indices;
  std::vector<TwinGroup> List;
};

/// Shapes of models, each measured once, about their centres.
class ShapeStore
{
public:
  /// `maximumSeconds`: 0 for no limit.
  explicit ShapeStore(double maximumSeconds)
    : MaximumSeconds(maximumSeconds)
  {
  }

  PartShape GetPlaced(const BodyIntegrals& body)
  {
    vtkTrimmedNURBSModel* const model = body.Model;
    const auto [found, isNew] = this->Shapes.try_emplace(model);
    if (isNew)
    {
      found->second = MeasureShapes({ model }, TwinTolerance, this->GetSecondsLeft()).at(0);
      found->second.Center();
    }
    PartShape placed = found->second;
    placed.Place(body.Placement.data());
    return placed;
  }

private:
  double GetSecondsLeft() const
  {
    const std::chrono::duration<double> past = Clock::now() - this->Start;
    return this->MaximumSeconds > 0.0 ? std::max(this->MaximumSeconds - past.count(), 1e-3) : 0.0;
  }

  using Clock = std::chrono::steady_clock;
  double MaximumSeconds;
  Clock::time_point Start = Clock::now();
  std::map<vtkTrimmedNURBSModel*, PartShape> Shapes;
};

/// Compares groups, each pair once.
class TwinSearch
{
public:
  TwinSearch(double maximumSeconds, std::function<bool()> shouldContinue)
    : Shapes(maximumSeconds)
    , ShouldContinue(std::move(shouldContinue))
  {
  }

  /// Returns true until the time, the run or the number of pairs has ended.
  bool Continues()
  {
    this->Stop = !this->Stop.empty() ? this->Stop
      : this->Pairs >= MaxTwinPairs
      ? "there are more than " + std::to_string(MaxTwinPairs) + " pairs of shapes"
      : !this->ShouldContinue() ? std::string("the time is over, or the run was ended")
                                : std::string();
    return this->Stop.empty();
  }
  const std::string& GetStop() const { return this->Stop; }

  /// Finds the twins of one group among those that rules name. Returns a message; empty if there is none, or
  /// if the search has ended before it was complete.
  std::string Find(const TwinGroup& group, const std::vector<TwinGroup>& named, MassAnalysisOptions& options)
  {
    const TwinGroup* twin = nullptr;
    const BodyIntegrals& body = group.GetFirst();
    for (const TwinGroup& other : named)
    {
      if ((twin && AreEqual(other.Material, twin->Material)) || !MayBeTwins(body, other.GetFirst()))
      {
        continue;
      }
      if (!this->Continues())
      {
        return {};
      }
      ++this->Pairs;
      if (!AreMirrored(this->Shapes.GetPlaced(body), this->Shapes.GetPlaced(other.GetFirst()), TwinLimit))
      {
        continue;
      }
      if (twin)
      {
        return group.GetLabel() + (group.Solids.size() > 1 ? " are" : " is") + " the mirror image of " +
          twin->GetFirst().GetLabel() + " and of " + other.GetFirst().GetLabel() +
          ", whose materials differ: " +
          (group.Solids.size() > 1 ? "they get none; add them" : "it gets none; add it") +
          " to the materials";
      }
      twin = &other;
    }
    return twin && this->Continues() ? Take(group, *twin, options) : std::string();
  }

private:
  static bool AreEqual(const Material& a, const Material& b)
  {
    return a.Name == b.Name && a.Density == b.Density && a.Mass == b.Mass && a.Tolerance == b.Tolerance;
  }

  /// Gives the solids of a group the material of their twin. Returns a message.
  static std::string Take(const TwinGroup& group, const TwinGroup& twin, MassAnalysisOptions& options)
  {
    for (const BodyIntegrals* body : group.Solids)
    {
      options.Twins[body->Id] = twin.Material;
    }
    return group.GetLabel() +
      (group.Solids.size() > 1 ? " have no line of their own in the materials and get that of their"
                               : " has no line of its own in the materials and gets that of its") +
      " mirror image " + twin.GetFirst().GetLabel() +
      ", found by comparing all faces: " + Describe(twin.Material);
  }

  ShapeStore Shapes;
  std::function<bool()> ShouldContinue;
  std::size_t Pairs = 0;
  std::string Stop;
};
}

std::vector<std::string> FindMirroredTwins(const std::vector<BodyIntegrals>& bodies,
  const IntegralLimits& limits, const RunReport& report, const std::function<bool()>& shouldContinue,
  MassAnalysisOptions& options)
{
  const double left = limits.MaximumSeconds - report.PrepareSeconds - report.IntegrateSeconds;
  TwinGroups named;
  TwinGroups unnamed;
  for (const BodyIntegrals& body : bodies)
  {
    const Material own = ChooseMaterial(body, options);
    if (FindRule(options.Materials, body.Name))
    {
      named.Add(body, own);
    }
    else if (!own.HasMass() && own.Name.empty())
    {
      unnamed.Add(body, own);
    }
  }
  std::vector<std::string> messages;
  TwinSearch search(limits.MaximumSeconds > 0.0 ? std::max(left, 1e-3) : 0.0, shouldContinue);
  std::size_t missed = 0;
  const std::vector<TwinGroup>& groups = unnamed.Get();
  for (std::size_t i = 0; i < groups.size() && !named.Get().empty(); ++i)
  {
    const std::string message =
      i < MaxTwins && search.GetStop().empty() ? search.Find(groups[i], named.Get(), options) : std::string();
    const bool isComplete = i < MaxTwins && search.GetStop().empty();
    missed += isComplete ? 0 : groups[i].Solids.size();
    if (isComplete && !message.empty())
    {
      messages.push_back(message);
    }
  }
  if (missed > 0)
  {
    messages.push_back(FormatCount(missed, "solid", "solids") +
      " without a material were not compared with those of the materials, whose mirror images they may be: " +
      (search.GetStop().empty() ? "there are more than " + std::to_string(MaxTwins) + " shapes"
                                : search.GetStop()) +
      "; add them to the materials");
  }
  return messages;
}
}
