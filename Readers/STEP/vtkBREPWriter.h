/**
 * @class   vtkBREPWriter
 * @brief   writes exact trimmed NURBS models in OpenCASCADE's BREP text format
 *
 * See vtkNURBSModelWriter for what is saved, and how a failure shows. The file is one compound of all instances where they
 * stand, which share their geometry; the tolerances of edges and vertices are in it, too. The format knows no units: lengths are
 * in mm, as programs that read it expect. It knows no names, colours or products: use vtkSTEPWriter for those.
 */
#ifndef vtkBREPWriter_h
#define vtkBREPWriter_h

#include "smProgressCallback.h"
#include "smReadersSTEPModule.h"
#include "vtkNURBSModelWriter.h"

class SMREADERSSTEP_EXPORT vtkBREPWriter : public vtkNURBSModelWriter
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
  sm::ExportResult WriteTree(const sm::ExportTree& tree, const sm::ExportOptions& options,
    std::ostream& stream, const sm::ProgressCallback& progress) override;

private:
  vtkBREPWriter(const vtkBREPWriter&) = delete;
  void operator=(const vtkBREPWriter&) = delete;
};

#endif
