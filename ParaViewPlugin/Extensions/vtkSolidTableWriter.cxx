#include "vtkSolidTableWriter.h"

#include "smColumnUnits.h"
#include "smIntegralNames.h"

#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <string>

vtkStandardNewMacro(vtkSolidTableWriter);

namespace
{
/// Returns the length unit of all rows; empty if they have different ones, or none.
std::string FindUnit(vtkTable* table)
{
  auto* units = vtkStringArray::SafeDownCast(table->GetColumnByName(sm::names::LengthUnit));
  for (vtkIdType row = 1; units && row < units->GetNumberOfValues(); ++row)
  {
    if (units->GetValue(row) != units->GetValue(0))
    {
      return {};
    }
  }
  return units && units->GetNumberOfValues() > 0 ? std::string(units->GetValue(0)) : std::string();
}

/// Returns the table with units in the names of its columns.
vtkSmartPointer<vtkTable> NameUnits(vtkTable* table)
{
  const std::string unit = FindUnit(table);
  auto named = vtkSmartPointer<vtkTable>::New();
  named->GetFieldData()->ShallowCopy(table->GetFieldData());
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = table->GetColumn(i);
    const std::string name = column->GetName() ? column->GetName() : "";
    const std::string own = unit.empty() ? std::string() : sm::GetColumnUnit(name, unit);
    if (own.empty())
    {
      named->AddColumn(column);
      continue;
    }
    const auto copy = vtkSmartPointer<vtkAbstractArray>::Take(column->NewInstance());
    copy->DeepCopy(column);
    copy->SetName((name + " (" + own + ")").c_str());
    named->AddColumn(copy);
  }
  return named;
}
}

vtkSolidTableWriter::vtkSolidTableWriter()
{
  this->SetPrecision(17);
}

vtkSolidTableWriter::~vtkSolidTableWriter() = default;

void vtkSolidTableWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

int vtkSolidTableWriter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  const vtkSmartPointer<vtkDataObject> input = info ? info->Get(vtkDataObject::DATA_OBJECT()) : nullptr;
  vtkTable* table = vtkTable::SafeDownCast(input);
  if (!table)
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  // The superclass writes the input's own names.
  info->Set(vtkDataObject::DATA_OBJECT(), NameUnits(table));
  const int done = this->Superclass::RequestData(request, inputVector, outputVector);
  info->Set(vtkDataObject::DATA_OBJECT(), input);
  return done;
}
