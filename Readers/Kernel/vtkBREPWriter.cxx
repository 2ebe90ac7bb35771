#include "vtkBREPWriter.h"

#include "smExport.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkBREPWriter);

vtkBREPWriter::vtkBREPWriter() = default;

vtkBREPWriter::~vtkBREPWriter() = default;

std::string vtkBREPWriter::ChooseUnit(const sm::ExportTree&)
{
  return "mm";
}

sm::ExportFormat vtkBREPWriter::GetFormat() const
{
  return sm::ExportFormat::BREP;
}
