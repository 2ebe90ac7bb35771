/**
 * @class   vtkNURBSModelWriter
 * @brief   base class of the writers of exact geometry, vtkSTEPWriter and vtkBREPWriter
 *
 * The input is a vtkNURBSDataSet or a composite dataset of them, for example the output of vtkSTEPReader,
 * vtkNURBSTransform or vtkNURBSDeform, or an edited dataset (smModelEdit.h). The exact geometry is saved, not
 * the mesh:
 *
 * - every face as the plane, cylinder, cone, sphere or torus it is, or as a rational B-spline surface,
 * trimmed by its own (u,v) curves and the 3D curves of its edges, which are lines, circles or piecewise
 * polynomials; edges and vertices shared, seams and poles where the surface closes; solids with their voids,
 * and free shells. A void with the orientation of the outer shell is reversed if the orientations of both
 * are certain, and that the void is inside the outer shell and in no other void; otherwise it is written as
 * it is, with a warning. Tolerances are measured: the largest distance of a face from its edge.
 * - leaves of one model as instances of one part. A mirrored instance is written as a part of its own,
 * because files hold rigid placements only; a message reports it.
 * - a body that an edit opened is written as it is, with a warning.
 *
 * Geometry that is saved and read again differs by rounding: the same faces, edges and trim curves with
 * coordinates good to a few 1e-16 of their distance from the part's origin. Planes, cylinders, cones, spheres
 * and tori, which the reader makes rational B-splines, are recognized by their control points, also after
 * they were moved, mirrored or scaled; what an edit deformed is a B-spline. So are swept surfaces. Each piece
 * of a trim or edge curve is one span of the B-spline that is written, so that curves are continuous to their
 * pieces' accuracy but not formally smooth there. Validation properties (volume and area that the first
 * system stated) are not written: after an edit they would be wrong.
 *
 * A temporary file in the same folder is written and replaces FileName when it is complete. If that fails,
 * Write() returns 0, one error has the name of the file and a remedy, GetErrorCode() is not
 * vtkErrorCode::NoError, and an existing file is unchanged: | GetErrorCode() | when |
 * |---|---|
 * | NoFileNameError | FileName is empty |
 * | UserError | no input, one without exact geometry, or an unknown unit |
 * | CannotOpenFileError | no file can be made there, or writing failed although the disk is not full |
 * | OutOfDiskSpaceError | the disk is full |
 * | UnknownError | OpenCASCADE failed or is not installed, out of memory, or the application asked to stop |
 *
 * No exception leaves Write().
 *
 * OpenCASCADE writes in a process of its own (solidmoments-kernel). Under MPI call Write() in every process
 * with SetNumberOfPieces() and SetPiece(), as ParaView does: each updates its own piece of the input, and the
 * first one, where vtkSTEPReader and our filters have all solids, writes the file. No OpenGL context is
 * needed.
 */
#ifndef vtkNURBSModelWriter_h
#define vtkNURBSModelWriter_h

#include "smReadersKernelModule.h"
#include "vtkWriter.h"

#include <memory> // for the messages
#include <string> // for std::string
#include <vector> // for the warnings

namespace sm
{
enum class ExportFormat;
struct ExportOptions;
struct ExportTree;
}

class SMREADERSKERNEL_EXPORT vtkNURBSModelWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkNURBSModelWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the file. Default: none. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * The piece of the input to update, from 0, of how many: rank and number of MPI processes. If Piece is
   * not 0, the input is updated, nothing is written, and Write() returns 1, unless FileName or the input is
   * missing. Values are clamped, the number to 1 or more, the piece to 0 or more. Default: 0 of 1.
   */
  vtkSetClampMacro(Piece, int, 0, VTK_INT_MAX);
  vtkGetMacro(Piece, int);
  vtkSetClampMacro(NumberOfPieces, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfPieces, int);
  ///@}

  /** Updates the input and writes it. Returns 1 when the file was written whole, else 0. */
  int Write() override;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

  ///@{
  /** Messages of the last Write(), one sentence each; an error is the last one. An index out of range gives
   * an empty string. */
  int GetNumberOfMessages() const;
  std::string GetMessage(int index) const;
  ///@}

  /** Faces in the last file: of STEP those of each part once, of BREP those of each instance; 0 before the
   * first. */
  int GetNumberOfFaces() const;

protected:
  vtkNURBSModelWriter();
  ~vtkNURBSModelWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  /// Unit of the file's lengths.
  virtual std::string ChooseUnit(const sm::ExportTree& tree) = 0;
  virtual sm::ExportFormat GetFormat() const = 0;

private:
  vtkNURBSModelWriter(const vtkNURBSModelWriter&) = delete;
  void operator=(const vtkNURBSModelWriter&) = delete;

  void Fail(unsigned long code, const std::string& problem);
  void WriteFile();
  /// Returns false, after an error, if the input cannot be written.
  bool MakeOptions(const sm::ExportTree& tree, sm::ExportOptions& options);
  /// Keeps the warnings as messages and raises one VTK warning.
  void Warn(const std::vector<std::string>& warnings);

  char* FileName = nullptr;
  int Piece = 0;
  int NumberOfPieces = 1;
  struct Results;
  std::unique_ptr<Results> Last;
};

#endif
