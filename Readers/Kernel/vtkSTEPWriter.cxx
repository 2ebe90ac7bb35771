#include "vtkSTEPWriter.h"

#include "smExport.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSTEPWriter);

vtkSTEPWriter::vtkSTEPWriter() = default;

vtkSTEPWriter::~vtkSTEPWriter() = default;

std::string vtkSTEPWriter::ChooseUnit(const sm::ExportTree& tree)
{
  const bool known = this->OutputUnit == "file" && !tree.FileUnit.empty();
  return known                                                  ? tree.FileUnit
    : this->OutputUnit == "file" || this->OutputUnit == "model" ? tree.LengthUnit
                                                                : this->OutputUnit;
}

sm::ExportFormat vtkSTEPWriter::GetFormat() const
{
  return sm::ExportFormat::STEP;
}

void vtkSTEPWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputUnit: " << this->OutputUnit << "\n";
}
