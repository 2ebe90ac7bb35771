/**
 * @file smShapeAdder.h
 * @brief Adds shapes to a document as bodies and their instances
 */
#ifndef smShapeAdder_h
#define smShapeAdder_h

#include "smDocument.h"
#include "smReadersSTEPModule.h"

#include <map>
#include <tuple>
#include <vector>

namespace sm
{
/**
 * Adds solids, free shells and loose faces of shapes. A shape that is added again with the same scale becomes
 * another instance of the same body. Faces outside of solids become bodies only if no announced group has a
 * solid; else they are counted.
 */
class SMREADERSSTEP_EXPORT ShapeAdder
{
public:
  explicit ShapeAdder(Document& document)
    : Result(document)
  {
  }

  /// Announces shapes that will be added.
  void Announce(const ShapeGroup& shapes) { this->OnlySolids = this->OnlySolids || CountSolids(shapes) > 0; }
  /// Returns the number of solids, with those that are not closed.
  static int CountSolids(const ShapeGroup& shapes);
  /// Adds the instances of shapes to a node. `part` describes its bodies, as far as their own data do not.
  void Add(const ShapeGroup& shapes, const PartBody& part, const Placement& placement, const Vector3& color,
    ProductNode& node);

private:
  /// A body, and what distinguishes it from others.
  struct Candidate
  {
    const void* Key;
    bool IsReversed;
    BodyShape Shape;
    ShapeData Data;
    /// Within its group.
    Placement Location;
  };

  const std::vector<ShellPointer>& GetParts(const ShellPointer& shell);
  void AddBody(const Candidate& candidate, const PartBody& part, const Placement& placement,
    const Vector3& color, ProductNode& node);

  Document& Result;
  /// True if the file has solids; faces outside of them are then counted but not read.
  bool OnlySolids = false;
  std::map<std::tuple<const void*, bool, double>, int> Known;
  std::map<const void*, std::vector<ShellPointer>> ShellParts;
};
}

#endif
