#include "smProductShapes.h"

#include "smProductTree.h"

#include "vtkCADReader.h"
#include "vtkMath.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <vector>

namespace sm
{
namespace
{
/// Relative tolerance of the integrals of shapes. Their bounds are mostly the rounding of the sums.
constexpr double ShapeTolerance = 1e-12;

Json WriteFace(const FaceShape& face)
{
  Json numbers = { face.Area };
  for (const double x : face.First)
  {
    numbers.push_back(x);
  }
  for (const double x : face.Second)
  {
    numbers.push_back(x);
  }
  for (const double x : face.VectorArea)
  {
    numbers.push_back(x);
  }
  for (const double x : { face.AreaBound, face.FirstBound, face.SecondBound, face.VectorAreaBound })
  {
    numbers.push_back(x);
  }
  return numbers;
}

FaceShape ReadFace(const Json& numbers)
{
  FaceShape face;
  auto next = numbers.begin();
  const auto read = [&next](double& x) { x = (next++)->get<double>(); };
  read(face.Area);
  std::for_each(face.First.begin(), face.First.end(), read);
  std::for_each(face.Second.begin(), face.Second.end(), read);
  std::for_each(face.VectorArea.begin(), face.VectorArea.end(), read);
  for (double* x : { &face.AreaBound, &face.FirstBound, &face.SecondBound, &face.VectorAreaBound })
  {
    read(*x);
  }
  return face;
}

Json WriteShape(const PartShape& shape)
{
  Json faces = Json::array();
  for (const FaceShape& face : shape.Problem.empty() ? shape.Faces : std::vector<FaceShape>())
  {
    faces.push_back(WriteFace(face));
  }
  return { { "reference", shape.Reference }, { "solid", shape.IsSolid }, { "problem", shape.Problem },
    { "faces", std::move(faces) } };
}
}

Json MeasureProduct(vtkCADReader* reader, const JobOptions& options, const Json& solids)
{
  std::set<std::string> ids;
  for (const Json& solid : solids)
  {
    ids.insert(solid["id"].get<std::string>());
  }
  std::vector<vtkTrimmedNURBSModel*> models;
  Json bodies = Json::array();
  for (const ProductBody& body : ListBodies(reader))
  {
    if (ids.count(body.Id) == 0)
    {
      continue;
    }
    const auto found = std::find(models.begin(), models.end(), body.Model);
    const auto index = static_cast<std::size_t>(found - models.begin());
    if (found == models.end())
    {
      models.push_back(body.Model);
    }
    bodies.push_back({ { "id", body.Id }, { "model", index }, { "placement", body.Placement } });
  }
  double seconds = 0.0;
  if (options.MaximumSeconds > 0.0)
  {
    const std::chrono::duration<double> left = options.Deadline - std::chrono::steady_clock::now();
    seconds = std::max(left.count(), 1e-9);
  }
  Json shapes = Json::array();
  for (const PartShape& shape : MeasureShapes(models, ShapeTolerance, seconds))
  {
    shapes.push_back(WriteShape(shape));
  }
  return { { "models", std::move(shapes) }, { "bodies", std::move(bodies) } };
}

bool SolidShape::IsMirrored() const
{
  const std::array<double, 12>& m = this->Placement;
  return vtkMath::Determinant3x3(m.data(), m.data() + 4, m.data() + 8) < 0.0;
}

std::array<double, 3> SolidShape::GetCenter() const
{
  PartShape point;
  point.Reference = this->Shape->Reference;
  point.Place(this->Placement.data());
  return point.Reference;
}

PartShape SolidShape::GetPlaced() const
{
  PartShape placed = *this->Shape;
  placed.Place(this->Placement.data());
  return placed;
}

std::map<std::string, SolidShape> ReadShapes(const Json& shapes)
{
  std::vector<std::shared_ptr<const PartShape>> models;
  for (const Json& entry : shapes["models"])
  {
    auto shape = std::make_shared<PartShape>();
    shape->Reference = entry["reference"].get<std::array<double, 3>>();
    shape->IsSolid = entry["solid"].get<bool>();
    shape->Problem = entry["problem"].get<std::string>();
    for (const Json& face : entry["faces"])
    {
      shape->Faces.push_back(ReadFace(face));
    }
    shape->Center();
    models.push_back(std::move(shape));
  }
  std::map<std::string, SolidShape> solids;
  for (const Json& body : shapes["bodies"])
  {
    const auto model = body["model"].get<std::size_t>();
    solids[body["id"].get<std::string>()] = { model, models.at(model),
      body["placement"].get<std::array<double, 12>>() };
  }
  return solids;
}
}
