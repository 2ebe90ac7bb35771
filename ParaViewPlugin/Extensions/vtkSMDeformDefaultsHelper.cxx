#include "vtkSMDeformDefaultsHelper.h"

#include "smInputBounds.h"

#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSMDeformDefaultsHelper);

vtkSMDeformDefaultsHelper::vtkSMDeformDefaultsHelper() = default;
vtkSMDeformDefaultsHelper::~vtkSMDeformDefaultsHelper() = default;

void vtkSMDeformDefaultsHelper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

namespace
{
/// Returns a tenth of a length, rounded to one digit.
double TakeTenth(double length)
{
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return 0.0;
  }
  const double power = std::pow(10.0, std::floor(std::log10(0.1 * length)));
  return std::round(0.1 * length / power) * power;
}
}

void vtkSMDeformDefaultsHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType initializationTimeStamp)
{
  double lengths[3] = { 0.0, 0.0, 0.0 };
  const vtkBoundingBox box = sm::ComputeInputBounds(proxy);
  if (box.IsValid())
  {
    box.GetLengths(lengths);
  }
  const double along = TakeTenth(lengths[0]);
  const double up = TakeTenth(lengths[2]);
  const auto isUntouched = [proxy, initializationTimeStamp](const char* name)
  { return proxy->GetProperty(name)->GetMTime() <= initializationTimeStamp; };
  if (isUntouched("Displacement"))
  {
    const double displacement[] = { 0.0, 0.0, up };
    vtkSMPropertyHelper(proxy, "Displacement").Set(displacement, 3);
  }
  if (isUntouched("LatticeDisplacements") && isUntouched("LatticeSize"))
  {
    double rows[4][6] = {};
    for (int corner = 0; corner < 4; ++corner)
    {
      const double row[] = { double(corner % 2), double(corner / 2), 1.0, along, 0.0, 0.0 };
      std::copy(row, row + 6, rows[corner]);
    }
    vtkSMPropertyHelper(proxy, "LatticeDisplacements").Set(rows[0], 24);
  }
  proxy->UpdateVTKObjects();
}
