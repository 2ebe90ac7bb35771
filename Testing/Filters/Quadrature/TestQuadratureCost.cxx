// TestQuadratureCost FOLDER [FILE...]: how many points the plans of exact solids take at a tolerance of 1e-9, against the
// fewest that would do: for each panel the cheapest pair of orders whose true error, known in extended precision, is within
// the panel's share. With volume and moments alone, and with the area.
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

namespace
{
using namespace smtest;

constexpr double RelativeTolerance = 1e-9;
// Panels of a solid that are looked at, evenly spread: the search for the least costs thousands of evaluations each.
constexpr std::size_t PanelsOfASolid = 10;

struct Cost
{
  std::int64_t Planned = 0;
  std::int64_t Least = 0;
};

/// Fewest points whose error is within the tolerances.
std::int64_t FindLeast(
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
  std::int64_t least = static_cast<std::int64_t>(item.Along) * item.Across;
  for (int along = 1; along <= item.Along; ++along)
  {
    for (int across = 1; across <= item.Across && static_cast<std::int64_t>(along) * across < least; ++across)
    {
      if (meets(along, across))
      {
        least = static_cast<std::int64_t>(along) * across;
      }
    }
  }
  return least;
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
      cost.Least += FindLeast(reference, *items[i], shares);
    }
  }
  return cost;
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
        sums[withArea].Least += cost.Least;
        std::printf("%-14s %-26s planned %6lld least %6lld ratio %.2f\n", name,
          withArea ? "with the area" : "volume and moments", static_cast<long long>(cost.Planned),
          static_cast<long long>(cost.Least), static_cast<double>(cost.Planned) / cost.Least);
      }
    }
  }
  for (const bool withArea : { false, true })
  {
    CheckRange(
      withArea ? "points over the least, with the area" : "points over the least, volume and moments", 1.0,
      static_cast<double>(sums[withArea].Planned) / sums[withArea].Least, withArea ? 6.0 : 3.0);
  }
  return Finish();
}
