/**
 * @class   vtkSTEPReader
 * @brief   reads STEP files (AP203, AP214, AP242) into exact trimmed NURBS models with a display mesh
 *
 * vtkCADReader documents the output, errors, and how it is read from memory.
 *
 * Every solid that the entities of the file declare is accounted for, with its faces and instances
 * (smSTEPCensusReport.h). Losses, and contradictions within the file, are reported by messages and make the
 * results of all filters suspect: the string arrays FileStatus, FileProblem and FileDefects in the field data
 * of the output pass them on (smFileState.h). A file of more than 100,000 instances of bodies and
 * sub-assemblies cannot be read.
 *
 * OpenCASCADE repairs bodies that are not sound, in a process of its own, since it may crash or hang on
 * damaged geometry. Faces whose entities are damaged are left out before.
 */
#ifndef vtkSTEPReader_h
#define vtkSTEPReader_h

#include "smReadersSTEPModule.h"
#include "vtkCADReader.h"

class vtkTable;

class SMREADERSSTEP_EXPORT vtkSTEPReader : public vtkCADReader
{
public:
  static vtkSTEPReader* New();
  vtkTypeMacro(vtkSTEPReader, vtkCADReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** 1 if the file's first 64 kB hold the header of a STEP file, or if its name ends as one of
   * GetFileExtensions(): then reading reports what is wrong with it. Otherwise 0. */
  static int CanReadFile(const char* fileName);
  /** 1 if the first 64 kB hold the header of a STEP file, otherwise 0. */
  static int CanReadContent(const std::string& content);
  /**
   * Adds a row to `table` for each product of the file, with what the file states of it: `Product` (its
   * name), `Definition` (entity number), the validation properties `Volume`, `Area` and `Centroid` (3
   * components) in millimetres and the product's own coordinates, NaN if not stated, and `VolumeProblem`,
   * `AreaProblem`, `CentroidProblem` (why the statements of that quantity cannot be used; empty if they can).
   * Returns false, and adds no rows, if the file has no text of STEP.
   */
  static bool ReadStatedProducts(const char* fileName, vtkTable* table);

  static const char* GetFileExtensions() { return ".step .stp .p21"; }
  static const char* GetDescriptiveName() { return "STEP"; }

  ///@{
  /**
   * ON_NEED (default): OpenCASCADE repairs only solids and shells with defects, whose entity numbers are in a
   * message; all others are converted without a repair, with missing trim curves in closed form, which is
   * faster and more accurate. ALWAYS: it repairs all shapes of the file and computes missing trim curves.
   * NEVER: none is repaired; of a solid or shell with defects those faces are read that are sound, and the
   * result is suspect. A body of which the repair fails is read so, too.
   */
  enum RepairType
  {
    ALWAYS = 0,
    ON_NEED = 1,
    NEVER = 2
  };
  vtkSetClampMacro(Repair, int, ALWAYS, NEVER);
  vtkGetMacro(Repair, int);
  ///@}

  /** The bodies that are read, by INVISIBILITY. */
  enum HiddenType
  {
    COUNT_HIDDEN = 0,
    SKIP_HIDDEN = 1,
    ONLY_HIDDEN = 2
  };

  ///@{
  /**
   * What happens to bodies that the file hides (INVISIBILITY): by their style, their layer or their
   * representation, or with an occurrence above them. COUNT_HIDDEN, the default: they count like the others,
   * and a message reports them. SKIP_HIDDEN: they are left out. ONLY_HIDDEN: the others are left out. A
   * message has the number and the names of the bodies that are left out; where all are, the status is
   * EMPTY. Range [COUNT_HIDDEN, ONLY_HIDDEN], clamped.
   */
  vtkSetClampMacro(Hidden, int, COUNT_HIDDEN, ONLY_HIDDEN);
  vtkGetMacro(Hidden, int);
  ///@}

  ///@{
  /**
   * Folders in which files are looked for that the file names as the shapes of parts of its assembly, with
   * colons between them; those in the folder of the file itself are found without (empty, default). No
   * absolute path in a file, and none with "..", is followed: only its last part counts. Files that are not
   * found are reported, and the result is suspect. Not used with SetContent().
   */
  vtkSetStringMacro(SearchFolders);
  vtkGetStringMacro(SearchFolders);
  ///@}

protected:
  vtkSTEPReader();
  ~vtkSTEPReader() override;

  const char* GetFormatName() const override { return "STEP"; }
  std::string FindMistakeOfHead(const std::string& head) const override;
  sm::Document ReadDocument(std::string content, const sm::ProgressCallback& progress) override;

private:
  vtkSTEPReader(const vtkSTEPReader&) = delete;
  void operator=(const vtkSTEPReader&) = delete;

  int Repair = ON_NEED;
  int Hidden = COUNT_HIDDEN;
  char* SearchFolders = nullptr;
};

#endif
