#include "vtkBREPWriter.h"

#include "smExportTree.h"
#include "smOCCTExport.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBREPWriter);

vtkBREPWriter::vtkBREPWriter() = default;

vtkBREPWriter::~vtkBREPWriter() = default;

std::string vtkBREPWriter::ChooseUnit(const sm::ExportTree&)
{
  return "mm";
}

sm::ExportResult vtkBREPWriter::WriteTree(const sm::ExportTree& tree, const sm::ExportOptions& options,
  std::ostream& stream, const sm::ProgressCallback& progress)
{
  return sm::WriteBREP(tree, options, stream, progress);
}
