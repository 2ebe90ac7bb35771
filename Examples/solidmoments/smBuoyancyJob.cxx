#include "smBuoyancyJob.h"

#include "smBuoyancyNames.h"
#include "smMessageList.h"
#include "smQuantities.h"
#include "smUserIntegrals.h"

#include "vtkBuoyancy.h"
#include "vtkCADReader.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using sm::Json;
namespace names = sm::names;

/// Returns the results in a row of field data or of a table.
Json Describe(vtkFieldData* data, vtkIdType row)
{
  const std::string bound = names::BoundSuffix;
  Json found;
  found["volume"] = sm::GetNumber(data, row, names::DisplacedVolume);
  found["center"] = sm::GetPoint(data, row, names::CenterOfBuoyancy);
  found["bounds"] = { { "volume", sm::GetNumber(data, row, names::DisplacedVolume + bound) },
    { "center", sm::GetNumber(data, row, names::CenterOfBuoyancy + bound) } };
  return found;
}
}

namespace sm
{
void RunPlaneCut(vtkCADReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, vtkPlaneCutBase* filter, const RowWriter& write,
  Json& file, MessageList& messages)
{
  SetUpFilter(filter, options);
  filter->SetInputConnection(reader->GetOutputPort());
  update(filter);
  write(filter->GetOutput()->GetFieldData(), 0, file);
  vtkIdType row = 0;
  for (Json& solid : file["solids"])
  {
    write(vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetRowData(), row, solid);
    ++row;
  }
  AddEffort(filter, file, messages);
}

void IntegrateBelowWaterlines(vtkCADReader* reader, const JobOptions& options,
  const std::function<void(vtkAlgorithm*)>& update, Json& file, MessageList& messages)
{
  if (options.Waterlines.empty())
  {
    return;
  }
  const std::array<double, 3>& up = options.Up;
  const double largest = std::max({ std::abs(up[0]), std::abs(up[1]), std::abs(up[2]) });
  const std::array<double, 3> scaled = { up[0] / largest, up[1] / largest, up[2] / largest };
  const double length = std::hypot(scaled[0], scaled[1], scaled[2]);
  vtkNew<vtkBuoyancy> filter;
  filter->SetRelativeTolerance(options.Tolerance);
  filter->SetNormal(scaled.data());
  for (std::size_t i = 0; i < options.Waterlines.size(); ++i)
  {
    const double along = options.Waterlines[i] / length;
    filter->SetPoint(along * scaled[0], along * scaled[1], along * scaled[2]);
    RunPlaneCut(
      reader, options, update, filter,
      [i](vtkFieldData* data, vtkIdType row, Json& entry)
      { entry["waterlines"][i].update(Describe(data, row)); },
      file, messages);
  }
}
}
