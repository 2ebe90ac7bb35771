#include "smQuantities.h"

#include "smMassPropertyNames.h"
#include "smText.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkVariant.h"

#include <cmath>

namespace sm
{
namespace
{
/// Returns the components of a row as JSON numbers; null if the array is missing or a component is not finite.
Json GetVector(vtkFieldData* data, vtkIdType row, const std::string& name, int components)
{
  vtkDataArray* array = data->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != components || row >= array->GetNumberOfTuples())
  {
    return nullptr;
  }
  Json values = Json::array();
  for (int c = 0; c < components; ++c)
  {
    const double value = array->GetComponent(row, c);
    if (!std::isfinite(value))
    {
      return nullptr;
    }
    values.push_back(value);
  }
  return values;
}

Json GetMatrix(vtkFieldData* data, vtkIdType row, const std::string& name)
{
  const Json values = GetVector(data, row, name, 9);
  if (values.is_null())
  {
    return values;
  }
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i)
  {
    rows.push_back({ values[3 * i], values[3 * i + 1], values[3 * i + 2] });
  }
  return rows;
}
}

Json GetNumber(vtkFieldData* data, vtkIdType row, const std::string& name)
{
  const Json values = GetVector(data, row, name, 1);
  return values.is_null() ? values : values[0];
}

Json GetPoint(vtkFieldData* data, vtkIdType row, const std::string& name)
{
  return GetVector(data, row, name, 3);
}

Json GetCount(vtkFieldData* data, vtkIdType row, const std::string& name)
{
  const Json value = GetNumber(data, row, name);
  return value.is_null() ? value : Json(static_cast<long long>(value.get<double>()));
}

std::string GetText(vtkFieldData* data, vtkIdType row, const char* name)
{
  vtkAbstractArray* array = data->GetAbstractArray(name);
  return array && row < array->GetNumberOfTuples() ? array->GetVariantValue(row).ToString() : std::string();
}

namespace
{
/// Returns the centre of mass and the inertia in the frame of reference; null without one.
Json GetInFrame(vtkFieldData* data, vtkIdType row)
{
  if (!data->HasArray(names::VolumeInertiaInFrame))
  {
    return nullptr;
  }
  const std::string bound = names::BoundSuffix;
  Json about;
  about["center_of_mass"] = GetVector(data, row, names::CenterOfMassInFrame, 3);
  about["inertia"] = GetMatrix(data, row, names::VolumeInertiaInFrame);
  about["mass_center"] = GetVector(data, row, names::MassCenterInFrame, 3);
  about["mass_inertia"] = GetMatrix(data, row, names::MassInertiaInFrame);
  about["central_inertia"] = GetMatrix(data, row, names::CentralInertiaInFrame);
  about["mass_central_inertia"] = GetMatrix(data, row, names::MassCentralInertiaInFrame);
  about["bounds"]["central_inertia"] = GetNumber(data, row, names::CentralInertiaInFrame + bound);
  about["bounds"]["mass_central_inertia"] = GetNumber(data, row, names::MassCentralInertiaInFrame + bound);
  about["bounds"]["center_of_mass"] = GetNumber(data, row, names::CenterOfMassInFrame + bound);
  about["bounds"]["inertia"] = GetNumber(data, row, names::VolumeInertiaInFrame + bound);
  about["bounds"]["mass_center"] = GetNumber(data, row, names::MassCenterInFrame + bound);
  about["bounds"]["mass_inertia"] = GetNumber(data, row, names::MassInertiaInFrame + bound);
  return about;
}

/// Adds the quantities that depend on the density, radii of gyration, and the inertia about the origin and in the frame of reference.
void AddMassQuantities(vtkFieldData* data, vtkIdType row, Json& q)
{
  const std::string bound = names::BoundSuffix;
  const std::string material = GetText(data, row, names::Material);
  q["density"] = GetNumber(data, row, names::Density);
  q["material"] = material.empty() ? Json() : Json(material);
  const Json shares = GetVector(data, row, names::MassUncertainty, 4);
  q["mass_uncertainty"] = nullptr;
  if (shares.is_array())
  {
    q["mass_uncertainty"] = { { "total", shares[0] }, { "density", shares[1] }, { "gaps", shares[2] },
      { "numerical", shares[3] } };
  }
  q["mass_center"] = GetVector(data, row, names::MassCenter, 3);
  q["mass_inertia"] = GetMatrix(data, row, names::MassInertia);
  q["mass_principal_moments"] = GetVector(data, row, names::MassPrincipalMoments, 3);
  q["mass_principal_axes"] = GetMatrix(data, row, names::MassPrincipalAxes);
  q["mass_radii_of_gyration"] = GetVector(data, row, names::MassRadiiOfGyration, 3);
  q["radii_of_gyration"] = GetVector(data, row, names::RadiiOfGyration, 3);
  q["inertia_at_origin"] = GetMatrix(data, row, names::VolumeInertiaAtOrigin);
  q["bounds"]["mass_center"] = GetNumber(data, row, names::MassCenter + bound);
  q["bounds"]["mass_inertia"] = GetNumber(data, row, names::MassInertia + bound);
  q["bounds"]["mass_radii_of_gyration"] = GetNumber(data, row, names::MassRadiiOfGyration + bound);
  q["bounds"]["radii_of_gyration"] = GetNumber(data, row, names::RadiiOfGyration + bound);
  q["bounds"]["inertia_at_origin"] = GetNumber(data, row, names::VolumeInertiaAtOrigin + bound);
  q["about"] = GetInFrame(data, row);
}
}

