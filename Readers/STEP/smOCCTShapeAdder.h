/**
 * @file smOCCTShapeAdder.h
 * @brief Adds shapes to a document as bodies and their instances
 */
#ifndef smOCCTShapeAdder_h
#define smOCCTShapeAdder_h

#include "smOCCTDocument.h"
#include "smReadersSTEPModule.h"

#include <TopoDS_Compound.hxx>

#include <map>
#include <tuple>
#include <vector>

namespace sm
{
/**
 * Adds solids, free shells and loose faces of shapes. A shape that is added again with the same scale becomes
 * another instance of the same body. The table of the document must have the data of the shapes. Faces
 * outside of solids become bodies only if no announced shape has a solid; else they are counted.
 */
class SMREADERSSTEP_EXPORT ShapeAdder
{
public:
  explicit ShapeAdder(Document& document)
    : Result(document)
  {
  }

  /// Announces a shape that will be added.
  void Announce(const TopoDS_Shape& shape)
  {
    this->OnlySolids = this->OnlySolids || this->CountSolids(shape) > 0;
  }
  /// Returns the number of solids, with those that are not closed.
  int CountSolids(const TopoDS_Shape& shape) const;
  /// Adds the instances of a shape to a node. `part` describes its bodies, as far as their own data do not.
  void Add(const TopoDS_Shape& shape, const PartBody& part, const gp_Trsf& placement, const Vector3& color,
    ProductNode& node);

private:
  bool IsOpenSolid(const TopoDS_Shape& shell) const;
  std::vector<TopoDS_Shape> GetParts(const TopoDS_Shape& shell);
  void AddBody(const TopoDS_Shape& shape, bool solid, const PartBody& part, const gp_Trsf& placement,
    const Vector3& color, ProductNode& node);

  Document& Result;
  /// True if the file has solids; faces outside of them are then counted but not read.
  bool OnlySolids = false;
  std::map<std::tuple<const void*, TopAbs_Orientation, double>, int> Known;
  std::map<const void*, TopoDS_Compound> LooseFaces;
  std::map<const void*, std::vector<TopoDS_Shape>> ShellParts;
};
}

#endif
