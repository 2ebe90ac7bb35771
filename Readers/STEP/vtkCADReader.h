/**
 * @class   vtkCADReader
 * @brief   base class of the readers of exact solids, vtkSTEPReader and vtkBREPReader
 *
 * The output is a vtkPartitionedDataSetCollection with one partitioned dataset per solid instance; its
 * partition 0 is a vtkNURBSDataSet. A file without solids gives one per free shell instead. The name of a
 * partitioned dataset (vtkCompositeDataSet::NAME()) is that of the product, with a number where it repeats:
 * `nut (1)`, `nut (2)`. A vtkDataAssembly mirrors the product structure: its node names are valid XML names,
 * the attribute "label" has the name in the file, with a number where siblings have the same one, and then
 * "name" the name itself; "layer" has its layer; "placement", of STEP files, twelve numbers, the rows of the
 * matrix from the product to the world. Every leaf has its name in the file and its path in the
 * product structure (vtkNURBSDataSet::GetPartName(), GetPartPath()). Instances of one part share a
 * vtkTrimmedNURBSModel, which stays in the coordinates of the part.
 *
 * Surfaces become rational B-splines without error; a surface that has no such form (an offset surface) is
 * fitted, with NURBSSurface::Residual as the error of the fit. Trim and edge curves are exact polynomials, or
 * fitted to rounding level with TrimCurve::Residual as the error. See Documentation/Numerics.md.
 *
 * Arrays of each leaf, besides those vtkNURBSDataSet documents:
 * | name | association | components | meaning |
 * |---|---|---|---|
 * | Normals | point | 3 (float) | outward unit normal of the exact surface |
 * | Color | cell | 3 (uchar) | sRGB colour of the face; only when the file gives the body a colour |
 *
 * Points are in world coordinates and OutputUnit. A face that cannot be carried over is left out and named in
 * the messages of its model (vtkTrimmedNURBSModel::GetMessages); nothing else is lost. Faces outside the
 * solids of a file belong to no body: they are counted (GetNumberOfFreeFaces) and left out.
 *
 * A file that cannot be read raises one error, with its name and a remedy; the output is then empty,
 * GetStatus() has the reason, and GetErrorCode() is not 0. The pipeline continues, so that filters do not
 * keep the results of the previous file: their status becomes unreadable, not-computed or empty. No exception
 * leaves Update(): an exception of OpenCASCADE, of an observer, or for lack of memory is such an error.
 *
 * Under MPI, all ranks have the same tree: as many partitioned datasets, the same names, the same assembly.
 * The leaves are on the rank that asks for the first piece; on the others every partition is null. Status,
 * messages and counts are the same on all ranks. For that the ranks of the global controller talk to each
 * other when the number of pieces is the number of ranks, so all of them must update the reader; each asks
 * for a piece of its own. With any other number of pieces a rank is updated for itself, and pieces beyond the
 * first are empty collections. A file that cannot be read is an error on the rank that reads it, and the
 * output is empty on all. If one rank has not enough memory for the tree, that is an error on all ranks.
 *
 * Readers on several threads read at the same time, and conversion uses vtkSMPTools. No OpenGL context is
 * needed.
 *
 * OpenCASCADE works in a process of its own (solidmoments-kernel), which is started when a body needs a
 * repair, and for a BREP file. If it crashes, does not answer in time or is not installed, the body is read
 * as far as its faces are sound, and the result is suspect; a BREP file is an error.
 *
 * The display mesh is made of the exact model: every edge is sampled once and its points are shared by its
 * faces with the same bits, so that a closed solid has a closed mesh; the field array MeshDeviation holds a
 * proved bound for each face of the distance of its triangles from the surface, across it (vtkNURBSDataSet).
 * A body whose faces are not complete has GetNumberOfMissingFaces() or GetNumberOfDefects() above 0 in its
 * model.
 *
 * The mesh is made on demand (SetDisplayMesh): as long as only filters that work with the exact geometry are
 * connected, the leaves have no points and triangles. A view or another filter that is connected later, to
 * the reader or to an output with meshes of such a filter, gets it at its next update, without reading the
 * file again. Update() of the reader itself makes it, too. The scale mesh of each model
 * (vtkTrimmedNURBSModel::GetScaleMesh) is always made: the scales of all tolerances are computed from it, and
 * filters use it to decide if shells cross themselves or enclose each other, so that their results have the
 * same bits with and without a display mesh.
 *
 * Memory: for each point of the scale mesh 56 bytes and for each triangle 36, once a model; for each point of
 * a display mesh 36 bytes more for each instance, and for a mesh with other limits than the scale mesh's, a
 * colour, or a mirrored instance, arrays once a model. GetActualMemorySize() of the output includes all of
 * it; that of a leaf includes its model.
 */
