/**
 * @class   vtkNURBSDataSet
 * @brief   one instance of a solid: a display mesh together with its exact trimmed NURBS model
 *
 * The polydata is what any VTK filter or ParaView view shows, in world coordinates. The model is the exact
 * geometry that mass properties are computed from. World position = Placement * (part position), with a
 * rigid or mirrored 4x4 placement.
 *
 * Arrays of the polydata that a reader fills:
 * | name | association | components | meaning |
 * |---|---|---|---|
 * | FaceIndex | cell, point | 1 (int) | index of the face in the model |
 * | Parameters | point | 2 | (u,v) of the point on that face's surface |
 * | MeshDeviation | field | 1 | no triangle of face i is farther from its surface, across it (see below) |
 * | MeshAngle | field | 1 | bound, radians, of the angle of normals in a triangle of face i from a corner's |
 *
 * MeshDeviation bounds the distance from the surface whether trimmed or not, and where the surface is nearly
 * flat next to a triangle, its distance across the surface as continued beyond the part under the triangle:
 * sideways a triangle may reach beyond that part, as chords do beyond the edges of a face. Within a triangle
 * no normal of the surface is farther than MeshAngle from the normal at one of its corners; pi means that
 * there is no bound, as at a pole. A deformed copy has neither array. See Documentation/Numerics.md.
 *
 * The model belongs to the points it came with. CopyStructure and a copy from a plain polydata drop it.
 * GetModel() returns null if the points were replaced or their coordinates changed after SetModel(), because
 * the model no longer describes them: such a mesh is an ordinary polydata from then on. Points with a new
 * MTime and the same coordinates are still those of the model.
 *
 * An instance may have no points and no triangles: a reader makes them only where something downstream shows
 * or uses them (vtkCADReader:: SetDisplayMesh). Exact results do not depend on the mesh. The bounds of an
 * instance without points are those of the model's scale mesh.
 */
#ifndef vtkNURBSDataSet_h
#define vtkNURBSDataSet_h

#include "smFiltersNURBSModule.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h" // for the model

#include <cstdint>
#include <string> // for the names
#include <vector>

class vtkInformationIntegerKey;
class vtkMatrix4x4;
class vtkTrimmedNURBSModel;

class SMFILTERSNURBS_EXPORT vtkNURBSDataSet : public vtkPolyData
{
public:
  static vtkNURBSDataSet* New();
  static vtkNURBSDataSet* ExtendedNew();
  vtkTypeMacro(vtkNURBSDataSet, vtkPolyData);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Names of the arrays in the table above. */
  static const char* FaceIndexArrayName() { return "FaceIndex"; }
  static const char* ParametersArrayName() { return "Parameters"; }
  static const char* MeshDeviationArrayName() { return "MeshDeviation"; }
  static const char* MeshAngleArrayName() { return "MeshAngle"; }

  /** Sets the exact geometry of the points that are there now. Set the points first. */
  void SetModel(vtkTrimmedNURBSModel* model);

  /** Sets an edited model and its points, which differ from those of GetModel(), which there must be, at most
   * in `moved`. Does not read the others, as SetModel() does. */
  void SetModelAndPoints(vtkTrimmedNURBSModel* model, vtkPoints* points, const std::vector<vtkIdType>& moved);

  /** The exact geometry, or null: none was set, or the points are no longer the ones it came with. */
  vtkTrimmedNURBSModel* GetModel();

  /** True when a model was set but is withheld because the points changed since. */
  bool IsModelWithheld();

  /** Part to world: a row-major 4x4 matrix, a rotation (or reflection) and a translation. Default: identity.
   */
  void SetPlacement(vtkMatrix4x4* placement);
  void GetPlacement(vtkMatrix4x4* placement);
  const double* GetPlacementData() const VTK_SIZEHINT(16) { return this->Placement; }

  ///@{
  /** The name of the instance's solid in the file, which several instances may have; and its place in the
   * product structure, which no other instance of the file has, for example "rod-assembly/nut (2)". They
   * belong to the model: copies have them, and a mesh that loses its model loses them. Empty, the default:
   * the name of the block counts, and there is no path. */
  void SetPartName(const std::string& name);
  const std::string& GetPartName() const { return this->PartName; }
  void SetPartPath(const std::string& path);
  const std::string& GetPartPath() const { return this->PartPath; }
  ///@}

  void Initialize() override;
  void ShallowCopy(vtkDataObject* source) override;
  void DeepCopy(vtkDataObject* source) override;
  void CopyStructure(vtkDataSet* source) override;
  unsigned long GetActualMemorySize() override;
  /** Includes the time of the model, so that exchanging a face of the model executes the pipeline. */
  vtkMTimeType GetMTime() override;

  ///@{
  /** Keys of filters that do without the display mesh of their input, see smMeshDemand.h: in the information
   * of an output; of an output port; of a filter. */
  static vtkInformationIntegerKey* EXACT_MARK();
  static vtkInformationIntegerKey* MESH_OUTPUT();
  static vtkInformationIntegerKey* MESH_REQUESTED();
  ///@}

  /** The box of the instance by the model's scale mesh, which does not depend on what is shown; by its points
   * where there is no such mesh. False, and `bounds` unchanged, where there is neither. */
  bool GetBodyBounds(double bounds[6]);

  void ComputeBounds() override;

  static vtkNURBSDataSet* GetData(vtkInformation* info);
  static vtkNURBSDataSet* GetData(vtkInformationVector* vector, int index = 0);

protected:
  vtkNURBSDataSet();
  ~vtkNURBSDataSet() override;

private:
  vtkNURBSDataSet(const vtkNURBSDataSet&) = delete;
  void operator=(const vtkNURBSDataSet&) = delete;

  void DropModel();
  void CopyModel(vtkNURBSDataSet* source);
  bool ArePointsOriginal();

  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  double Placement[16];
  std::string PartName;
  std::string PartPath;
  /// The points that the model describes, their time when they were known to be the original ones, and the
  /// hash of their coordinates.
  vtkSmartPointer<vtkPoints> ModelPoints;
  vtkMTimeType ModelPointsTime = 0;
  std::uint64_t ModelPointsHash = 0;
};

#endif
