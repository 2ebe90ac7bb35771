#include "smProductResults.h"

#include "smMassPropertyNames.h"
#include "smProductBodies.h"

#include "vtkBoundingBox.h"
#include "vtkDataSetAttributes.h"
#include "vtkMassPropertiesBase.h"
#include "vtkNURBSDataSet.h"
#include "vtkTable.h"

namespace sm
{
ProductResults ReadProductResults(vtkMassPropertiesBase* filter)
{
  ProductResults results;
  vtkFieldData* fields = filter->GetOutputDataObject(0)->GetFieldData();
  results.Status = filter->GetStatus();
  results.LengthUnit = GetText(fields, 0, names::LengthUnit);
  results.Diagonal = GetDiagonal(filter->GetInputDataObject(0, 0));
  results.Total = ReadQuantities(fields, 0);
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  vtkDataSetAttributes* columns = table->GetRowData();
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    results.Solids.push_back({ GetText(columns, row, names::Id), GetText(columns, row, names::Name),
      GetText(columns, row, names::Status), ReadQuantities(columns, row) });
  }
  return results;
}

double GetDiagonal(vtkDataObject* input)
{
  vtkBoundingBox box;
  for (const ProductBody& body : ListBodies(input))
  {
    double bounds[6];
    if (body.Leaf->GetBodyBounds(bounds))
    {
      box.AddBounds(bounds);
    }
  }
  return box.IsValid() ? box.GetDiagonalLength() : Unknown;
}
}
