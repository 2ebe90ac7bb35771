/**
 * @class   vtkBREPWriter
 * @brief   writes exact trimmed NURBS models in OpenCASCADE's BREP text format
 *
 * vtkNURBSModelWriter documents the geometry that is saved, and errors. The file is one compound of all
 * placed instances, which share their geometry, with the tolerances of edges and vertices. The format has no
 * units: lengths are in mm, as programs that read it expect. It has no names, colours or products either: use
 * vtkSTEPWriter for those.
 */
#ifndef vtkBREPWriter_h
#define vtkBREPWriter_h

#include "smProgressCallback.h"
#include "smReadersKernelModule.h"
#include "vtkNURBSModelWriter.h"

class SMREADERSKERNEL_EXPORT vtkBREPWriter : public vtkNURBSModelWriter
{
public:
  static vtkBREPWriter* New();
  vtkTypeMacro(vtkBREPWriter, vtkNURBSModelWriter);

  static const char* GetFileExtensions() { return ".brep .brp"; }
  static const char* GetDescriptiveName() { return "OpenCASCADE BREP"; }

protected:
  vtkBREPWriter();
  ~vtkBREPWriter() override;

  std::string ChooseUnit(const sm::ExportTree& tree) override;
  sm::ExportFormat GetFormat() const override;

private:
  vtkBREPWriter(const vtkBREPWriter&) = delete;
  void operator=(const vtkBREPWriter&) = delete;
};

#endif
