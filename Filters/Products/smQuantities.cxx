#include "smQuantities.h"

#include "smMassPropertyNames.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkTypeInt64Array.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>

namespace sm
{
void ReadNumbers(vtkFieldData* data, vtkIdType row, const std::string& name, double* values, int components)
{
  std::fill_n(values, components, Unknown);
  vtkDataArray* array = data->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != components || row >= array->GetNumberOfTuples())
  {
    return;
  }
  for (int c = 0; c < components; ++c)
  {
    values[c] = array->GetComponent(row, c);
  }
  if (!std::all_of(values, values + components, [](double value) { return std::isfinite(value); }))
  {
    std::fill_n(values, components, Unknown);
  }
}

double GetNumber(vtkFieldData* data, vtkIdType row, const std::string& name)
{
  double value;
  ReadNumbers(data, row, name, &value, 1);
  return value;
}

/// Reads each share by itself: that of gaps is not known for open solids.
std::array<double, 6> ReadMassUncertainty(vtkFieldData* data, vtkIdType row)
{
  std::array<double, 6> shares;
  shares.fill(Unknown);
  vtkDataArray* array = data->GetArray(names::MassUncertainty);
  if (array && array->GetNumberOfComponents() == 5 && row < array->GetNumberOfTuples())
  {
    array->GetTuple(row, shares.data());
  }
  return shares;
}

std::array<double, 3> GetPoint(vtkFieldData* data, vtkIdType row, const std::string& name)
{
  std::array<double, 3> point;
  ReadNumbers(data, row, name, point.data(), 3);
  return point;
}

long long GetCount(vtkFieldData* data, vtkIdType row, const std::string& name)
{
  // A double does not hold all entity numbers.
  auto* const numbers = vtkTypeInt64Array::SafeDownCast(data->GetAbstractArray(name.c_str()));
  if (numbers && row < numbers->GetNumberOfTuples())
  {
    return numbers->GetValue(row);
  }
  const double value = GetNumber(data, row, name);
  return std::isnan(value) ? -1 : static_cast<long long>(value);
}

std::string GetText(vtkFieldData* data, vtkIdType row, const char* name)
{
  vtkAbstractArray* array = data->GetAbstractArray(name);
  return array && row < array->GetNumberOfTuples() ? array->GetVariantValue(row).ToString() : std::string();
}

namespace
{
std::optional<bool> GetFlag(vtkFieldData* data, vtkIdType row, const char* name)
{
  const long long value = GetCount(data, row, name);
  return value < 0 ? std::nullopt : std::optional(value != 0);
}

FrameQuantities ReadFrame(vtkFieldData* data, vtkIdType row)
{
  FrameQuantities about;
  about.Center = GetQuantity<3>(data, row, names::CenterOfMassInFrame);
  about.Inertia = GetQuantity<9>(data, row, names::VolumeInertiaInFrame);
  about.MassCenter = GetQuantity<3>(data, row, names::MassCenterInFrame);
  about.MassInertia = GetQuantity<9>(data, row, names::MassInertiaInFrame);
  about.CentralInertia = GetQuantity<9>(data, row, names::CentralInertiaInFrame);
  about.MassCentralInertia = GetQuantity<9>(data, row, names::MassCentralInertiaInFrame);
  return about;
}

SpreadQuantities ReadSpread(vtkFieldData* data, vtkIdType row)
{
  const auto get = [&](const char* name)
  { return GetNumber(data, row, std::string(name) + names::SpreadSuffix); };
  SpreadQuantities spread;
  spread.Volume = get(names::Volume);
  spread.Area = get(names::SurfaceArea);
  spread.Center = get(names::CenterOfMass);
  spread.Inertia = get(names::VolumeInertia);
  spread.PrincipalMoments = get(names::PrincipalMoments);
  spread.Mass = get(names::Mass);
  spread.MassCenter = get(names::MassCenter);
  spread.MassInertia = get(names::MassInertia);
  spread.MassPrincipalMoments = get(names::MassPrincipalMoments);
  return spread;
}

void Visit(Fields& fields, SpreadQuantities& spread)
{
  fields
    .Note("",
      "how far closing the gaps in another way may change the quantities with the same names; "
      "unknown where edges are open")
    .Begin("closure_spread");
  fields.Number("volume", spread.Volume);
  fields.Number("area", spread.Area);
  fields.Number("center_of_mass", spread.Center);
  fields.Number("inertia", spread.Inertia);
  fields.Number("principal_moments", spread.PrincipalMoments);
  fields.Number("mass", spread.Mass);
  fields.Number("mass_center", spread.MassCenter);
  fields.Number("mass_inertia", spread.MassInertia);
  fields.Number("mass_principal_moments", spread.MassPrincipalMoments);
  fields.End();
}

void Visit(Fields& fields, FrameQuantities& about)
{
  fields.Note("L", "").Point("center_of_mass", about.Center.Value);
  fields.Note("L^5", "about the origin of the frame").Matrix("inertia", about.Inertia.Value);
  fields.Note("L", "").Point("mass_center", about.MassCenter.Value);
  fields.Note("kg L^2", "about the origin of the frame").Matrix("mass_inertia", about.MassInertia.Value);
  fields.Note("L^5", "about the centre of mass, along the axes of the frame")
    .Matrix("central_inertia", about.CentralInertia.Value);
  fields.Note("kg L^2", "about the centre of the masses, along the axes of the frame")
    .Matrix("mass_central_inertia", about.MassCentralInertia.Value);
  fields.Note("", "of the quantities with the same names").Begin("bounds");
  fields.Number("central_inertia", about.CentralInertia.Bound);
  fields.Number("mass_central_inertia", about.MassCentralInertia.Bound);
  fields.Number("center_of_mass", about.Center.Bound);
  fields.Number("inertia", about.Inertia.Bound);
  fields.Number("mass_center", about.MassCenter.Bound);
  fields.Number("mass_inertia", about.MassInertia.Bound);
  fields.End();
}

/// Visits numbers as an object that does not exist if the second is not known.
template <std::size_t N>
void VisitShares(Fields& fields, const char* key, std::array<double, N>& values, const char* const (&keys)[N])
{
  if (fields.Begin(key, !std::isnan(values[1])))
  {
    for (std::size_t i = 0; i < N; ++i)
    {
      fields.Number(keys[i], values[i]);
    }
    fields.End();
  }
}
}

