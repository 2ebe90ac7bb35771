/**
 * @file smProductBodies.h
 * @brief The bodies of an input, and its products by their names; not installed
 */
#ifndef smProductBodies_h
#define smProductBodies_h

#include "smFiltersProductsModule.h"

#include <array>
#include <string>
#include <vector>

class vtkDataObject;
class vtkNURBSDataSet;
class vtkTrimmedNURBSModel;

namespace sm
{
/// A solid or free shell of the input: its id in the table of solids, its model, its leaf, which has the
/// display mesh, and the first three rows of the matrix from the part to the world.
struct ProductBody
{
  std::string Id;
  vtkTrimmedNURBSModel* Model;
  vtkNURBSDataSet* Leaf;
  std::array<double, 12> Placement;
};
/// Returns all bodies in the order of their ids.
SMFILTERSPRODUCTS_EXPORT std::vector<ProductBody> ListBodies(vtkDataObject* input);

/// Returns a selector (vtkSurfaceIntegralBase::AddSelector) for every product whose name matches the pattern
/// (MatchesPattern); if there is none, a selector that contains the pattern and selects nothing.
SMFILTERSPRODUCTS_EXPORT std::vector<std::string> FindProducts(
  vtkDataObject* input, const std::string& pattern);
}

#endif
