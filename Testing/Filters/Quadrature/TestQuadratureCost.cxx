// TestQuadratureCost FOLDER [FILE...]: how many points the plans of exact solids take at a tolerance of 1e-9,
// against the fewest that would do: for each panel the cheapest pair of orders whose true error, known in
// extended precision, is within the panel's share. With volume and moments alone, and with the area. Bent
// patches that have normals everywhere get bounds, not comparisons, however many halvings they take.
#include "smReferencePanels.h"
#include "smTestManifest.h"
#include "smTesting.h"

#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSTEPReader.h>
#include <vtkTrimmedNURBSModel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace
{
using namespace smtest;

constexpr double RelativeTolerance = 1e-9;
// Panels of a solid that are looked at, evenly spread: the search for the minimum costs thousands of
// evaluations each.
constexpr std::size_t PanelsOfASolid = 10;

struct Cost
{
  std::int64_t Planned = 0;
  std::int64_t Minimum = 0;
};

/// Fewest points whose error is within the tolerances.
std::int64_t FindMinimum(
  const ReferencePanels& reference, const sm::PlannedItem& item, const std::vector<double>& tolerances)
{
  const Values exact = reference.IntegrateFinely(item);
  const auto meets = [&](int along, int across)
  {
    const Values rule = reference.Integrate(item, along, across);
    for (int k = 0; k < Count; ++k)
    {
      if (tolerances[k] > 0.0 && std::abs(rule[k] - exact[k]) > tolerances[k] * item.Share)
      {
        return false;
      }
    }
    return true;
  };
  std::int64_t minimum = static_cast<std::int64_t>(item.Along) * item.Across;
  for (int along = 1; along <= item.Along; ++along)
  {
    for (int across = 1; across <= item.Across && static_cast<std::int64_t>(along) * across < minimum;
         ++across)
    {
      if (meets(along, across))
      {
        minimum = static_cast<std::int64_t>(along) * across;
      }
    }
  }
  return minimum;
}

Cost Measure(vtkTrimmedNURBSModel* model, const Expected& solid, bool withArea)
{
  const double length = std::cbrt(solid.Volume);
  const double faces = static_cast<double>(model->GetNumberOfFaces());
  const double t = RelativeTolerance / faces;
  sm::PlanRequest request;
  request.Classes = Classes;
  request.Tolerances = { t * solid.Volume, t * solid.Volume * length, t * solid.Volume * length * length,
    t * length * length, withArea ? t * solid.Area : 0.0 };
  Cost cost;
  for (const sm::FacePointer& face : model->GetFaces())
  {
    const sm::FacePanels panels = sm::BuildFacePanels(*face);
    const sm::FacePlan plan = sm::PlanFace(*face, panels, request);
    std::vector<const sm::PlannedItem*> items;
    for (const sm::PlannedItem& item : plan.Items)
    {
      if (item.Kind == sm::ItemKind::Panel && !item.Compared)
      {
        items.push_back(&item);
      }
    }
    std::vector<double> shares = request.Tolerances;
    for (int k = 0; k < Count; ++k)
    {
      const bool area = Classes[k].Kind == sm::BoundClass::AreaMoment;
      shares[k] /= static_cast<double>(
        std::max<std::size_t>(1, panels.Panels.size() + (area ? 0 : panels.Ribbons.size())));
    }
    const std::size_t step = 1 + items.size() * static_cast<std::size_t>(faces) / PanelsOfASolid;
    const ReferencePanels reference(panels);
    for (std::size_t i = 0; i < items.size(); i += step)
    {
      cost.Planned += static_cast<std::int64_t>(items[i]->Along) * items[i]->Across;
      cost.Minimum += FindMinimum(reference, *items[i], shares);
    }
  }
  return cost;
}

/// Bicubic patches near the unit square: halved some five times in both directions until their normals are
/// distinguished from zero.
void CheckBentPatches()
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> spread(-0.13, 0.13);
  int estimated = 0;
  std::size_t items = 0;
  for (int n = 0; n < 40; ++n)
  {
    sm::Face face;
    sm::NURBSSurface& s = face.Surface;
    for (int d = 0; d < 2; ++d)
    {
      s.Degree[d] = 3;
      s.Knots[d] = { 0, 0, 0, 0, 1, 1, 1, 1 };
      s.NumberOfControlPoints[d] = 4;
    }
    for (int k = 0; k < 16; ++k)
    {
      const double x = k % 4 / 3.0 + spread(random);
      const double y = k / 4 / 3.0 + spread(random);
      s.ControlPoints.push_back({ x, y, 3.0 * spread(random), 1.0 });
    }
    const sm::FacePanels panels = sm::BuildFacePanels(face);
    sm::PlanRequest request;
    request.Classes = Classes;
    request.Tolerances.assign(Count, 1e-6);
    const sm::FacePlan plan = sm::PlanFace(face, panels, request);
    estimated += plan.Estimated ? 1 : 0;
    items = std::max(items, plan.Items.size());
  }
  CheckEqual("bent patches whose area is estimated", 0, estimated);
  CheckRange("items of the one that takes most", 30.0, static_cast<double>(items), 100.0);
}
}

int TestQuadratureCost(int argc, char* argv[])
{
  if (argc != 2)
  {
    return 2;
  }
  const Manifest manifest(argv[1]);
  Cost sums[2];
  for (const char* name : { "box", "cylinder", "cone", "sphere", "torus", "slanted_hole", "ellipsoid",
         "airfoil", "spline_ring", "wavy_plate" })
  {
    for (const Expected& solid : manifest.GetSolid(name, "plain"))
    {
      vtkNew<vtkSTEPReader> reader;
      reader->SetFileName(solid.Path.c_str());
      reader->Update();
      auto* leaf = vtkNURBSDataSet::SafeDownCast(
        vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0))
          ->GetPartitionAsDataObject(0, 0));
      if (!CheckTrue(std::string(name) + " is read", leaf != nullptr))
      {
        continue;
      }
      for (const bool withArea : { false, true })
      {
        const Cost cost = Measure(leaf->GetModel(), solid, withArea);
        sums[withArea].Planned += cost.Planned;
        sums[withArea].Minimum += cost.Minimum;
        std::printf("%-14s %-26s planned %6lld minimum %6lld ratio %.2f\n", name,
          withArea ? "with the area" : "volume and moments", static_cast<long long>(cost.Planned),
          static_cast<long long>(cost.Minimum), static_cast<double>(cost.Planned) / cost.Minimum);
      }
    }
  }
  for (const bool withArea : { false, true })
  {
    CheckRange(
      withArea ? "points over the minimum, with the area" : "points over the minimum, volume and moments",
      1.0, static_cast<double>(sums[withArea].Planned) / sums[withArea].Minimum, withArea ? 6.0 : 3.0);
  }
  CheckBentPatches();
  return Finish();
}
