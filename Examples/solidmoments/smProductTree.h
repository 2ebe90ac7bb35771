/**
 * @file smProductTree.h
 * @brief The product structure of a file, from the reader's assembly
 */
#ifndef smProductTree_h
#define smProductTree_h

#include "smProducts.h"

#include <array>
#include <string>
#include <vector>

class vtkPolyData;
class vtkCADReader;
class vtkTrimmedNURBSModel;

namespace sm
{
/// Returns the root of the products (MakeProductTree()).
ProductTreeNode GetProductTree(vtkCADReader* reader);

/// A solid or free shell of the file: its id in the table of solids, its model, its display mesh, and the
/// first three rows of the matrix from the part to the world.
struct ProductBody
{
  std::string Id;
  vtkTrimmedNURBSModel* Model;
  vtkPolyData* Mesh;
  std::array<double, 12> Placement;
};
/// Returns all bodies in the order of their ids.
std::vector<ProductBody> ListBodies(vtkCADReader* reader);

/// Returns a selector (vtkSurfaceIntegralBase::AddSelector) for every product whose name matches the pattern
/// (MatchesPattern); if there is none, a selector that contains the pattern and selects nothing.
std::vector<std::string> FindProducts(vtkCADReader* reader, const std::string& pattern);
}

#endif
