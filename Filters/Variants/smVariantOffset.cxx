#include "smVariantShape.h"

#include "smVector.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr std::size_t MaxOffsetPoints = 400;

/// Values of the B-splines at a parameter, by the recurrence of Cox and de Boor.
std::vector<double> GetBasis(const NURBSSurface& surface, int direction, double u)
{
  const std::vector<double>& knots = surface.Knots[direction];
  const int p = surface.Degree[direction];
  const int n = surface.NumberOfControlPoints[direction];
  int span = p;
  while (span + 1 < n && u >= knots[span + 1])
  {
    ++span;
  }
  std::vector<double> basis(n, 0.0);
  basis[span] = 1.0;
  for (int d = 1; d <= p; ++d)
  {
    for (int i = span - d; i <= span; ++i)
    {
      const double left = i > span - d ? (u - knots[i]) / (knots[i + d] - knots[i]) * basis[i] : 0.0;
      const double right =
        i < span ? (knots[i + d + 1] - u) / (knots[i + d + 1] - knots[i + 1]) * basis[i + 1] : 0.0;
      basis[i] = left + right;
    }
  }
  return basis;
}

/// Nodes between the Greville abscissae and the inside of the domain, so that none lies on a pole.
std::vector<double> GetNodes(const NURBSSurface& surface, int direction)
{
  const int p = surface.Degree[direction];
  const int n = surface.NumberOfControlPoints[direction];
  const double middle = 0.5 * (surface.GetDomainStart(direction) + surface.GetDomainEnd(direction));
  std::vector<double> nodes;
  for (int i = 0; i < n; ++i)
  {
    double sum = 0.0;
    for (int k = 1; k <= p; ++k)
    {
      sum += surface.Knots[direction][i + k];
    }
    nodes.push_back(0.999 * sum / p + 0.001 * middle);
  }
  return nodes;
}

/// Solves matrix x = right for three right sides, with pivots; returns false if it is singular.
bool Solve(std::vector<double>& matrix, std::vector<Vector3>& right)
{
  const std::size_t n = right.size();
  for (std::size_t k = 0; k < n; ++k)
  {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
    {
      pivot = std::abs(matrix[i * n + k]) > std::abs(matrix[pivot * n + k]) ? i : pivot;
    }
    if (!(std::abs(matrix[pivot * n + k]) > 1e-12))
    {
      return false;
    }
    if (pivot != k)
    {
      std::swap_ranges(matrix.begin() + static_cast<std::ptrdiff_t>(k * n),
        matrix.begin() + static_cast<std::ptrdiff_t>((k + 1) * n),
        matrix.begin() + static_cast<std::ptrdiff_t>(pivot * n));
      std::swap(right[k], right[pivot]);
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      const double factor = i == k ? 0.0 : matrix[i * n + k] / matrix[k * n + k];
      for (std::size_t j = k; factor != 0.0 && j < n; ++j)
      {
        matrix[i * n + j] -= factor * matrix[k * n + j];
      }
      for (int c = 0; factor != 0.0 && c < 3; ++c)
      {
        right[i][c] -= factor * right[k][c];
      }
    }
  }
  for (std::size_t k = 0; k < n; ++k)
  {
    for (double& x : right[k])
    {
      x /= matrix[k * n + k];
    }
  }
  return true;
}
}

vtkSmartPointer<vtkTrimmedNURBSModel> MakeNormalOffset(
  vtkTrimmedNURBSModel* base, int face, std::string& error)
{
  error.clear();
  if (!base || face < 0 || face >= base->GetNumberOfFaces())
  {
    error = "face " + std::to_string(face) + " does not exist: faces are counted from 0";
    return nullptr;
  }
  auto moved = std::make_shared<Face>(*base->GetFaces()[face]);
  NURBSSurface& surface = moved->Surface;
  const std::size_t count = surface.ControlPoints.size();
  if (count > MaxOffsetPoints)
  {
    error = "face " + std::to_string(face) + " has " + std::to_string(count) +
      " control points, more than 400: give its displacements yourself";
    return nullptr;
  }
  const std::vector<double> nodes[2] = { GetNodes(surface, 0), GetNodes(surface, 1) };
  std::vector<double> matrix(count * count);
  std::vector<Vector3> normals(count);
  const int columns = surface.NumberOfControlPoints[0];
  for (std::size_t k = 0; k < count; ++k)
  {
    const double u = nodes[0][k % static_cast<std::size_t>(columns)];
    const double v = nodes[1][k / static_cast<std::size_t>(columns)];
    Vector3 position;
    Vector3 du;
    Vector3 dv;
    surface.Evaluate(u, v, position.data(), du.data(), dv.data());
    const Vector3 normal = moved->Reversed ? Cross(dv, du) : Cross(du, dv);
    const double length = Norm(normal);
    if (!(length > 0.0))
    {
      error = "face " + std::to_string(face) + " has no normal at a point: give its displacements yourself";
      return nullptr;
    }
    const std::vector<double> ofU = GetBasis(surface, 0, u);
    const std::vector<double> ofV = GetBasis(surface, 1, v);
    double weight = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double value =
        ofU[i % static_cast<std::size_t>(columns)] * ofV[i / static_cast<std::size_t>(columns)];
      matrix[k * count + i] = value;
      weight += value * surface.ControlPoints[i][3];
    }
    // The displacements times the weights are the unknowns.
    for (int c = 0; c < 3; ++c)
    {
      normals[k][c] = weight * normal[c] / length;
    }
  }
  if (!Solve(matrix, normals))
  {
    error = "face " + std::to_string(face) +
      " has control points that do not matter: give its displacements yourself";
    return nullptr;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      surface.ControlPoints[i][c] += normals[i][c];
    }
  }
  moved->Id = NewId();
  auto model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  model->ShallowCopy(base);
  model->SetFace(face, moved);
  return model;
}
}
