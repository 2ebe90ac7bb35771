#include "vtkSMDeformDefaultsHelper.h"

#include "smInputBounds.h"

#include "vtkObjectFactory.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include <algorithm>

vtkStandardNewMacro(vtkSMDeformDefaultsHelper);

vtkSMDeformDefaultsHelper::vtkSMDeformDefaultsHelper() = default;
vtkSMDeformDefaultsHelper::~vtkSMDeformDefaultsHelper() = default;

void vtkSMDeformDefaultsHelper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

void vtkSMDeformDefaultsHelper::PostInitializeProxy(
  vtkSMProxy* proxy, vtkPVXMLElement*, vtkMTimeType initializationTimeStamp)
{
  const auto isUntouched = [proxy, initializationTimeStamp](const char* name)
  { return proxy->GetProperty(name)->GetMTime() <= initializationTimeStamp; };
  if (isUntouched("LatticeDisplacements") && isUntouched("LatticeSize"))
  {
    // The points of the top, which move by nothing until a number is typed.
    double rows[4][6] = {};
    for (int corner = 0; corner < 4; ++corner)
    {
      const double row[] = { double(corner % 2), double(corner / 2), 1.0, 0.0, 0.0, 0.0 };
      std::copy(row, row + 6, rows[corner]);
    }
    vtkSMPropertyHelper(proxy, "LatticeDisplacements").Set(rows[0], 24);
  }
  // A script that says what moves says also where.
  const vtkBoundingBox box = sm::ComputeInputBounds(proxy);
  double center[] = { 0.0, 0.0, 0.0 };
  if (isUntouched("Displacement") && isUntouched("Radius") && isUntouched("Center") && box.IsValid())
  {
    box.GetCenter(center);
    vtkSMPropertyHelper(proxy, "Radius").Set(0.25 * box.GetDiagonalLength());
  }
  if (isUntouched("Center"))
  {
    vtkSMPropertyHelper(proxy, "Center").Set(center, 3);
  }
  if (isUntouched("Displacement"))
  {
    const double none[] = { 0.0, 0.0, 0.0 };
    vtkSMPropertyHelper(proxy, "Displacement").Set(none, 3);
  }
  proxy->UpdateVTKObjects();
}
