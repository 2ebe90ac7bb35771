#include "smUserIntegrals.h"

#include "smMassPropertyNames.h"
#include "smMessageList.h"

#include "vtkCADReader.h"
#include "vtkComputeContext.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkMassPropertiesBase.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceIntegralGPU.h"
#include "vtkTable.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <vector>

namespace
{
using sm::Json;
namespace names = sm::names;

Json ValueAndBound(double value, double bound)
{
  return { { "value", sm::MakeNumber(value) }, { "bound", sm::MakeNumber(bound) } };
}

double Component(vtkDataSetAttributes* columns, vtkIdType row, const std::string& name)
{
  vtkDataArray* array = columns->GetArray(name.c_str());
  return array && row < array->GetNumberOfTuples() ? array->GetComponent(row, 0) : std::nan("");
}

// The time to compile a shader grows faster than its number of integrals: 969 integrals take more than 15 minutes (llvmpipe).
constexpr int MomentsPerFilter = 40;

using AddMoment = std::function<void(const std::string& name, int i, int j, int k)>;

void ListMoments(int degree, const AddMoment& add)
{
  for (int total = 0; total <= degree; ++total)
  {
    for (int i = total; i >= 0; --i)
    {
      for (int j = total - i; j >= 0; --j)
      {
        const int k = total - i - j;
        add("moment_" + std::to_string(i) + "_" + std::to_string(j) + "_" + std::to_string(k), i, j, k);
      }
    }
  }
}

void Report(vtkSurfaceIntegralGPU* filter, Json& file, sm::MessageList& messages)
{
  vtkDataSetAttributes* columns = vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetRowData();
  for (int i = 0; i < filter->GetNumberOfIntegrands(); ++i)
  {
    const std::string name = filter->GetIntegrandName(i);
    file["integrals"][name] = ValueAndBound(filter->GetIntegral(name), filter->GetIntegralBound(name));
    vtkIdType row = 0;
    for (Json& solid : file["solids"])
    {
      solid["integrals"][name] =
        ValueAndBound(Component(columns, row, name), Component(columns, row, name + names::BoundSuffix));
      ++row;
    }
  }
  sm::AddEffort(filter, file, messages);
}

/// Makes filters with the integrands of the options. Moments get filters without expressions, because an expression would make their bounds
/// estimates.
std::vector<vtkSmartPointer<vtkSurfaceIntegralGPU>> MakeFilters(const sm::JobOptions& options)
{
  std::vector<vtkSmartPointer<vtkSurfaceIntegralGPU>> filters;
  ListMoments(options.MomentDegree,
    [&filters](const std::string& name, int i, int j, int k)
    {
      if (filters.empty() || filters.back()->GetNumberOfIntegrands() == MomentsPerFilter)
      {
        filters.push_back(vtkSmartPointer<vtkSurfaceIntegralGPU>::New());
      }
      filters.back()->AddVolumeMoment(name, i, j, k);
    });
  const auto expressions = vtkSmartPointer<vtkSurfaceIntegralGPU>::New();
  filters.push_back(expressions);
  for (const std::string& text : options.Integrals)
  {
    std::string name;
    std::string expression;
    if (sm::ParseIntegral(text, name, expression))
    {
      expressions->AddIntegrand(name, expression);
    }
  }
  return filters;
}
}