Quantities ReadQuantities(vtkFieldData* data, vtkIdType row)
{
  Quantities q;
  q.Volume = GetQuantity<1>(data, row, names::Volume);
  q.Area = GetQuantity<1>(data, row, names::SurfaceArea);
  q.Mass = GetQuantity<1>(data, row, names::Mass);
  q.Center = GetQuantity<3>(data, row, names::CenterOfMass);
  q.MassCenter = GetQuantity<3>(data, row, names::MassCenter);
  q.PrincipalMoments = GetQuantity<3>(data, row, names::PrincipalMoments);
  q.MassPrincipalMoments = GetQuantity<3>(data, row, names::MassPrincipalMoments);
  q.RadiiOfGyration = GetQuantity<3>(data, row, names::RadiiOfGyration);
  q.MassRadiiOfGyration = GetQuantity<3>(data, row, names::MassRadiiOfGyration);
  q.Inertia = GetQuantity<9>(data, row, names::VolumeInertia);
  q.InertiaAtOrigin = GetQuantity<9>(data, row, names::VolumeInertiaAtOrigin);
  q.MassInertia = GetQuantity<9>(data, row, names::MassInertia);
  q.PrincipalAxes = GetQuantity<9>(data, row, names::PrincipalAxes);
  q.MassPrincipalAxes = GetQuantity<9>(data, row, names::MassPrincipalAxes);
  q.PrincipalAxesDegenerate = GetFlag(data, row, names::PrincipalAxesDegenerate);
  q.BoundsEstimated = GetFlag(data, row, names::BoundsEstimated);
  ReadNumbers(data, row, names::BoundsMeasured, q.BoundsMeasured.data(), 4);
  q.MassUncertainty = ReadMassUncertainty(data, row);
  q.OverriddenMass = GetNumber(data, row, names::OverriddenMass);
  q.Density = GetNumber(data, row, names::Density);
  q.Material = GetText(data, row, names::Material);
  q.Spread = ReadSpread(data, row);
  q.ClosureCorrection = GetNumber(data, row, names::ClosureCorrection);
  q.ClosureResidual = GetNumber(data, row, names::ClosureResidual);
  q.GapSquared = GetNumber(data, row, names::GapSquared);
  q.MaxGap = GetNumber(data, row, names::MaxGap);
  q.GapArea = GetNumber(data, row, names::GapArea);
  q.OpenEdges = GetCount(data, row, names::OpenEdges);
  q.FlippedShells = GetCount(data, row, names::FlippedShells);
  if (data->HasArray(names::VolumeInertiaInFrame))
  {
    q.About = ReadFrame(data, row);
  }
  return q;
}