#ifndef vtkCADReader_h
#define vtkCADReader_h

#include "smProgressCallback.h"
#include "smReadersSTEPModule.h"
#include "vtkPartitionedDataSetCollectionAlgorithm.h"
#include "vtkTimeStamp.h" // for the time of the mesh

#include <memory>      // for the messages and results
#include <string>      // for std::string
#include <string_view> // for problems
#include <vector>      // for the bodies

class vtkMultiProcessController;

namespace sm
{
class LeafMaker;
struct Document;
struct LeafOptions;
}

class SMREADERSSTEP_EXPORT vtkCADReader : public vtkPartitionedDataSetCollectionAlgorithm
{
public:
  vtkTypeMacro(vtkCADReader, vtkPartitionedDataSetCollectionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Path of the file. Default: none. Without one Update() raises an error. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** The bytes of a file in memory: until ClearContent() they are read in place of a file, also if there are
   * none, and FileName, where there is one, only names them in messages and in the assembly. In a parallel
   * run the rank that requests the first piece needs them. Default: no content. */
  void SetContent(const std::string& bytes);
  void ClearContent();
  bool HasContent() const { return this->IsContentGiven; }
  ///@}

  /** Conditions under which leaves get points and triangles. */
  enum DisplayMeshType
  {
    MESH_BY_NEED = 0,
    MESH_ALWAYS = 1,
    MESH_NEVER = 2
  };

  ///@{
  /**
   * When the display mesh is made. MESH_BY_NEED: if something connected needs it, or after Update() of the
   * reader (see above). MESH_ALWAYS, MESH_NEVER: independent of connections; without a mesh a view shows
   * nothing. A change of this and of the four settings below does not read the file again. Range
   * [MESH_BY_NEED, MESH_NEVER], clamped. Default: MESH_BY_NEED; MESH_ALWAYS in ParaView, which asks for every
   * output before it shows.
   */
  void SetDisplayMesh(int when);
  vtkGetMacro(DisplayMesh, int);
  void SetDisplayMeshToByNeed() { this->SetDisplayMesh(MESH_BY_NEED); }
  void SetDisplayMeshToAlways() { this->SetDisplayMesh(MESH_ALWAYS); }
  void SetDisplayMeshToNever() { this->SetDisplayMesh(MESH_NEVER); }
  ///@}

  ///@{
  /**
   * For large assemblies: if the display mesh of all instances would have more triangles than this (as their
   * scale meshes have, more where the deflection is finer), a coarser one is made, within 1e-3 of the
   * diagonal of all solids together and with angles of up to 1.2. It is drawn fast and takes little memory;
   * exact results are the same. With Refined the mesh asked for is made in any case. At least 0, clamped; 0,
   * the default: no limit; 5 million in ParaView.
   */
  void SetCoarseAbove(vtkIdType triangles);
  vtkGetMacro(CoarseAbove, vtkIdType);
  void SetRefined(bool isRefined);
  vtkGetMacro(Refined, bool);
  vtkBooleanMacro(Refined, bool);
  /** Returns true if the last display mesh is coarser than requested. */
  bool IsMeshCoarse() const { return this->MeshIsCoarse; }
  ///@}

  ///@{
  /**
   * Largest distance of the display mesh from the surface: a fraction of the part's bounding-box diagonal
   * when RelativeDeflection is on (default), else a length in OutputUnit. Clamped to [1e-30, 1e30]; 0, less
   * and NaN give the default, 0.001. The mesher gets no less than 1e-5 of the diagonal, with a message. Faces
   * with gaps to their edges may be farther away: the field array MeshDeviation has a bound of their
   * distance. The deflection does not affect the exact geometry.
   */
  void SetLinearDeflection(double deflection);
  vtkGetMacro(LinearDeflection, double);
  void SetRelativeDeflection(bool isRelative);
  vtkGetMacro(RelativeDeflection, bool);
  vtkBooleanMacro(RelativeDeflection, bool);
  ///@}

  ///@{
  /** Angle between neighbouring triangles, in radians, that the mesh is made for where the deflection would
   * allow more; aimed at, not proved. Clamped to [0.01, 3], of which at most 1.2 is used; NaN gives the
   * default, 0.35. */
  void SetAngularDeflection(double angle);
  vtkGetMacro(AngularDeflection, double);
  ///@}

  ///@{
  /**
   * Unit of all lengths of the output: "mm" (default), "cm", "m", "um", "inch", "ft", or "file" for the unit
   * that the file is written in. Update() raises an error for any other word.
   */
  vtkSetMacro(OutputUnit, std::string);
  vtkGetMacro(OutputUnit, std::string);
  ///@}

  ///@{
  /** Limit of the duration of an Update() in seconds, after which the status is ABORTED. At least 0, clamped.
   * Default 0: no limit. */
  vtkSetClampMacro(MaximumSeconds, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumSeconds, double);
  ///@}

  /** Result of the last Update(). */
  enum StatusType
  {
    OK = 0,
    EMPTY = 1,
    UNREADABLE = 2,
    ABORTED = 3,
    /** Not read for a reason that may not be in the file: there was not enough memory, or
     * solidmoments-kernel was missing, was ended, or took too long. */
    FAILED = 4
  };
  /** Status of the last Update(); EMPTY before the first. */
  vtkGetMacro(Status, int);
  /** The same as a word: "ok", "empty", "unreadable", "aborted" or "failed". */
  const char* GetStatusAsString() const;

  /** The length unit of the last file, as the file spells it; empty when it gives none. */
  std::string GetFileUnit() const;
  /** Unit of the last output's lengths, never "file": "mm", "cm", "m", "um", "inch", "ft". */
  std::string GetLengthUnit() const;

  ///@{
  /** Messages of the last Update(), one sentence each: those about the file, then one for each body whose
   * conversion had problems; the model of the body has all messages about it. If the run failed, the last
   * message is the error. An index out of range gives an empty string. */
  int GetNumberOfMessages() const;
  std::string GetMessage(int index) const;
  ///@}

  /** Bodies with geometry of their own, and instances of them, in the last output; 0 before the first. */
  int GetNumberOfBodies() const;
  int GetNumberOfInstances() const;
  /** Faces outside the solids of the last file, which were left out. */
  int GetNumberOfFreeFaces() const;

  ///@{
  /** Wall-clock seconds of the last Update(): reading, the meshes, and the conversion to NURBS models (with
   * the making of the output). Reading is the sum of parsing, until the entities are in memory, the transfer,
   * which makes shapes of them, and trims: the inspection of faces, which finds the trim curves that the file
   * leaves out. Where the file was not read again, those of reading and conversion are of the run that read
   * it. */
  double GetReadSeconds() const;
  double GetParseSeconds() const;
  double GetTransferSeconds() const;
  double GetTrimSeconds() const;
  double GetMeshSeconds() const;
  double GetConversionSeconds() const;
  ///@}

  ///@{
  /**
   * Requests the display mesh, if it is made on demand, and updates the reader. If the mesh is made only now,
   * a model of the output that was edited in place is replaced by that of the file: edit a copy.
   */
  using vtkPartitionedDataSetCollectionAlgorithm::Update;
  void Update(int port) override;
  vtkTypeBool Update(int port, vtkInformationVector* requests) override;
  void UpdateWholeExtent() override;
  ///@}

  /** Reports a newer modification time if a display mesh is needed that has not been made, see
   * smMeshDemand.h. */
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

protected:
  vtkCADReader();
  ~vtkCADReader() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  /// "STEP" or "BREP".
  virtual const char* GetFormatName() const = 0;
  /// Reads the bytes of a file. `progress` gets a fraction in [0,1] and returns false to stop. Throws only
  /// std::bad_alloc.
  virtual sm::Document ReadDocument(std::string content, const sm::ProgressCallback& progress) = 0;
  /// Returns the reason why bytes that begin with `head` are not file of this format; empty if they may be
  /// one.
  virtual std::string FindMistakeOfHead(const std::string& head) const = 0;
  /// Returns a mistake in the settings that only this format has; empty if there is none.
  virtual std::string FindMistakeOfFormat() const { return {}; }

  /// Called when a file has been read and the output is complete, while the file's shapes are still there:
  /// for tests that compare both. Does nothing.
  virtual void InspectDocument(const sm::Document&) {}

private:
  vtkCADReader(const vtkCADReader&) = delete;
  void operator=(const vtkCADReader&) = delete;

  /// Reports `fraction`; returns false if the application requested a stop, or MaximumSeconds have elapsed.
  bool Report(double fraction);
  /// Sets the status, and its message if there is memory for it.
  void Fail(int status, std::string_view problem) noexcept;
  /// Sets the status of a run that was stopped.
  void Stop();
  /// Marks the display mesh as outdated, without the need to read the file again.
  void ModifyMesh();
  /// Returns true if Kept was read with the present settings and its models are unchanged.
  bool IsReadingCurrent();
  bool IsMeshWanted() const;
  /// Makes the output from Kept; returns false if the application requested a stop.
  bool FillOutput(vtkPartitionedDataSetCollection* output);
  /// Reads without throwing: an exception becomes an error, and the output is empty.
  void ReadGuarded(vtkPartitionedDataSetCollection* output) noexcept;
  void Read(vtkPartitionedDataSetCollection* output);
  void ReadFile(vtkPartitionedDataSetCollection* output);
  /// Gets the bytes of the file or of the content. Returns false, with the reason in `document` or after
  /// Stop(), if that fails.
  bool Load(sm::Document& document, std::string& content);
  /// Returns a mistake in the settings; empty if there is none.
  std::string FindMistake() const;
  sm::LeafOptions ChooseOptions(const sm::Document& document);
  /// Converts all bodies; returns false if the application requested a stop.
  bool MakeBodies(const sm::Document& document, const sm::LeafOptions& options,
    std::vector<std::unique_ptr<sm::LeafMaker>>& makers);
  /// Sets the field data of the output.
  void WriteState(vtkPartitionedDataSetCollection* output) const;
  void Pack(vtkPartitionedDataSetCollection* output, std::vector<unsigned char>& bytes) const;
  void Unpack(const std::vector<unsigned char>& bytes, vtkPartitionedDataSetCollection* output);
  /// Sends status, messages and the tree of the output from `root` to all other ranks, and completes the
  /// output. Every rank makes all collective calls, even without memory. Returns the reason for a failure,
  /// the same on all ranks that are still connected.
  std::string_view ShareTree(
    vtkMultiProcessController* controller, int root, vtkPartitionedDataSetCollection* output) noexcept;

  char* FileName = nullptr;
  std::string Content;
  bool IsContentGiven = false;
  int DisplayMesh = MESH_BY_NEED;
  vtkIdType CoarseAbove = 0;
  bool Refined = false;
  double LinearDeflection = 0.001;
  bool RelativeDeflection = true;
  double AngularDeflection = 0.35;
  std::string OutputUnit = "mm";
  double MaximumSeconds = 0.0;
  /// Start time of the last Update(), and true if it exceeded MaximumSeconds.
  double Start = 0.0;
  bool IsTimeOver = false;
  int Status = EMPTY;

  struct Results;
  std::unique_ptr<Results> Last;
  /// The sources of the leaves that were read; null if nothing was read, or if another rank has them.
  struct Reading;
  std::unique_ptr<Reading> Kept;
  /// MTime of the settings with which Kept was read.
  vtkMTimeType SettledTime = 0;
  /// True if the output has a display mesh; if one was requested, by something connected or by Update(); if
  /// it must be made, since MeshTime.
  bool HasMesh = false;
  bool IsMeshRequested = false;
  bool IsMeshDue = false;
  bool MeshIsCoarse = false;
  vtkTimeStamp MeshTime;
};

#endif
