#include "Outputs/smEmptyRanges.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"

#include <cmath>

namespace sm
{
namespace
{
bool IsUnknown(vtkDataArray* array)
{
  const int components = array->GetNumberOfComponents();
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      if (!std::isnan(array->GetComponent(i, k)))
      {
        return false;
      }
    }
  }
  return array->GetNumberOfTuples() > 0;
}

void MarkArrays(vtkFieldData* arrays)
{
  for (int i = 0; arrays && i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    if (array && array->GetNumberOfComponents() > 1 && IsUnknown(array))
    {
      double empty[2] = { VTK_DOUBLE_MAX, VTK_DOUBLE_MIN };
      array->GetInformation()->Set(vtkDataArray::L2_NORM_RANGE(), empty, 2);
      array->GetInformation()->Set(vtkDataArray::L2_NORM_FINITE_RANGE(), empty, 2);
    }
  }
}
}

void MarkEmptyRanges(vtkDataObject* data)
{
  for (int type = 0; type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
  {
    MarkArrays(data->GetAttributesAsFieldData(type));
  }
}
}
