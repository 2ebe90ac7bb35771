#include "smPartShape.h"

#include "smBodyScales.h"
#include "smIntegralEngine.h"
#include "smVector.h"

#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sm
{
namespace
{
using Matrix3 = std::array<double, 9>;

enum ShapeIntegrand
{
  ShapeArea = 0,
  ShapeFirst = 1,
  ShapeSecond = 4,
  ShapeVectorArea = 10,
  NumberOfShapeIntegrands = 13
};

IntegralRequest MakeShapeRequest(double relativeTolerance)
{
  IntegralRequest request;
  request.UsePlacements = false;
  const int powers[10][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 2, 0, 0 }, { 0, 2, 0 },
    { 0, 0, 2 }, { 1, 1, 0 }, { 0, 1, 1 }, { 1, 0, 1 } };
  for (int k = 0; k < 10; ++k)
  {
    request.Integrands.push_back(
      Integrand::AreaMoment("Shape" + std::to_string(k), powers[k][0], powers[k][1], powers[k][2]));
  }
  for (int i = 0; i < 3; ++i)
  {
    request.Integrands.push_back(Integrand::VectorArea("Normal" + std::to_string(i), i));
  }
  request.GetTolerances = [integrands = request.Integrands, relativeTolerance](const BodyIntegrals& body)
  {
    std::vector<double> tolerances;
    for (const Integrand& integrand : integrands)
    {
      tolerances.push_back(
        relativeTolerance * GetAreaScale(*body.Model) * std::pow(GetRadius(*body.Model), integrand.Degree));
    }
    return tolerances;
  };
  return request;
}

FaceAreaMoments MakeFace(const FaceIntegrals& integrals)
{
  FaceAreaMoments face;
  const auto get = [&integrals](int k) { return integrals.Face[k] + integrals.Closing[k]; };
  const auto getBound = [&integrals](int first, int count)
  {
    double bound = 0.0;
    for (int k = first; k < first + count; ++k)
    {
      // std::max is not used here because it may drop a NaN.
      bound = integrals.GetBound(k) <= bound ? bound : integrals.GetBound(k);
    }
    return bound;
  };
  face.Area = get(ShapeArea);
  for (int i = 0; i < 3; ++i)
  {
    face.First[i] = get(ShapeFirst + i);
    face.VectorArea[i] = get(ShapeVectorArea + i);
  }
  for (int i = 0; i < 6; ++i)
  {
    face.Second[i] = get(ShapeSecond + i);
  }
  face.AreaBound = getBound(ShapeArea, 1);
  face.FirstBound = getBound(ShapeFirst, 3);
  face.SecondBound = getBound(ShapeSecond, 6);
  face.VectorAreaBound = getBound(ShapeVectorArea, 3);
  return face;
}

bool IsFinite(const FaceAreaMoments& face)
{
  const double sum = face.Area + Norm(face.First) + Norm(face.VectorArea) + face.AreaBound + face.FirstBound +
    face.SecondBound + face.VectorAreaBound + std::accumulate(face.Second.begin(), face.Second.end(), 0.0);
  return std::isfinite(sum) && face.Area > 0.0;
}

/// Largest bounds of the integrals of a face that can be compared, relative to the face or, for small faces,
/// to the part. With larger bounds different faces would count as equal.
constexpr double MaxFaceBound = 1e-6;
constexpr double MaxPartBound = 1e-9;

bool IsAccurate(const PartShape& shape)
{
  const double radius = shape.GetRadius();
  const double area = shape.GetArea();
  return std::all_of(shape.Faces.begin(), shape.Faces.end(),
    [radius, area](const FaceAreaMoments& face)
    {
      const double largest = std::max(MaxFaceBound * face.Area, MaxPartBound * area);
      return face.AreaBound <= largest && face.FirstBound <= largest * radius &&
        face.SecondBound <= largest * radius * radius && face.VectorAreaBound <= largest;
    });
}

PartShape MakeShape(const BodyIntegrals& body)
{
  PartShape shape;
  shape.IsSolid = body.IsSolid();
  std::copy_n(body.Model->GetOrigin(), 3, shape.Reference.begin());
  for (const FaceIntegrals& integrals : *body.Faces)
  {
    if (!integrals.Error.empty() || integrals.Skipped)
    {
      shape.Problem = integrals.Skipped ? "some faces were not integrated in time" : integrals.Error;
      return shape;
    }
    shape.Faces.push_back(MakeFace(integrals));
    if (!IsFinite(shape.Faces.back()))
    {
      shape.Problem = "the integrals of a face are not finite numbers";
    }
  }
  if (shape.Faces.empty() || body.Model->GetNumberOfMissingFaces() > 0)
  {
    shape.Problem = "some faces are missing";
  }
  if (shape.Problem.empty() && !IsAccurate(shape))
  {
    shape.Problem = "the bounds of its faces are too wide";
  }
  return shape;
}

std::array<double, 3> Apply(const Matrix3& m, const std::array<double, 3>& v)
{
  return { Dot(m.data(), v.data()), Dot(m.data() + 3, v.data()), Dot(m.data() + 6, v.data()) };
}

/// Moves the reference of a face's moments by `shift`.
void MoveReference(const std::array<double, 3>& shift, FaceAreaMoments& face)
{
  const double distance = Norm(shift);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      face.Second[FaceAreaMoments::Pair[i][j]] +=
        face.Area * shift[i] * shift[j] - face.First[i] * shift[j] - face.First[j] * shift[i];
    }
  }
  face.SecondBound += 2.0 * distance * face.FirstBound + distance * distance * face.AreaBound;
  for (int i = 0; i < 3; ++i)
  {
    face.First[i] -= face.Area * shift[i];
  }
  face.FirstBound += distance * face.AreaBound;
}
}