Json GetQuantities(vtkFieldData* data, vtkIdType row)
{
  const std::string bound = names::BoundSuffix;
  Json q;
  q["volume"] = GetNumber(data, row, names::Volume);
  q["area"] = GetNumber(data, row, names::SurfaceArea);
  q["center_of_mass"] = GetVector(data, row, names::CenterOfMass, 3);
  q["inertia"] = GetMatrix(data, row, names::VolumeInertia);
  q["principal_moments"] = GetVector(data, row, names::PrincipalMoments, 3);
  q["principal_axes"] = GetMatrix(data, row, names::PrincipalAxes);
  const Json degenerate = GetCount(data, row, names::PrincipalAxesDegenerate);
  q["principal_axes_degenerate"] = degenerate.is_null() ? degenerate : Json(degenerate != 0);
  q["mass"] = GetNumber(data, row, names::Mass);
  q["bounds"]["volume"] = GetNumber(data, row, names::Volume + bound);
  q["bounds"]["area"] = GetNumber(data, row, names::SurfaceArea + bound);
  q["bounds"]["center_of_mass"] = GetNumber(data, row, names::CenterOfMass + bound);
  q["bounds"]["inertia"] = GetNumber(data, row, names::VolumeInertia + bound);
  q["bounds"]["mass"] = GetNumber(data, row, names::Mass + bound);
  q["closure_correction"] = GetNumber(data, row, names::ClosureCorrection);
  q["gap_squared"] = GetNumber(data, row, names::GapSquared);
  q["max_gap"] = GetNumber(data, row, names::MaxGap);
  q["gap_area"] = GetNumber(data, row, names::GapArea);
  q["open_edges"] = GetCount(data, row, names::OpenEdges);
  q["closure_residual"] = GetNumber(data, row, names::ClosureResidual);
  q["flipped_shells"] = GetCount(data, row, names::FlippedShells);
  q["stability"] = nullptr;
  const Json estimated = GetCount(data, row, names::BoundsEstimated);
  const Json measured = GetVector(data, row, names::BoundsMeasured, 4);
  q["bounds_measured"] = nullptr;
  if (measured.is_array())
  {
    q["bounds_measured"] = { { "volume", measured[0] }, { "area", measured[1] },
      { "center_of_mass", measured[2] }, { "inertia", measured[3] } };
  }
  q["bounds_estimated"] = estimated.is_null() ? estimated : Json(estimated != 0);
  AddMassQuantities(data, row, q);
  return q;
}

void SetFileName(Json& entry, const std::string& name)
{
  entry["file"] = name;
  entry["file_bytes"] = MakeUtf8(name) == name ? Json() : Json(PercentEncode(name));
}
}