void Quantities::Visit(Fields& fields, const std::function<void()>& inBounds)
{
  fields.Note("L^3", "").Number("volume", this->Volume);
  fields.Note("L^2", "").Number("area", this->Area);
  fields.Note("L", "").Point("center_of_mass", this->Center.Value);
  fields
    .Note("L^5",
      "about the centre of mass, at unit density; off-diagonals "
      "are negative products")
    .Matrix("inertia", this->Inertia.Value);
  fields.Note("L^5", "ascending").Point("principal_moments", this->PrincipalMoments.Value);
  fields.Note("1", "rows are unit vectors").Matrix("principal_axes", this->PrincipalAxes.Value);
  fields.Note("", "true: moments coincide, the axes are not unique")
    .Flag("principal_axes_degenerate", this->PrincipalAxesDegenerate);
  fields.Note("kg", "with a density").Number("mass", this->Mass);
  fields
    .Note("",
      "of the quantities with the same names; of a vector or matrix "
      "that of its largest entry")
    .Begin("bounds");
  fields.Number("volume", this->Volume.Bound);
  fields.Number("area", this->Area.Bound);
  fields.Number("center_of_mass", this->Center.Bound);
  fields.Number("inertia", this->Inertia.Bound);
  fields.Number("mass", this->Mass.Bound);
  fields.Number("mass_center", this->MassCenter.Bound);
  fields.Number("mass_inertia", this->MassInertia.Bound);
  fields.Number("mass_radii_of_gyration", this->MassRadiiOfGyration.Bound);
  fields.Number("radii_of_gyration", this->RadiiOfGyration.Bound);
  fields.Number("inertia_at_origin", this->InertiaAtOrigin.Bound);
  if (inBounds)
  {
    inBounds();
  }
  fields.End();
  sm::Visit(fields, this->Spread);
  fields.Note("L^3", "volume change by closing the gaps between faces")
    .Number("closure_correction", this->ClosureCorrection);
  fields.Note("L^3", "integral of the squared gap").Number("gap_squared", this->GapSquared);
  fields.Note("L", "widest gap").Number("max_gap", this->MaxGap);
  fields.Note("L^2", "area of the gaps").Number("gap_area", this->GapArea);
  fields.Note("", "number of edges whose uses do not cancel").Count("open_edges", this->OpenEdges);
  fields.Note("1", "relative volume change under a shift of the origin")
    .Number("closure_residual", this->ClosureResidual);
  fields.Note("", "shells that were inside out in the file and were reversed")
    .Count("flipped_shells", this->FlippedShells);
  if (fields.Note("", "with `--stability`")
        .Begin("stability", false)) // that of a solid is set by its analysis
  {
    fields.End();
  }
  VisitShares(fields.Note("",
                "the part of the bound that rests on measured "
                "constants and residuals, an estimate; the rest "
                "is a theorem"),
    "bounds_measured", this->BoundsMeasured, { "volume", "area", "center_of_mass", "inertia" });
  fields.Note("", "true: some bound is an estimate").Flag("bounds_estimated", this->BoundsEstimated);
  fields.Note("kg/m^3", "of the solid; of the total if all solids have the same")
    .Number("density", this->Density);
  fields.Note("", "as `density`").Name("material", this->Material);
  VisitShares(fields.Note("kg",
                "what is in doubt of the mass: the sum, and its "
                "shares by densities, other closings of the gaps, bound, the tolerances of masses that "
                "materials state, and, where such are given, tolerances of faces"),
    "mass_uncertainty", this->MassUncertainty,
    { "total", "density", "gaps", "numerical", "overridden", "tolerance" });
  fields.Note("kg", "the part of `mass` that materials state")
    .Number("overridden_mass", this->OverriddenMass);
  fields.Note("L", "centre of mass with the densities as weight")
    .Point("mass_center", this->MassCenter.Value);
  fields.Note("kg L^2", "about `mass_center`").Matrix("mass_inertia", this->MassInertia.Value);
  fields.Note("kg L^2", "ascending").Point("mass_principal_moments", this->MassPrincipalMoments.Value);
  fields.Note("1", "rows are unit vectors").Matrix("mass_principal_axes", this->MassPrincipalAxes.Value);
  fields.Note("L", "about the principal axes")
    .Point("mass_radii_of_gyration", this->MassRadiiOfGyration.Value);
  fields.Note("L", "about the principal axes").Point("radii_of_gyration", this->RadiiOfGyration.Value);
  fields.Note("L^5", "about the origin").Matrix("inertia_at_origin", this->InertiaAtOrigin.Value);
  if (fields.Note("", "with `--about`: in that frame").Begin("about", this->About.has_value()))
  {
    this->About = this->About.value_or(FrameQuantities());
    sm::Visit(fields, *this->About);
    fields.End();
  }
}
}
