/**
 * @file smProducts.h
 * @brief The product structure of an input, from its vtkDataAssembly
 */
#ifndef smProducts_h
#define smProducts_h

#include "smFiltersMassPropertiesModule.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkTrimmedNURBSModel;

namespace sm
{
/// A product of an input: its bodies, by the numbers that filters give them (BodyIntegrals::Id), and the
/// products that it consists of.
struct ProductTreeNode
{
  struct Body
  {
    std::string Id;
    vtkTrimmedNURBSModel* Model = nullptr;
    /// The first three rows of the matrix from the part to the world.
    const double* Placement = nullptr;
  };
  std::string Name;
  /// Layer of the product; empty where the file states none.
  std::string Layer;
  /// The first three rows of the matrix from the product to the world, which is rigid; none if not known.
  std::optional<std::array<double, 12>> Placement;
  std::vector<Body> Bodies;
  std::vector<ProductTreeNode> Children;
};

/// The tree of the vtkDataAssembly of a vtkPartitionedDataSetCollection, without products that have no
/// bodies; a body in several nodes belongs to the first, one in no node is a product of its own. Without an
/// assembly there is a product for each body. Nodes more than 100 levels deep are missing, and their bodies
/// are in the node above. Pointers are valid as long as the input.
SMFILTERSMASSPROPERTIES_EXPORT ProductTreeNode MakeProductTree(vtkDataObject* input);
}

#endif
