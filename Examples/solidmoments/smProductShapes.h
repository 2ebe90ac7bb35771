/**
 * @file smProductShapes.h
 * @brief The shapes of the solids of a file as JSON, which the process that reads the file sends to the one that compares
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
/// Key of the shapes in the entry of a file, until they are compared.
constexpr const char* ShapesKey = "shapes";

/// Returns the shape of each model, and the model and the placement of each solid.
Json MeasureProduct(vtkCADReader* reader, const JobOptions& options, const Json& solids);

/// The data of a solid for the comparison.
struct SolidShape
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

/// Returns the shapes of solids by their ids, from the result of MeasureProduct().
std::map<std::string, SolidShape> ReadShapes(const Json& shapes);
}

#endif
