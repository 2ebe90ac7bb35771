/**
 * @file smSTEPLeaf.h
 * @brief A body's model and the mesh of its scales, made once, and its instances
 */
#ifndef smSTEPLeaf_h
#define smSTEPLeaf_h

#include "smBodySize.h"
#include "smLeafMesh.h"
#include "smOCCTBody.h"
#include "smOCCTDocument.h"
#include "smProgressCallback.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;
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
};

class LeafMaker
{
public:
  /// Converts and measures the body. A failure is a message; only std::bad_alloc is thrown. `progress` gets a fraction in
  /// [0,1] and answers false to stop.
  LeafMaker(const PartBody& part, const ShapeTable& table, const LeafOptions& options,
    const ProgressCallback& progress);

  /// One occurrence, which shares the model.
  LeafSource MakeSource(const BodyInstance& instance) const;

  /// A sentence with the body's name when its conversion had problems; else empty.
  const std::vector<std::string>& GetMessages() const { return this->Messages; }
  /// `progress` said to stop; the leaf is not whole.
  bool IsAborted() const { return this->Aborted; }
  double GetMeshSeconds() const { return this->MeshSeconds; }
  double GetConversionSeconds() const { return this->ConversionSeconds; }

private:
  void Convert(const PartBody& part, const ShapeTable& table, const ProgressCallback& progress,
    BodySize& size, ConvertedBody& body);
  /// Measures the body, whose box is about `box` (relative to the model's origin), by the mesh of its scales.
  void Triangulate(
    const double box[6], const ProgressCallback& progress, BodySize& size, ConvertedBody& body);
  void MakeModel(const PartBody& part, const BodySize& size, ConvertedBody& body);
  /// The first message with the body's name, and how many there are.
  void Summarise(const PartBody& part, const std::vector<std::string>& messages);

  LeafOptions Options;
  Vector3 Color;
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  std::vector<std::string> Messages;
  bool Aborted = false;
  double MeshSeconds = 0.0;
  double ConversionSeconds = 0.0;
};
}

#endif