namespace sm
{
bool ParseIntegral(const std::string& text, std::string& name, std::string& expression)
{
  const std::string::size_type equals = text.find('=');
  if (equals == std::string::npos)
  {
    return false;
  }
  name = text.substr(0, equals);
  expression = text.substr(equals + 1);
  return !name.empty() && expression.find_first_not_of(" \t\n") != std::string::npos;
}

std::string FindClash(const JobOptions& options)
{
  std::set<std::string> taken(std::begin(names::ReservedColumnNames), std::end(names::ReservedColumnNames));
  ListMoments(options.MomentDegree, [&taken](const std::string& name, int, int, int) { taken.insert(name); });
  std::string name;
  std::string expression;
  for (const std::string& text : options.Integrals)
  {
    if (ParseIntegral(text, name, expression) && !taken.insert(name).second)
    {
      return name;
    }
  }
  for (const std::string& text : options.Integrals)
  {
    if (ParseIntegral(text, name, expression) && taken.count(name + names::BoundSuffix) > 0)
    {
      return name + names::BoundSuffix;
    }
  }
  return {};
}

void SetUpFilter(vtkSurfaceIntegralBase* filter, const JobOptions& options)
{
  filter->SetMaximumEvaluations(static_cast<vtkTypeInt64>(options.MaximumEvaluations));
  SetTimeLimit(filter, options);
  for (const std::string& selector : options.Selectors)
  {
    filter->AddSelector(selector);
  }
  filter->SetGapLimit(options.GapLimit);
  filter->SetBackend(options.Backend == "auto" ? vtkSurfaceIntegralBase::AUTOMATIC
      : options.Backend == "cpu"               ? vtkSurfaceIntegralBase::CPU
                                               : vtkSurfaceIntegralBase::OPENGL);
  filter->GetComputeContext()->SetSource(options.Backend == "egl" ? vtkComputeContext::EGL
      : options.Backend == "x"                                    ? vtkComputeContext::X
                                                                  : vtkComputeContext::AUTOMATIC);
}

void SetUpMass(vtkMassPropertiesBase* filter, const JobOptions& options)
{
  filter->SetDensity(options.Density);
  filter->SetDensityTolerance(options.DensityTolerance);
  for (const MaterialRule& rule : options.Materials)
  {
    filter->AddMaterial(
      rule.Pattern.c_str(), rule.Material.Name.c_str(), rule.Material.Density, rule.Material.Tolerance);
  }
}

void SetTimeLimit(vtkSurfaceIntegralBase* filter, const JobOptions& options)
{
  if (options.MaximumSeconds > 0.0)
  {
    const std::chrono::duration<double> left = options.Deadline - std::chrono::steady_clock::now();
    filter->SetMaximumSeconds(std::max(left.count(), 1e-9));
  }
}

void AddPlaceholders(const JobOptions& options, Json& file)
{
  Json integrals = Json::object();
  for (vtkSurfaceIntegralGPU* filter : MakeFilters(options))
  {
    for (int i = 0; i < filter->GetNumberOfIntegrands(); ++i)
    {
      integrals[filter->GetIntegrandName(i)] = ValueAndBound(std::nan(""), std::nan(""));
    }
  }
  Json waterlines = Json::array();
  for (const double height : options.Waterlines)
  {
    waterlines.push_back({ { "height", height }, { "up", options.Up }, { "volume", nullptr },
      { "center", nullptr }, { "bounds", { { "volume", nullptr }, { "center", nullptr } } } });
  }
  Json sections = Json::array();
  for (const std::array<double, 6>& plane : options.Sections)
  {
    Json section = { { "point", { plane[0], plane[1], plane[2] } },
      { "normal", { plane[3], plane[4], plane[5] } }, { "principal_directions", nullptr } };
    Json bounds;
    for (const char* key : { "area", "centroid", "second_moments", "principal_moments", "volume_below",
           "center_below", "mass_below", "volume_above", "center_above", "mass_above" })
    {
      section[key] = bounds[key] = nullptr;
    }
    section["bounds"] = bounds;
    sections.push_back(section);
  }
  const auto add = [&](Json& entry)
  {
    if (!sections.empty())
    {
      entry["sections"] = sections;
    }
    if (!integrals.empty())
    {
      entry["integrals"] = integrals;
    }
    if (!waterlines.empty())
    {
      entry["waterlines"] = waterlines;
    }
  };
  add(file);
  for (Json& solid : file["solids"])
  {
    add(solid);
  }
}

void AddEffort(vtkSurfaceIntegralBase* filter, Json& file, MessageList& messages)
{
  if (file["status"] == names::StatusOk)
  {
    file["status"] = filter->GetStatus();
  }
  file["evaluations"] = file["evaluations"].get<long long>() + filter->GetEvaluations();
  file["dispatches"] = file["dispatches"].get<long long>() + filter->GetDispatches();
  messages.AddFilter(filter);
}

void IntegrateUsers(vtkCADReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages)
{
  const auto run = [&](vtkSurfaceIntegralGPU* filter)
  {
    SetUpFilter(filter, options);
    filter->SetRelativeTolerance(options.Tolerance);
    filter->SetInputConnection(reader->GetOutputPort());
    update(filter);
  };
  for (vtkSurfaceIntegralGPU* filter : MakeFilters(options))
  {
    if (filter->GetNumberOfIntegrands() > 0)
    {
      run(filter);
      Report(filter, file, messages);
    }
  }
}
}
