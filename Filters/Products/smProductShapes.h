/**
 * @file smProductShapes.h
 * @brief The shapes of the solids of a product; not installed
 */
#ifndef smProductShapes_h
#define smProductShapes_h

#include "smFields.h"
#include "smFiltersProductsModule.h"
#include "smPartShape.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkDataObject;

namespace sm
{
struct ProductResults;

/// The shape of each model, and the model and the placement of each solid.
struct SMFILTERSPRODUCTS_EXPORT ProductShapes
{
  struct Body
  {
    std::string Id;
    long long Model = 0;
    std::array<double, 12> Placement{};
  };
  std::vector<PartShape> Models;
  std::vector<Body> Bodies;

  void Visit(Fields& fields);
};

/// Measures the solids of an input that have results. `seconds`: the limit of all; 0: none.
SMFILTERSPRODUCTS_EXPORT ProductShapes MeasureProduct(
  vtkDataObject* input, const ProductResults& results, double seconds);

/// The data of a solid for the comparison.
struct PlacedPartShape
{
  /// Index of the model, and its shape in its own coordinates, centred. Null if the solid has none.
  std::size_t Model = 0;
  std::shared_ptr<const PartShape> Shape;
  std::array<double, 12> Placement{};

  bool IsMirrored() const;
  /// Returns the placed centre of the area.
  std::array<double, 3> GetCenter() const;
  /// Returns the placed shape.
  PartShape GetPlaced() const;
};

/// Returns the shapes of solids by their ids.
std::map<std::string, PlacedPartShape> ReadShapes(const ProductShapes& shapes);
}

#endif
