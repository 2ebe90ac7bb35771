/**
 * @class   vtkMomentGradient
 * @brief   gradients of mass properties by control points and weights, on the control nets
 *
 * Computes sm::ComputeMomentGradient() (smMomentGradient.h, with the formulas) for a vtkNURBSDataSet or a
 * composite dataset with any number of them. Integrals run by compute shaders or on the threads of
 * vtkSMPTools. Coordinates are those of the world, L is the length unit, the density 1.
 *
 * Output, a vtkPolyData: the control points of all faces, face after face, the index in v fastest; lines
 * along the nets in both directions. Point arrays (double unless said), for each quantity of
 * sm::GetGradientQuantities(), for example Volume:
 * | name | comp. | unit | meaning; NaN where unknown, or where there is none |
 * |---|---|---|---|
 * | VolumeByPoint, VolumeByPointBound | 3 | unit of the quantity / L | derivatives by x, y, z; error bounds |
 * | VolumeByWeight, VolumeByWeightBound | 1 | unit of the quantity | derivative by the weight; error bound |
 * | Weight | 1 | 1 | |
 * | Solid, Face, IndexU, IndexV | 1 (int) | | indices from 0 |
 * | FaceId | 1 (int) | | entity number of the face in the file; 0: none |
 * | PointVariable, WeightVariable | 1 (vtkIdType) | | equal for tied points, weights |
 * The active vectors are VolumeByPoint. Field data: Status and Message (string), LengthUnit (string). With a
 * status "not-computed" or "empty" the output has no points, and an error or a warning gives the reason.
 */
#ifndef vtkMomentGradient_h
#define vtkMomentGradient_h

#include "smFiltersMomentGradientModule.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the arrays of faces

#include <string> // for std::string
#include <vector> // for the faces

class vtkComputeContext;
class vtkDoubleArray;

class SMFILTERSMOMENTGRADIENT_EXPORT vtkMomentGradient : public vtkPolyDataAlgorithm
{
public:
  static vtkMomentGradient* New();
  vtkTypeMacro(vtkMomentGradient, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** If on, coinciding control points are one variable, with one derivative: rows that faces share at an
   * edge, ends of closed nets, poles (sm::MomentGradientOptions::Tied). If off, every control point of every
   * face is a variable of its own. Default: on. */
  vtkSetMacro(Tied, bool);
  vtkGetMacro(Tied, bool);
  vtkBooleanMacro(Tied, bool);
  ///@}

  ///@{
  /** Tolerance of the quadrature of each derivative, relative to the area of the solid times powers of half
   * its diagonal. In (0, 1], clamped to >= 1e-15; what is not in it is reported as an error and changes
   * nothing. Default: 1e-9. */
  void SetRelativeTolerance(double tolerance);
  vtkGetMacro(RelativeTolerance, double);
  ///@}

  /** Where the integrals are computed. */
  enum BackendType
  {
    /** OpenGL on a GPU where the CPU would take more than about a second; else the CPU. */
    AUTOMATIC = 0,
    /** OpenGL, also of a software renderer; the CPU, with the reason, where it cannot be used. */
    OPENGL = 1,
    CPU = 2
  };

  ///@{
  /** The backend; values outside the enumeration are clamped. Default: AUTOMATIC. */
  vtkSetClampMacro(Backend, int, AUTOMATIC, CPU);
  vtkGetMacro(Backend, int);
  ///@}

  /** The OpenGL context; null (default): one of its own, which is made when it is needed and kept. */
  void SetComputeContext(vtkComputeContext* context);

  ///@{
  /** Solids, and faces of each of them, by their indices from 0; none: all, the default. An index that does
   * not exist makes a run fail. */
  void AddSolid(int index);
  void ClearSolids();
  void AddFace(int index);
  void ClearFaces();
  ///@}

  ///@{
  /** Status of the last run ("ok", "open", ...), and why it is not "ok"; empty before the first one. */
  const char* GetStatus() const { return this->Status.c_str(); }
  const char* GetReason() const { return this->Reason.c_str(); }
  ///@}

  ///@{
  /** OPENGL or CPU, of the last run, and why the CPU where OpenGL was asked for or tried. */
  vtkGetMacro(UsedBackend, int);
  const char* GetBackendReason() const { return this->BackendReason.c_str(); }
  ///@}

  ///@{
  /**
   * Arrays of the last run, for face `index` of the result (from 0): Values and Bounds have a tuple of
   * 4 x GetNumberOfQuantities() numbers for each control point, the index in v fastest, in the order of
   * (GetCountU(), GetCountV(), 4, GetNumberOfQuantities()): by x, y, z, and the weight. Null and 0 for an
   * index that does not exist.
   */
  int GetNumberOfFaces() const { return static_cast<int>(this->Faces.size()); }
  vtkDoubleArray* GetValues(int index) const;
  vtkDoubleArray* GetBounds(int index) const;
  int GetCountU(int index) const;
  int GetCountV(int index) const;
  /** Indices from 0 of the solid in the input and of the face in it; -1 for an index that does not exist. */
  int GetSolid(int index) const;
  int GetFace(int index) const;
  ///@}

  ///@{
  /** The quantities that are differentiated. An empty name for an index that does not exist. */
  static int GetNumberOfQuantities();
  static std::string GetQuantityName(int quantity);
  /** The unit of a quantity as a power of the length unit. */
  static int GetQuantityLengthPower(int quantity);
  ///@}

  ///@{
  /** Points of surfaces that the last run evaluated for the gradients, and its seconds for the mass
   * properties and for the gradients. */
  vtkGetMacro(Evaluations, vtkTypeInt64);
  vtkGetMacro(MomentSeconds, double);
  vtkGetMacro(GradientSeconds, double);
  ///@}

protected:
  vtkMomentGradient();
  ~vtkMomentGradient() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkMomentGradient(const vtkMomentGradient&) = delete;
  void operator=(const vtkMomentGradient&) = delete;

  struct FaceArrays
  {
    int Solid = -1;
    int Face = -1;
    int Count[2] = { 0, 0 };
    vtkSmartPointer<vtkDoubleArray> Values;
    vtkSmartPointer<vtkDoubleArray> Bounds;
  };
  const FaceArrays* Find(int index) const;

  bool Tied = true;
  double RelativeTolerance = 1e-9;
  int Backend = AUTOMATIC;
  int UsedBackend = CPU;
  std::string BackendReason;
  vtkSmartPointer<vtkComputeContext> Context;
  std::vector<int> SolidIndices;
  std::vector<int> FaceIndices;
  std::string Status;
  std::string Reason;
  std::vector<FaceArrays> Faces;
  vtkTypeInt64 Evaluations = 0;
  double MomentSeconds = 0.0;
  double GradientSeconds = 0.0;
};

#endif
