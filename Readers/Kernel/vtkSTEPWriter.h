/**
 * @class   vtkSTEPWriter
 * @brief   writes exact trimmed NURBS models as STEP (AP214)
 *
 * vtkNURBSModelWriter documents the geometry that is saved, and errors. STEP holds, besides the geometry, the
 * product structure (names, instances with their placements, layers), colours of bodies, faces and instances,
 * material and density, and the names and entity numbers (#1234) of bodies, faces and edges, which are kept
 * when a file is read and saved. Densities are written in g/cm^3. If a material's name occurs with a second
 * density, a number is appended: "Steel (2)". Numbers have 17 digits. An assembly that occurs several times
 * is written once for each: the placements of its parts are exact, their grouping as one assembly is lost.
 * The schema is AP214 (AUTOMOTIVE_DESIGN), which holds all of this and which every system reads.
 */
#ifndef vtkSTEPWriter_h
#define vtkSTEPWriter_h

#include "smProgressCallback.h"
#include "smReadersKernelModule.h"
#include "vtkNURBSModelWriter.h"

class SMREADERSKERNEL_EXPORT vtkSTEPWriter : public vtkNURBSModelWriter
{
public:
  static vtkSTEPWriter* New();
  vtkTypeMacro(vtkSTEPWriter, vtkNURBSModelWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Unit of the file's lengths: "mm", "cm", "m", "um", "inch", "ft", "model" for the unit of the input, which
   * scales nothing, or "file" (default) for the unit of the file that the first body was read from, and that
   * of the input where it was read from none. Write() raises an error for any other word.
   */
  vtkSetMacro(OutputUnit, std::string);
  vtkGetMacro(OutputUnit, std::string);
  ///@}

  static const char* GetFileExtensions() { return ".step .stp"; }
  static const char* GetDescriptiveName() { return "STEP"; }

protected:
  vtkSTEPWriter();
  ~vtkSTEPWriter() override;

  std::string ChooseUnit(const sm::ExportTree& tree) override;
  sm::ExportFormat GetFormat() const override;

private:
  vtkSTEPWriter(const vtkSTEPWriter&) = delete;
  void operator=(const vtkSTEPWriter&) = delete;

  std::string OutputUnit = "file";
};

#endif