void FaceAreaMoments::Rotate(const Matrix3& matrix)
{
  const std::array<double, 6> second = this->Second;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        for (int l = 0; l < 3; ++l)
        {
          sum += matrix[3 * i + k] * second[Pair[k][l]] * matrix[3 * j + l];
        }
      }
      this->Second[Pair[i][j]] = sum;
    }
  }
  this->First = Apply(matrix, this->First);
  this->VectorArea = Apply(matrix, this->VectorArea);
}

double PartShape::GetArea() const
{
  double area = 0.0;
  for (const FaceAreaMoments& face : this->Faces)
  {
    area += face.Area;
  }
  return area;
}

double PartShape::GetRadius() const
{
  double radius = 0.0;
  for (const FaceAreaMoments& face : this->Faces)
  {
    // Root mean square distance of the face's points from the reference.
    radius = std::max(radius, std::sqrt(std::max(face.GetTrace(), 0.0) / face.Area));
  }
  return radius;
}

void PartShape::Center()
{
  std::array<double, 3> shift{};
  const double area = this->GetArea();
  for (int i = 0; i < 3; ++i)
  {
    for (const FaceAreaMoments& face : this->Faces)
    {
      shift[i] += face.First[i];
    }
    shift[i] = area > 0.0 ? shift[i] / area : 0.0;
    this->Reference[i] += shift[i];
  }
  double bound = 0.0;
  for (FaceAreaMoments& face : this->Faces)
  {
    MoveReference(shift, face);
    bound += face.FirstBound / area;
  }
  // The centre of an equal shape has an error of the same size.
  for (FaceAreaMoments& face : this->Faces)
  {
    face.SecondBound += 2.0 * bound * Norm(face.First);
    face.FirstBound += bound * face.Area;
  }
}

void PartShape::Place(const double placement[12])
{
  Matrix3 matrix;
  for (int i = 0; i < 3; ++i)
  {
    std::copy_n(placement + 4 * i, 3, matrix.begin() + 3 * i);
  }
  this->Reference = Apply(matrix, this->Reference);
  for (int i = 0; i < 3; ++i)
  {
    this->Reference[i] += placement[4 * i + 3];
  }
  for (FaceAreaMoments& face : this->Faces)
  {
    face.Rotate(matrix);
  }
}

std::vector<PartShape> MeasureShapes(
  const std::vector<vtkTrimmedNURBSModel*>& models, double relativeTolerance, double maximumSeconds)
{
  std::vector<BodyIntegrals> bodies(models.size());
  for (std::size_t i = 0; i < models.size(); ++i)
  {
    bodies[i].Model = models[i];
  }
  IntegralEngine engine;
  engine.SetController(nullptr);
  IntegralLimits limits;
  limits.Backend = BackendChoice::CPU;
  limits.MaximumSeconds = maximumSeconds;
  limits.CacheFaceResults = false;
  limits.Progress = [](double) { return true; };
  const bool isDone = engine.Integrate(MakeShapeRequest(relativeTolerance), limits, bodies);
  std::vector<PartShape> shapes;
  for (const BodyIntegrals& body : bodies)
  {
    shapes.emplace_back();
    shapes.back().Problem = engine.GetReport().Reason;
    if (isDone)
    {
      shapes.back() = MakeShape(body);
    }
  }
  return shapes;
}
}
