/**
 * @class   vtkNURBSTransform
 * @brief   moves solids rigidly and keeps their exact geometry
 *
 * VTK's own transform filters move points and drop the exact geometry. This one changes the placement of
 * every vtkNURBSDataSet in its input (one, or the leaves of a composite dataset) by a rotation, a reflection
 * and a translation, and moves the points and normals of every leaf alike, of plain meshes too. Models, and
 * with them all data kept for their faces, stay shared: after a move no face is integrated again. A
 * reflection also reverses the cells of polydata, so that they stay counter-clockwise from outside.
 *
 * p' = Translation + Rz Rx Ry M p in world coordinates, with M the mirror image and R the rotations about the
 * axes through the origin; or the given Transform instead. A transform that is not rigid (to 1e-12) is an
 * error, and the output is empty.
 *
 * Not thread safe.
 */
#ifndef vtkNURBSTransform_h
#define vtkNURBSTransform_h

#include "smFiltersNURBSEditModule.h"
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSmartPointer.h" // for the transform

class vtkLinearTransform;
class vtkMatrix4x4;

class SMFILTERSNURBSEDIT_EXPORT vtkNURBSTransform : public vtkPassInputTypeAlgorithm
{
public:
  static vtkNURBSTransform* New();
  vtkTypeMacro(vtkNURBSTransform, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Translation, in the input's length unit. Default: 0 0 0. */
  vtkSetVector3Macro(Translation, double);
  vtkGetVector3Macro(Translation, double);
  ///@}

  ///@{
  /** Angles in degrees about the x, y and z axis through the origin; rotated about y first, then x, then z,
   * as vtkProp3D does. Default: 0 0 0. */
  vtkSetVector3Macro(Rotation, double);
  vtkGetVector3Macro(Rotation, double);
  ///@}

  /** The coordinate whose sign a reflection changes. */
  enum MirrorType
  {
    NONE = 0,
    X = 1,
    Y = 2,
    Z = 3
  };

  ///@{
  /** Reflection at the plane through the origin across this axis, before the rotation. Clamped to these.
   * Default: NONE. */
  vtkSetClampMacro(Mirror, int, NONE, Z);
  vtkGetMacro(Mirror, int);
  ///@}

  ///@{
  /** A transform to use instead of all of the above: a rotation, reflection and translation. Default: null.
   */
  void SetTransform(vtkLinearTransform* transform);
  vtkLinearTransform* GetTransform();
  ///@}

  ///@{
  /**
   * Number of time steps of the output, at the times 0 to 1 at equal distances; at time t Translation and
   * Rotation are multiplied by t. Mirror is always whole, and so is the transform of SetTransform(). Clamped
   * to 0 .. 100000. Below 2 (default: 0): no times, and the whole edit.
   */
  vtkSetClampMacro(TimeSteps, int, 0, 100000);
  vtkGetMacro(TimeSteps, int);
  ///@}

  /** The matrix that the next run applies, at time 1. */
  void GetMatrix(vtkMatrix4x4* matrix);

  vtkMTimeType GetMTime() override;

  ///@{
  /** Updates the filter, and also requests the input's display mesh, as a connected view does. */
  using vtkPassInputTypeAlgorithm::Update;
  void Update(int port) override;
  vtkTypeBool Update(int port, vtkInformationVector* requests) override;
  ///@}

  /** Reports to the input whether its display mesh is needed, see smMeshDemand.h. */
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs,
    vtkInformationVector* outputs, int port, vtkMTimeType* time) override;

protected:
  vtkNURBSTransform();
  ~vtkNURBSTransform() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkNURBSTransform(const vtkNURBSTransform&) = delete;
  void operator=(const vtkNURBSTransform&) = delete;

  // RequestData() without the handling of exceptions.
  bool MoveInput(vtkDataObject* input, double share, vtkDataObject* output);
  void MakeMatrix(double share, vtkMatrix4x4* matrix);

  double Translation[3] = { 0.0, 0.0, 0.0 };
  double Rotation[3] = { 0.0, 0.0, 0.0 };
  int Mirror = NONE;
  int TimeSteps = 0;
  vtkSmartPointer<vtkLinearTransform> Transform;
};

#endif
