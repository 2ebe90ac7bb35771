#include "smSectionRun.h"

#include "smPlaneCut.h"
#include "smSectionNames.h"

#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkSolidSection.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Reads the results in a row of field data or of a table. `hasMass`: false where solids have several
/// densities, or masses of their own, which the filter does not know.
void ReadSection(vtkFieldData* data, vtkIdType row, bool hasMass, SectionEntry& section)
{
  section.Area = GetQuantity<1>(data, row, names::SectionArea);
  section.Centroid = GetQuantity<3>(data, row, names::SectionCentroid);
  const Quantity<6> six = GetQuantity<6>(data, row, names::SectionSecondMoments);
  const std::array<double, 6>& m = six.Value; // xx, yy, zz, xy, yz, xz
  section.SecondMoments.Value = { m[0], m[3], m[5], m[3], m[1], m[4], m[5], m[4], m[2] };
  section.SecondMoments.Bound = six.Bound;
  section.PrincipalMoments = GetQuantity<2>(data, row, names::SectionPrincipalMoments);
  section.PrincipalDirections = GetQuantity<6>(data, row, names::SectionPrincipalDirections);
  section.VolumeBelow = GetQuantity<1>(data, row, names::VolumeBelow);
  section.CenterBelow = GetQuantity<3>(data, row, names::CenterBelow);
  section.VolumeAbove = GetQuantity<1>(data, row, names::VolumeAbove);
  section.CenterAbove = GetQuantity<3>(data, row, names::CenterAbove);
  if (hasMass)
  {
    section.MassBelow = GetQuantity<1>(data, row, names::MassBelow);
    section.MassAbove = GetQuantity<1>(data, row, names::MassAbove);
  }
}
}

void RunSections(const SectionPlanes& planes, const AnalysisRun& run)
{
  vtkNew<vtkSolidSection> filter;
  filter->SetRelativeTolerance(run.Options.Tolerance);
  const std::vector<MaterialRule>& rules = run.Options.Materials;
  const bool isStated = std::any_of(
    rules.begin(), rules.end(), [](const MaterialRule& rule) { return rule.Material.Mass > 0.0; });
  const bool hasMass = rules.empty() || (!isStated && std::isfinite(run.File.Total.Density));
  filter->SetDensity(rules.empty() || !hasMass ? run.Options.Density : run.File.Total.Density);
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    filter->SetPoint(planes[i].data());
    filter->SetNormal(planes[i].data() + 3);
    RunPlaneCut<SectionResult>(run, filter,
      [i, hasMass](vtkFieldData* data, vtkIdType row, SectionResult& result)
      { ReadSection(data, row, hasMass, result.Sections[i]); });
  }
}
}
