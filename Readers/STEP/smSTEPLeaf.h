/**
 * @file smSTEPLeaf.h
 * @brief A body's model and display mesh, made once, and its instances as leaves of the output
 */
#ifndef smSTEPLeaf_h
#define smSTEPLeaf_h

#include "smOCCTDocument.h"
#include "smOCCTMesh.h"
#include "smProgressCallback.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkCellArray;
class vtkDataArray;
class vtkNURBSDataSet;
class vtkTrimmedNURBSModel;

namespace sm
{
struct LeafOptions
{
  /// Output lengths per mm, and the name of the output's unit.
  double Unit = 1.0;
  std::string UnitName = "mm";
  /// The file's own unit, empty when it has no name here.
  std::string FileUnitName;
  double LinearDeflection = 0.001;
  bool RelativeDeflection = true;
  double AngularDeflection = 0.35;
};

class LeafMaker
{
public:
  /// Triangulates and converts the body. A failure is a message; only std::bad_alloc is thrown. `progress` gets a fraction in
  /// [0,1] and answers false to stop.
  LeafMaker(const PartBody& part, const ShapeTable& table, const LeafOptions& options,
    const ProgressCallback& progress);

  /// One occurrence, in world coordinates; it shares the model, and all arrays that the placement leaves alone.
  vtkSmartPointer<vtkNURBSDataSet> MakeLeaf(const BodyInstance& instance);

  /// A sentence with the body's name when its conversion had problems; else empty.
  const std::vector<std::string>& GetMessages() const { return this->Messages; }
  /// `progress` said to stop; the leaf is not whole.
  bool IsAborted() const { return this->Aborted; }
  double GetMeshSeconds() const { return this->MeshSeconds; }
  double GetConversionSeconds() const { return this->ConversionSeconds; }

private:
  /// Bounding box of the shape and largest distance of the display mesh from it: in mm before the scale, later in output units.
  struct Extent
  {
    double Bounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
    double Deflection = 0.0;
  };

  void Convert(const PartBody& part, const ShapeTable& table, const ProgressCallback& progress,
    Extent& extent, ConvertedBody& body);
  void Triangulate(const PartBody& part, const ShapeTable& table, const ProgressCallback& progress,
    Extent& extent, std::vector<std::string>& messages);
  void MakeModel(const PartBody& part, const Extent& extent, ConvertedBody& body);
  /// The first message with the body's name, and how many there are.
  void Summarise(const PartBody& part, const std::vector<std::string>& messages);
  void MakeSharedArrays();
  vtkSmartPointer<vtkCellArray> GetTriangles(bool mirrored);
  vtkSmartPointer<vtkDataArray> MakeColors(const BodyInstance& instance) const;

  LeafOptions Options;
  Vector3 Color;
  DisplayMesh Mesh;
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  vtkSmartPointer<vtkCellArray> Triangles[2];
  vtkSmartPointer<vtkDataArray> PointFace;
  vtkSmartPointer<vtkDataArray> CellFace;
  vtkSmartPointer<vtkDataArray> Parameters;
  std::vector<std::string> Messages;
  bool Aborted = false;
  /// Time at which the display mesh was done.
  double MeshEnd = 0.0;
  double MeshSeconds = 0.0;
  double ConversionSeconds = 0.0;
};
}

#endif
