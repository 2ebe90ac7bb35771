#include "smProductShapes.h"

#include "smProductBodies.h"
#include "smProductResults.h"

#include "vtkMath.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <set>
#include <vector>

namespace sm
{
namespace
{
/// Relative tolerance of the integrals of shapes. Their bounds are mostly the rounding of the sums.
constexpr double ShapeTolerance = 1e-12;

void Visit(Fields& fields, FaceAreaMoments& face)
{
  fields.Number("area", face.Area);
  fields.Point("first", face.First);
  fields.Numbers("second", face.Second.data(), 1, 6);
  fields.Point("vector_area", face.VectorArea);
  fields.Number("area_bound", face.AreaBound);
  fields.Number("first_bound", face.FirstBound);
  fields.Number("second_bound", face.SecondBound);
  fields.Number("vector_area_bound", face.VectorAreaBound);
}
}

void ProductShapes::Visit(Fields& fields)
{
  fields.List("models", this->Models,
    [&fields](PartShape& shape)
    {
      std::optional<bool> isSolid = shape.IsSolid;
      fields.Point("reference", shape.Reference);
      fields.Flag("solid", isSolid);
      fields.Text("problem", shape.Problem);
      fields.List("faces", shape.Faces, [&fields](FaceAreaMoments& face) { sm::Visit(fields, face); });
      shape.IsSolid = isSolid.value_or(false);
    });
  fields.List("bodies", this->Bodies,
    [&fields](Body& body)
    {
      fields.Text("id", body.Id);
      fields.Count("model", body.Model);
      fields.Numbers("placement", body.Placement.data(), 3, 4);
    });
}

ProductShapes MeasureProduct(vtkDataObject* input, const ProductResults& results, double seconds)
{
  std::set<std::string> ids;
  for (const SolidResults& solid : results.Solids)
  {
    ids.insert(solid.Id);
  }
  std::vector<vtkTrimmedNURBSModel*> models;
  ProductShapes result;
  for (const ProductBody& body : ListBodies(input))
  {
    if (ids.count(body.Id) == 0)
    {
      continue;
    }
    const auto found = std::find(models.begin(), models.end(), body.Model);
    const auto index = static_cast<long long>(found - models.begin());
    if (found == models.end())
    {
      models.push_back(body.Model);
    }
    result.Bodies.push_back({ body.Id, index, body.Placement });
  }
  result.Models = MeasureShapes(models, ShapeTolerance, seconds);
  return result;
}

bool PlacedPartShape::IsMirrored() const
{
  const std::array<double, 12>& m = this->Placement;
  return vtkMath::Determinant3x3(m.data(), m.data() + 4, m.data() + 8) < 0.0;
}

std::array<double, 3> PlacedPartShape::GetCenter() const
{
  PartShape point;
  point.Reference = this->Shape->Reference;
  point.Place(this->Placement.data());
  return point.Reference;
}

PartShape PlacedPartShape::GetPlaced() const
{
  PartShape placed = *this->Shape;
  placed.Place(this->Placement.data());
  return placed;
}

std::map<std::string, PlacedPartShape> ReadShapes(const ProductShapes& shapes)
{
  std::vector<std::shared_ptr<const PartShape>> models;
  for (const PartShape& given : shapes.Models)
  {
    auto shape = std::make_shared<PartShape>(given);
    shape->Center();
    models.push_back(std::move(shape));
  }
  std::map<std::string, PlacedPartShape> solids;
  for (const ProductShapes::Body& body : shapes.Bodies)
  {
    const auto model = static_cast<std::size_t>(body.Model);
    solids[body.Id] = { model, models.at(model), body.Placement };
  }
  return solids;
}
}
