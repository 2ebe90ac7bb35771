#include "smBuoyancySums.h"

#include "smBuoyancyNames.h"

#include <vtkSurfaceIntegralGPU.h>
#include <vtkTable.h>

#include <algorithm>
#include <cstdio>

namespace smtest
{
namespace
{
/// Face by face, h up is integrated below and above: together they are its flux, whose bound is an estimate.
void CheckFaces(
  const std::string& what, vtkBuoyancy* below, vtkBuoyancy* above, vtkSTEPReader* reader, const Plane& plane)
{
  const Vector up = Unit(plane.Up);
  char text[512];
  const auto number = [](Real x) { return static_cast<double>(x); };
  std::snprintf(text, sizeof(text),
    "dot(position - dvec3(%.17g, %.17g, %.17g), dvec3(%.17g, %.17g, %.17g)) * "
    "dot(dvec3(%.17g, %.17g, %.17g), normal)",
    number(plane.Point[0]), number(plane.Point[1]), number(plane.Point[2]), number(up[0]), number(up[1]),
    number(up[2]), number(up[0]), number(up[1]), number(up[2]));
  vtkNew<vtkSurfaceIntegralGPU> flux;
  flux->SetInputConnection(reader->GetOutputPort());
  flux->SetRelativeTolerance(1e-11);
  flux->AddIntegrand("flux", text, vtkSurfaceIntegralGPU::CLOSED_CHAIN);
  flux->Update();
  auto* belows = vtkTable::SafeDownCast(below->GetOutputDataObject(3));
  auto* aboves = vtkTable::SafeDownCast(above->GetOutputDataObject(3));
  auto* wholes = vtkTable::SafeDownCast(flux->GetOutputDataObject(3));
  const auto get = [](vtkTable* table, vtkIdType row, const char* name)
  { return table->GetValueByName(row, name).ToDouble(); };
  double worst = 0.0;
  int face = 0;
  for (vtkIdType row = 0; row < belows->GetNumberOfRows(); ++row)
  {
    const double part = get(belows, row, sm::names::DisplacedVolume);
    const double sum = part + get(aboves, row, sm::names::DisplacedVolume);
    const double bound = get(belows, row, "DisplacedVolumeBound") + get(aboves, row, "DisplacedVolumeBound") +
      get(wholes, row, "fluxBound") + 1e-15 * (std::abs(part) + std::abs(sum));
    const double ratio = std::abs(sum - get(wholes, row, "flux")) / std::max(bound, 1e-300);
    if (!(ratio <= worst))
    {
      worst = ratio;
      face = static_cast<int>(get(belows, row, "FaceId"));
    }
  }
  CheckRange(what + ", error over bound of the worst face #" + std::to_string(face), 0.0, worst, 1.0);
}
}

void CheckBelowAndAbove(
  vtkSTEPReader* reader, const std::string& what, const std::vector<Vector>& directions, bool withFaces)
{
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputConnection(reader->GetOutputPort());
  mass->Update();
  const double volume = mass->GetVolume();
  double middle[3];
  mass->GetCenterOfMass(middle);
  if (!std::isfinite(volume))
  {
    CheckTrue(what + " has no volume", mass->GetStatus() != "ok", mass->GetStatus());
    return;
  }
  for (const double tolerance : { 1e-6, 1e-9 })
  {
    vtkNew<vtkSurfaceIntegralGPU> plain;
    plain->SetInputConnection(reader->GetOutputPort());
    plain->SetBackend(Backend);
    plain->SetRelativeTolerance(tolerance);
    vtkNew<vtkBuoyancy> below;
    vtkNew<vtkBuoyancy> above;
    for (vtkBuoyancy* each : { below.Get(), above.Get() })
    {
      each->SetInputConnection(reader->GetOutputPort());
      each->SetBackend(Backend);
      each->SetRelativeTolerance(tolerance);
    }
    plain->AddVolumeMoment("V", 0, 0, 0);
    plain->AddVolumeMoment("X", 1, 0, 0);
    plain->AddVolumeMoment("Y", 0, 1, 0);
    plain->AddVolumeMoment("Z", 0, 0, 1);
    plain->Update();
    for (std::size_t i = 0; i < directions.size(); ++i)
    {
      const Vector& up = directions[i];
      Plane plane{ "", { middle[0], middle[1], middle[2] }, up, {} };
      SetPlane(below, plane);
      below->Update();
      const auto evaluations = static_cast<double>(below->GetEvaluations());
      plane.Up = Scaled(up, -1);
      SetPlane(above, plane);
      above->Update();
      char label[64];
      std::snprintf(label, sizeof(label), ", direction %d, %g", static_cast<int>(i), tolerance);
      const auto check = [&](const char* name, double sum, double bound)
      {
        Check(what + label + " " + name, plain->GetIntegral(name), sum, bound + plain->GetIntegralBound(name),
          "the bounds");
      };
      check("V", below->GetDisplacedVolume() + above->GetDisplacedVolume(),
        below->GetDisplacedVolumeBound() + above->GetDisplacedVolumeBound());
      double firstBelow[3];
      double firstAbove[3];
      below->GetDisplacedFirstMoments(firstBelow);
      above->GetDisplacedFirstMoments(firstAbove);
      const char* const names[] = { "X", "Y", "Z" };
      for (int c = 0; c < 3; ++c)
      {
        check(names[c], firstBelow[c] + firstAbove[c],
          below->GetDisplacedFirstMomentsBound() + above->GetDisplacedFirstMomentsBound());
      }
      // Some of several solids may be below as a whole: their faces' shares are about another plane.
      if (withFaces && tolerance < 1e-8 && below->GetNumberOfSolids() == 1)
      {
        CheckFaces(what + label, below, above, reader, { "", plane.Point, up, {} });
      }
      std::printf("     %s%s: %.3g of the volume below, bound %.2g of it; %.0f evaluations, %.2f of the "
                  "volume's; status %s\n",
        what.c_str(), label, below->GetDisplacedVolume() / volume, below->GetDisplacedVolumeBound() / volume,
        evaluations, evaluations / static_cast<double>(plain->GetEvaluations()), below->GetStatus().c_str());
    }
  }
}
}
