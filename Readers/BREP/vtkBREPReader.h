/**
 * @class   vtkBREPReader
 * @brief   reads OpenCASCADE's BREP files, text and binary, into exact trimmed NURBS models with a display
 * mesh
 *
 * vtkCADReader documents the output, errors, and how a file is read from memory. OpenCASCADE reads the file
 * in a process of its own.
 * The format has no names, units, colours, materials or tolerances of coordinates: bodies are called "Solid"
 * or "Shell", and InputUnit is the unit of the numbers. Nested compounds become the product structure, and a
 * shape that occurs several times is one model with several instances.
 *
 * The shapes are taken as they are, without OpenCASCADE's repairs, and the format has no declarations with
 * which the result could be compared: damage of a file is detected only by its geometry (gaps, open edges,
 * shells that cross). A text that is not complete is refused.
 */
#ifndef vtkBREPReader_h
#define vtkBREPReader_h

#include "smReadersBREPModule.h"
#include "vtkCADReader.h"

class SMREADERSBREP_EXPORT vtkBREPReader : public vtkCADReader
{
public:
  static vtkBREPReader* New();
  vtkTypeMacro(vtkBREPReader, vtkCADReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** 1 if the file begins like a BREP file, or if its name ends as one of GetFileExtensions() and it does not
   * begin like a STEP file: then reading reports what is wrong with it. Otherwise 0. */
  static int CanReadFile(const char* fileName);
  /** 1 if the bytes begin like a BREP file, otherwise 0. */
  static int CanReadContent(const std::string& content);
  static const char* GetFileExtensions() { return ".brep .brp"; }
  static const char* GetDescriptiveName() { return "OpenCASCADE BREP"; }

  ///@{
  /** Unit of the file's lengths, as GetFileUnit() and the models say it: "mm" (default, as most programs
   * write it), "cm", "m", "um", "inch" or "ft". Update() raises an error for any other word. */
  vtkSetMacro(InputUnit, std::string);
  vtkGetMacro(InputUnit, std::string);
  ///@}

protected:
  vtkBREPReader();
  ~vtkBREPReader() override;

  const char* GetFormatName() const override { return "BREP"; }
  std::string FindMistakeOfHead(const std::string& head) const override;
  sm::Document ReadDocument(std::string content, const sm::ProgressCallback& progress) override;
  std::string FindMistakeOfFormat() const override;

private:
  vtkBREPReader(const vtkBREPReader&) = delete;
  void operator=(const vtkBREPReader&) = delete;

  std::string InputUnit = "mm";
};

#endif
