/**
 * @file smProductShapes.h
 * @brief The shapes of the solids of a file, as JSON from the process that reads it to the one that compares
 */
#ifndef smProductShapes_h
#define smProductShapes_h

#include "smFileJob.h"
#include "smJson.h"
#include "smPartShape.h"

#include <array>
#include <map>
#include <memory>
#include <string>

namespace sm
{
/// The key of the entry of a file that has its shapes until they are compared.
constexpr const char* ShapesKey = "shapes";

/// The shape of each model that one of the solids is an instance of, and the model and the placement of each solid.
Json MeasureProduct(vtkCADReader* reader, const JobOptions& options, const Json& solids);

/// A solid as the comparison sees it.
struct SolidShape
{
  /// Index of the model, and its shape in its own coordinates, centred. Null if the solid has none.
  std::size_t Model = 0;
  std::shared_ptr<const PartShape> Shape;
  std::array<double, 12> Placement{};

  bool IsMirrored() const;
  /// Where the centre of the area is placed.
  std::array<double, 3> GetCenter() const;
  /// The shape as it is placed.
  PartShape GetPlaced() const;
};

/// The shapes of solids by their ids, from MeasureProduct().
std::map<std::string, SolidShape> ReadShapes(const Json& shapes);
}

#endif
