// The integrals of a box in a placement that was read: those of all placements that rounding may have made
// the same are within the bounds, and the bounds are not much larger than they differ.
#include "smPlacedBox.h"
#include "smTesting.h"

#include <vtkMassPropertiesGPU.h>
#include <vtkSurfaceIntegralGPU.h>

#include <algorithm>
#include <string>

namespace
{
using namespace smtest;
using Real = PlacedBox::Real;

void CheckPlacement(double distance)
{
  vtkNew<vtkMatrix4x4> placement;
  PlacedBox::SetPlacement(distance, placement);
  vtkNew<vtkSurfaceIntegralGPU> filter;
  filter->SetBackend(vtkSurfaceIntegralGPU::CPU);
  filter->AddVolumeMoment("volume", 0, 0, 0);
  filter->AddVolumeMoment("first moment", 0, 1, 0);
  filter->AddAreaMoment("area", 0, 0, 0);
  filter->AddAreaMoment("first moment of the area", 0, 1, 0);
  filter->SetInputDataObject(PlacedBox::MakeLeaf(placement));
  filter->Update();
  std::mt19937_64 random(7);
  Real largest[4] = {};
  const char* const names[4] = { "volume", "first moment", "area", "first moment of the area" };
  for (int i = 0; i < 200; ++i)
  {
    const PlacedBox box(placement, random);
    const Real exact[4] = { box.GetVolume(), box.GetVolume() * box.GetMiddle()[1], box.GetArea(),
      box.GetArea() * box.GetMiddle()[1] };
    for (int k = 0; k < 4; ++k)
    {
      largest[k] = std::max(
        largest[k], std::abs(filter->GetIntegral(names[k]) - exact[k]) / filter->GetIntegralBound(names[k]));
    }
  }
  for (int k = 0; k < 4; ++k)
  {
    // Far away the sums of volume integrals hardly depend on the rotation, but the fluxes of single faces do.
    CheckRange(std::string(names[k]) + " at " + std::to_string(distance) + ", largest difference over bound",
      k < 2 && distance > 0.0 ? 0.0 : 0.02, static_cast<double>(largest[k]), 1.0);
  }
  CheckEqual("status", "ok", filter->GetStatus());
}

/// A placement that is exact costs nothing.
void CheckExact()
{
  vtkNew<vtkMatrix4x4> identity;
  const auto leaf = PlacedBox::MakeLeaf(identity);
  sm::PlacementError none;
  CheckEqual("not moved", 0.0, none.Moved);
  vtkNew<vtkSurfaceIntegralGPU> filter;
  filter->SetBackend(vtkSurfaceIntegralGPU::CPU);
  filter->AddAreaMoment("area", 0, 0, 0);
  filter->SetInputDataObject(leaf);
  filter->Update();
  const double still = filter->GetIntegralBound("area");
  vtkNew<vtkMatrix4x4> placement;
  PlacedBox::SetPlacement(0.0, placement);
  leaf->SetPlacement(placement);
  filter->Update();
  CheckRange("bound of the rotated", 2.0 * still, filter->GetIntegralBound("area"), 100.0 * still);
}

/// A matrix that is a rotation except for its decimals, or stretches by as little: the box as it places it is
/// within the bounds.
void CheckNearlyRigid(double stretch)
{
  vtkNew<vtkMatrix4x4> placement;
  PlacedBox::SetPlacement(0.0, placement);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      placement->SetElement(i, j, (1.0 + stretch) * placement->GetElement(i, j));
    }
  }
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetBackend(vtkSurfaceIntegralGPU::CPU);
  LatticeBody body;
  body.Degree = 1;
  body.Knots = { 0.0, 0.0, 1.0, 1.0 };
  const auto leaf = body.Make();
  leaf->SetPlacement(placement);
  mass->SetInputDataObject(leaf);
  mass->Update();
  const Real scale = 1.0L + stretch;
  const std::string label = "stretched by " + std::to_string(stretch * 1e13) + "e-13";
  Check(label + ", volume", static_cast<double>(30.0L * scale * scale * scale), mass->GetVolume(),
    mass->GetVolumeBound(), "(the bound)");
  CheckRange(label + ", bound", 0.0, mass->GetVolumeBound(), 30.0 * (2e-14 + 40.0 * stretch));
  Check(label + ", area", static_cast<double>(62.0L * scale * scale), mass->GetSurfaceArea(),
    mass->GetSurfaceAreaBound(), "(the bound)");
  CheckRange(
    label + ", bound of the area", 0.0, mass->GetSurfaceAreaBound(), 62.0 * (2e-14 + 40.0 * stretch));
  CheckEqual(label + ", status", "ok", mass->GetStatus());
}
}

int TestPlacementError(int, char*[])
{
  CheckPlacement(0.0);
  CheckPlacement(1000.0);
  CheckExact();
  for (const double stretch : { 0.0, 1.5e-15, 1e-14, 1e-13, 4e-13 })
  {
    CheckNearlyRigid(stretch);
  }
  return Finish();
}
