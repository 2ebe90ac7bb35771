#include "vtkSTEPWriter.h"

#include "smExportTree.h"
#include "smOCCTExport.h"

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

sm::ExportResult vtkSTEPWriter::WriteTree(const sm::ExportTree& tree, const sm::ExportOptions& options,
  std::ostream& stream, const sm::ProgressCallback& progress)
{
  return sm::WriteSTEP(tree, options, stream, progress);
}

void vtkSTEPWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputUnit: " << this->OutputUnit << "\n";
}
