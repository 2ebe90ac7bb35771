/**
 * @file smSTEPLeaf.h
 * @brief Makes the model and scale mesh of a body, once, and the leaves of its instances
 */
#ifndef smSTEPLeaf_h
#define smSTEPLeaf_h

#include "smBodyConversion.h"
#include "smBodySize.h"
#include "smDocument.h"
#include "smEqualParts.h"
#include "smFaceCheck.h"
#include "smLeafMesh.h"
#include "smProgressCallback.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkPolyData;
class vtkTrimmedNURBSModel;

namespace sm
{
struct LeafOptions
{
  /// Factor from mm to the output's unit, and the name of that unit.
  double Unit = 1.0;
  std::string UnitName = "mm";
  /// Name of the file's length unit; empty if the unit has no name here.
  std::string FileUnitName;

  /// Returns the roundings of a coordinate by the conversion of the file's unit to mm.
  int GetRoundings() const;
};

class LeafMaker
{
public:
  /// Converts and measures the body. A failure becomes a message; only std::bad_alloc is thrown. `progress`
  /// gets a fraction in [0,1] and returns false to stop. `equal` has the place of the body among those that
  /// equal it, and `first` made the first of them, if that is another one: its conversion is copied.
  LeafMaker(const PartBody& part, const FaceStatements& statements, const LeafOptions& options,
    const EqualPart& equal, const LeafMaker* first, const ProgressCallback& progress);

  /// Returns the source of the leaf of one instance, which shares the model.
  LeafSource MakeSource(const BodyInstance& instance) const;

  /// Returns sentences with the body's name if its conversion had problems; else empty.
  const std::vector<std::string>& GetMessages() const { return this->Messages; }
  /// Returns true if `progress` stopped it; the leaf is then incomplete.
  bool IsAborted() const { return this->Aborted; }
  double GetMeshSeconds() const { return this->MeshSeconds; }
  double GetConversionSeconds() const { return this->ConversionSeconds; }

private:
  /// What was made of a body, for those that equal it.
  struct Conversion
  {
    const PartBody* Part;
    ConvertedBody Body;
    BodySize Size;
  };

  /// Converts the body; a failure becomes a message. `moved`: see ConvertBody().
  void ConvertGuarded(const PartBody& part, const Vector3& moved, const ProgressCallback& progress,
    BodySize& size, ConvertedBody& body);
  void Convert(const PartBody& part, const Vector3& moved, const ProgressCallback& progress, BodySize& size,
    ConvertedBody& body);
  /// Copies the conversion of another body.
  void Copy(
    const PartBody& part, const Vector3& shift, const LeafMaker& first, BodySize& size, ConvertedBody& body);
  /// Returns the place of the model relative to the statements of the file.
  StatementPlace GetStatementPlace(const PartBody& part) const;
  /// Makes the scale mesh, and measures the body by it. `box` is the approximate box of the body, relative to
  /// the model's origin.
  void Triangulate(const PartBody& part, const double box[6], const ProgressCallback& progress,
    BodySize& size, ConvertedBody& body);
  void MakeModel(const PartBody& part, const BodySize& size, ConvertedBody& body);
  /// Makes a summary: the first message, with the body's name, and the number of messages.
  void Summarise(const PartBody& part, const std::vector<std::string>& messages);

  LeafOptions Options;
  Vector3 Color;
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  /// Null unless other bodies equal this one, and its conversion had no problems.
  std::unique_ptr<const Conversion> ForCopies;
  std::vector<std::string> Messages;
  bool Aborted = false;
  double MeshSeconds = 0.0;
  double ConversionSeconds = 0.0;
};
}

#endif
