#include "smSectionJob.h"

#include "smBuoyancyJob.h"
#include "smQuantities.h"
#include "smSectionNames.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkSolidSection.h"

#include <cmath>

namespace
{
using sm::Json;
namespace names = sm::names;

/// Returns the components of a value as a list; null if it is not known.
Json GetList(vtkFieldData* data, vtkIdType row, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  Json list = Json::array();
  for (int c = 0; array && row < array->GetNumberOfTuples() && c < array->GetNumberOfComponents(); ++c)
  {
    list.push_back(array->GetComponent(row, c));
    if (!std::isfinite(array->GetComponent(row, c)))
    {
      return {};
    }
  }
  return list.empty() ? Json() : list;
}

/// Makes a symmetric matrix from xx, yy, zz, xy, yz, xz.
Json MakeMatrix(const Json& six)
{
  return six.is_null()
    ? six
    : Json{ { six[0], six[3], six[5] }, { six[3], six[1], six[4] }, { six[5], six[4], six[2] } };
}

/// Returns the results in a row of field data or of a table. `hasMass`: false with materials by name, which the filter does not know.
Json Describe(vtkFieldData* data, vtkIdType row, bool hasMass)
{
  Json found;
  Json bounds;
  const auto setBound = [&](const char* key, const char* name)
  { bounds[key] = sm::GetNumber(data, row, std::string(name) + names::BoundSuffix); };
  const auto setNumber = [&](const char* key, const char* name)
  {
    found[key] = sm::GetNumber(data, row, name);
    setBound(key, name);
  };
  const auto setPoint = [&](const char* key, const char* name)
  {
    found[key] = sm::GetPoint(data, row, name);
    setBound(key, name);
  };
  setNumber("area", names::SectionArea);
  setPoint("centroid", names::SectionCentroid);
  found["second_moments"] = MakeMatrix(GetList(data, row, names::SectionSecondMoments));
  setBound("second_moments", names::SectionSecondMoments);
  found["principal_moments"] = GetList(data, row, names::SectionPrincipalMoments);
  setBound("principal_moments", names::SectionPrincipalMoments);
  const Json six = GetList(data, row, names::SectionPrincipalDirections);
  found["principal_directions"] =
    six.is_null() ? six : Json{ { six[0], six[1], six[2] }, { six[3], six[4], six[5] } };
  setNumber("volume_below", names::VolumeBelow);
  setPoint("center_below", names::CenterBelow);
  setNumber("volume_above", names::VolumeAbove);
  setPoint("center_above", names::CenterAbove);
  setNumber("mass_below", names::MassBelow);
  setNumber("mass_above", names::MassAbove);
  if (!hasMass)
  {
    for (const char* key : { "mass_below", "mass_above" })
    {
      found[key] = bounds[key] = nullptr;
    }
  }
  found["bounds"] = bounds;
  return found;
}
}

namespace sm
{
void IntegrateSections(vtkCADReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages)
{
  if (options.Sections.empty())
  {
    return;
  }
  vtkNew<vtkSolidSection> filter;
  filter->SetRelativeTolerance(options.Tolerance);
  filter->SetDensity(options.Density);
  for (std::size_t i = 0; i < options.Sections.size(); ++i)
  {
    filter->SetPoint(options.Sections[i].data());
    filter->SetNormal(options.Sections[i].data() + 3);
    RunPlaneCut(
      reader, options, update, filter,
      [i, &options](vtkFieldData* data, vtkIdType row, Json& entry)
      { entry["sections"][i].update(Describe(data, row, options.Materials.empty())); },
      file, messages);
  }
}
}
