/**
 * @file smEditSession.h
 * @brief A solid that is edited again and again: edit, display points, mass properties, with their costs
 */
#ifndef smEditSession_h
#define smEditSession_h

#include <vtkMassPropertiesGPU.h>
#include <vtkNURBSDataSet.h>
#include <vtkNURBSDeform.h>
#include <vtkNURBSPointEvaluator.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <string>

namespace smtest
{
enum class EditKind
{
  /// One control point inside a face.
  Point,
  /// The control points between the ends of a boundary row, on the face and its neighbour; on a face whose
  /// boundary is not such a row it is the face's own.
  Row,
  /// A lattice of 3 x 2 x 2 points over the body, one of them moved: all faces.
  Lattice,
  /// No edit, but every face is a new one: cut, planned, uploaded and evaluated.
  FullRun
};

/// "point", "row", "lattice", "full".
const char* GetName(EditKind kind);

struct UpdateCost
{
  /// Seconds of the edit, of the display points (Lattice: of both, in Edit), and of the mass properties.
  double Edit = 0.0;
  double Display = 0.0;
  double Mass = 0.0;
  /// Seconds of the mass properties' stages: cutting, planning and uploading; evaluating and summing.
  double Prepare = 0.0;
  double Integrate = 0.0;
  long long ChangedFaces = 0;
  long long ChangedPoints = 0;
  long long Evaluations = 0;
  long long Dispatches = 0;
};

class EditSession
{
public:
  /// `leaf` is not changed: every update edits a copy of it. `backend` is vtkSurfaceIntegralGPU's.
  EditSession(vtkNURBSDataSet* leaf, int backend, double tolerance);

  /// Edit number `number` of a drag: a displacement that no other number below a million has.
  UpdateCost Update(EditKind kind, int number);

  vtkMassPropertiesGPU* GetMass() { return this->Mass; }
  /// After Update(): the edited mesh.
  vtkNURBSDataSet* GetLeaf() { return this->Leaf; }
  /// Why an update failed; empty where none did.
  const std::string& GetError() const { return this->Error; }
  /// The face that is edited: the one with the most control points, the first of such.
  int GetFace() const { return this->Face; }

private:
  void Edit(EditKind kind, double amount, UpdateCost& cost);
  void Deform(double amount, UpdateCost& cost);
  void Renew();
  void Check(bool good, const std::string& what);

  vtkSmartPointer<vtkNURBSDataSet> Original;
  vtkSmartPointer<vtkNURBSDataSet> Leaf;
  vtkNew<vtkMassPropertiesGPU> Mass;
  vtkSmartPointer<vtkNURBSPointEvaluator> Points;
  vtkNew<vtkNURBSDeform> Lattice;
  int Face = 0;
  double Size = 0.0;
  std::string Error;
};
}

#endif
