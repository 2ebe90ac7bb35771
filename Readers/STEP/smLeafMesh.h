/**
 * @file smLeafMesh.h
 * @brief The instances of a reader's output as datasets, without or with their display mesh
 */
#ifndef smLeafMesh_h
#define smLeafMesh_h

#include "smFaceMesher.h"
#include "smProgressCallback.h"
#include "smVector.h"

#include "vtkSmartPointer.h"
#include "vtkTrimmedNURBSModel.h"

#include <array>
#include <map>
#include <string>
#include <vector>

class vtkCellArray;
class vtkNURBSDataSet;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace sm
{
/// An instance, as a reader keeps it: all that its dataset is made of.
struct LeafSource
{
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  /// Row-major, in output units.
  std::array<double, 16> Placement{};
  /// Colour of faces without one of their own, and colour that overrides all others; negative: none.
  Vector3 BodyColor{ -1.0, -1.0, -1.0 };
  Vector3 Color{ -1.0, -1.0, -1.0 };
};

/// The instance without points and triangles.
vtkSmartPointer<vtkNURBSDataSet> MakeBareLeaf(const LeafSource& source);

/// The settings of the display mesh, see vtkCADReader.
struct ShownMesh
{
  double LinearDeflection = 0.001;
  bool RelativeDeflection = true;
  double AngularDeflection = 0.35;
  /// Number of triangles of all instances above which a coarser mesh is made; 0: none.
  vtkIdType CoarseAbove = 0;

  double GetDeflection(double diagonal) const
  {
    return this->LinearDeflection * (this->RelativeDeflection ? diagonal : 1.0);
  }
};

/// Makes the display meshes of instances. Those of one model share all arrays that placement and colour leave
/// alone.
class LeafMesher
{
public:
  /// `sources` outlive it.
  LeafMesher(const std::vector<LeafSource>& sources, const ShownMesh& shown);

  /// The instance with its mesh; null when `progress` answered false. The mesh of a model is made for its
  /// first instance.
  vtkSmartPointer<vtkNURBSDataSet> MakeLeaf(const LeafSource& source, const ProgressCallback& progress);

  /// The meshes are coarser than what is asked, for there would be more than CoarseAbove triangles.
  bool IsCoarse() const { return this->CoarseDeflection > 0.0; }
  /// The largest deflection that took the place of a smaller one that was asked for; 0: none did.
  double GetSmallestDeflection() const { return this->SmallestDeflection; }
  /// The problems of meshes that are not scale meshes; the models themselves have messages about those.
  const std::vector<std::string>& GetMessages() const { return this->Messages; }

private:
  struct Shared
  {
    vtkSmartPointer<vtkPolyData> Mesh;
    vtkSmartPointer<vtkCellArray> MirroredTriangles;
    std::map<std::array<Vector3, 2>, vtkSmartPointer<vtkUnsignedCharArray>> Colors;
  };
  MeshLimits GetLimits(vtkTrimmedNURBSModel* model) const;
  vtkSmartPointer<vtkPolyData> MakeMesh(vtkTrimmedNURBSModel* model, const ProgressCallback& progress);
  void ChooseCoarseness(const std::vector<LeafSource>& sources);

  ShownMesh Wanted;
  double SmallestDeflection = 0.0;
  /// A length; 0: what is asked for is shown.
  double CoarseDeflection = 0.0;
  std::map<vtkTrimmedNURBSModel*, Shared> Meshes;
  std::vector<std::string> Messages;
};
}

#endif
