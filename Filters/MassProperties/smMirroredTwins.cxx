#include "Detail/smMirroredTwins.h"

#include "Detail/smTotalMass.h"
#include "smFormat.h"
#include "smMassIntegrands.h"
#include "smPartMatch.h"
#include "smPartShape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace sm
{
namespace
{
/// Relative tolerance of the integrals of shapes, and relative difference of equal ones.
constexpr double TwinTolerance = 1e-12;
constexpr double TwinLimit = 1e-9;
/// Largest number of solids without a material that are compared: the integrals of each take seconds.
constexpr std::size_t MaxTwins = 1000;

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

std::string GetTwinLabel(const BodyIntegrals& body)
{
  return body.Name.empty() ? "solid " + body.Id : body.Name;
}

std::string Describe(const Material& material)
{
  const std::string weight = material.Mass > 0.0 ? FormatDigits(material.Mass, 10) + " kg"
                                                 : FormatDigits(material.Density, 10) + " kg/m^3";
  return (material.Name.empty() ? "" : material.Name + ", ") + weight;
}

/// Shapes of models, each measured once, about their centres.
class ShapeStore
{
public:
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
      found->second = MeasureShapes({ model }, TwinTolerance, this->MaximumSeconds).at(0);
      found->second.Center();
    }
    PartShape placed = found->second;
    placed.Place(body.Placement.data());
    return placed;
  }

private:
  double MaximumSeconds;
  std::map<vtkTrimmedNURBSModel*, PartShape> Shapes;
};

/// Finds the twins of one solid among those that rules name. Returns a message; empty if there is none.
std::string FindTwin(const BodyIntegrals& body, const std::vector<const BodyIntegrals*>& named,
  ShapeStore& shapes, MassAnalysisOptions& options)
{
  const BodyIntegrals* twin = nullptr;
  Material material;
  for (const BodyIntegrals* other : named)
  {
    const Material its = ChooseMaterial(*other, options);
    const bool isSame = twin && its.Name == material.Name && its.Density == material.Density &&
      its.Mass == material.Mass && its.Tolerance == material.Tolerance;
    if (isSame || !MayBeTwins(body, *other) ||
      !AreMirrored(shapes.GetPlaced(body), shapes.GetPlaced(*other), TwinLimit))
    {
      continue;
    }
    if (twin)
    {
      return GetTwinLabel(body) + " is the mirror image of " + GetTwinLabel(*twin) + " and of " +
        GetTwinLabel(*other) + ", whose materials differ: it gets none; add it to the materials";
    }
    twin = other;
    material = its;
  }
  if (!twin)
  {
    return {};
  }
  options.Twins[body.Id] = material;
  return GetTwinLabel(body) + " has no line of its own in the materials and gets that of its mirror image " +
    GetTwinLabel(*twin) + ", found by comparing all faces: " + Describe(material);
}
}

std::vector<std::string> FindMirroredTwins(const std::vector<BodyIntegrals>& bodies,
  const IntegralLimits& limits, const RunReport& report, MassAnalysisOptions& options)
{
  const double left = limits.MaximumSeconds - report.PrepareSeconds - report.IntegrateSeconds;
  std::vector<const BodyIntegrals*> named;
  std::vector<const BodyIntegrals*> unnamed;
  for (const BodyIntegrals& body : bodies)
  {
    if (FindRule(options.Materials, body.Name))
    {
      named.push_back(&body);
    }
    else if (const Material own = ChooseMaterial(body, options); !own.HasMass() && own.Name.empty())
    {
      unnamed.push_back(&body);
    }
  }
  std::vector<std::string> messages;
  ShapeStore shapes(limits.MaximumSeconds > 0.0 ? std::max(left, 1e-3) : 0.0);
  for (std::size_t i = 0; i < std::min(unnamed.size(), MaxTwins) && !named.empty(); ++i)
  {
    const std::string message = FindTwin(*unnamed[i], named, shapes, options);
    if (!message.empty())
    {
      messages.push_back(message);
    }
  }
  return messages;
}
}
