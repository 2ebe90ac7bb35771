#include "smPartMatch.h"

#include "smVector.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace sm
{
namespace
{
using Matrix3 = std::array<double, 9>;

/// Largest differences of two faces that count as equal.
struct Slack
{
  double Area, First, Second, VectorArea;
};

/// The invariants of a face under rotations about the reference, which two equal faces have in common.
struct Signature
{
  double Area, First, Trace, VectorArea, Along;
};

Signature GetSignature(const FaceAreaMoments& face)
{
  return { face.Area, Norm(face.First), face.GetTrace(), Norm(face.VectorArea),
    Dot(face.First, face.VectorArea) };
}

Slack GetSlack(const FaceAreaMoments& a, const FaceAreaMoments& b, double tolerance, double radius)
{
  const double area = std::max(a.Area, b.Area);
  return { tolerance * area + a.AreaBound + b.AreaBound,
    tolerance * area * radius + 3.0 * (a.FirstBound + b.FirstBound),
    2.0 * tolerance * area * radius * radius + 9.0 * (a.SecondBound + b.SecondBound),
    tolerance * area + 3.0 * (a.VectorAreaBound + b.VectorAreaBound) };
}

bool HaveSameSignature(const FaceAreaMoments& a, const FaceAreaMoments& b, double tolerance, double radius)
{
  const Slack slack = GetSlack(a, b, tolerance, radius);
  const Signature x = GetSignature(a);
  const Signature y = GetSignature(b);
  return std::abs(x.Area - y.Area) <= slack.Area && std::abs(x.First - y.First) <= 2.0 * slack.First &&
    std::abs(x.Trace - y.Trace) <= 3.0 * slack.Second &&
    std::abs(x.VectorArea - y.VectorArea) <= 2.0 * slack.VectorArea &&
    std::abs(x.Along - y.Along) <=
    2.0 * (slack.First * (x.VectorArea + slack.VectorArea) + slack.VectorArea * x.First);
}

template <std::size_t N>
bool AreNear(const std::array<double, N>& a, const std::array<double, N>& b, double slack)
{
  return std::equal(
    a.begin(), a.end(), b.begin(), [slack](double x, double y) { return std::abs(x - y) <= slack; });
}

bool AreEqual(const FaceAreaMoments& a, const FaceAreaMoments& b, double tolerance, double radius)
{
  const Slack slack = GetSlack(a, b, tolerance, radius);
  return std::abs(a.Area - b.Area) <= slack.Area && AreNear(a.First, b.First, slack.First) &&
    AreNear(a.VectorArea, b.VectorArea, slack.VectorArea) && AreNear(a.Second, b.Second, slack.Second);
}

/// A shape with its faces in the order of their areas.
struct SortedShape
{
  using OrderIterator = std::vector<std::size_t>::const_iterator;

  const PartShape* Shape;
  double Radius;
  double AreaBound = 0.0;
  std::vector<std::size_t> Order;

  explicit SortedShape(const PartShape& shape)
    : Shape(&shape)
    , Radius(shape.GetRadius())
    , Order(shape.Faces.size())
  {
    std::iota(this->Order.begin(), this->Order.end(), std::size_t{ 0 });
    std::sort(this->Order.begin(), this->Order.end(),
      [&shape](std::size_t x, std::size_t y) { return shape.Faces[x].Area < shape.Faces[y].Area; });
    for (const FaceAreaMoments& face : shape.Faces)
    {
      this->AreaBound = std::max(this->AreaBound, face.AreaBound);
    }
  }

  const FaceAreaMoments& GetFace(std::size_t i) const { return this->Shape->Faces[i]; }

  /// The part of Order with the faces that may have the area of this one.
  std::pair<OrderIterator, OrderIterator> FindArea(const FaceAreaMoments& face, double tolerance) const
  {
    const double slack = 2.0 * tolerance * face.Area + face.AreaBound + this->AreaBound;
    const auto begin = std::partition_point(this->Order.begin(), this->Order.end(),
      [&](std::size_t i) { return this->GetFace(i).Area < face.Area - slack; });
    return { begin,
      std::partition_point(begin, this->Order.end(),
        [&](std::size_t i) { return this->GetFace(i).Area <= face.Area + slack; }) };
  }
};

/// Returns true if the rotation maps the faces of `a` to those of `b`, one to one.
bool Carries(const Matrix3& rotation, const PartShape& a, const SortedShape& b, double tolerance)
{
  std::vector<bool> used(b.Order.size());
  for (const FaceAreaMoments& face : a.Faces)
  {
    FaceAreaMoments carried = face;
    carried.Rotate(rotation);
    const auto [begin, end] = b.FindArea(face, tolerance);
    const auto found = std::find_if(begin, end,
      [&](std::size_t i) { return !used[i] && AreEqual(carried, b.GetFace(i), tolerance, b.Radius); });
    if (found == end)
    {
      return false;
    }
    used[*found] = true;
  }
  return true;
}

/// A direction that a face defines: 0: to its centre, 1: its vector area, 2 to 4: a principal axis, of either
/// sign.
struct Direction
{
  std::size_t Face;
  int Kind;
  std::array<double, 3> Vector;
  /// Reliability of the direction, 0 to 1; rounding alone gives about 1e-12.
  double Weight;
};

/// Directions with a weight below this are determined by rounding.
constexpr double MinWeight = 1e-9;
constexpr int MaxRotations = 2000;

std::vector<Direction> GetDirections(const FaceAreaMoments& face, std::size_t index, double radius)
{
  std::vector<Direction> directions;
  const auto add = [&](int kind, const std::array<double, 3>& vector, double weight)
  {
    if (weight > MinWeight)
    {
      directions.push_back({ index, kind, Normalized(vector), std::min(weight, 1.0) });
    }
  };
  add(0, face.First, Norm(face.First) / (face.Area * radius));
  add(1, face.VectorArea, Norm(face.VectorArea) / face.Area);
  double matrix[3][3];
  double vectors[3][3];
  double* rows[3] = { matrix[0], matrix[1], matrix[2] };
  double* columns[3] = { vectors[0], vectors[1], vectors[2] };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      matrix[i][j] = face.Second[FaceAreaMoments::Pair[i][j]];
    }
  }
  double values[3];
  vtkMath::Jacobi(rows, values, columns);
  for (int k = 0; k < 3; ++k)
  {
    const double gap =
      std::min(std::abs(values[k] - values[(k + 1) % 3]), std::abs(values[k] - values[(k + 2) % 3]));
    add(2 + k, { vectors[0][k], vectors[1][k], vectors[2][k] }, gap / (face.Area * radius * radius));
  }
  return directions;
}

std::array<double, 3> GetAcross(const Direction& a, const Direction& b)
{
  return Cross(a.Vector, b.Vector);
}

/// Returns the rotation that maps the first pair of directions to the second pair; the angles between them
/// are equal.
Matrix3 MakeRotation(const std::array<double, 3>& a, const std::array<double, 3>& acrossA,
  const std::array<double, 3>& b, const std::array<double, 3>& acrossB)
{
  const std::array<double, 3> framesA[3] = { a, Normalized(acrossA), Cross(a, Normalized(acrossA)) };
  const std::array<double, 3> framesB[3] = { b, Normalized(acrossB), Cross(b, Normalized(acrossB)) };
  Matrix3 m{};
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        m[3 * i + j] += framesB[k][i] * framesA[k][j];
      }
    }
  }
  return m;
}

/// Any unit vector at right angles to a unit vector.
std::array<double, 3> GetPerpendicular(const std::array<double, 3>& v)
{
  std::array<double, 3> axis{};
  axis[std::min_element(v.begin(), v.end(), [](double x, double y) { return std::abs(x) < std::abs(y); }) -
    v.begin()] = 1.0;
  return Normalized(Cross(v, axis));
}

/// Returns the rotation by the smallest angle that maps one direction to another.
Matrix3 MakeSmallestRotation(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  std::array<double, 3> across = Cross(a, b);
  across = Norm(across) > 1e-12 ? across : GetPerpendicular(a);
  return MakeRotation(a, across, b, across);
}

/// Angle and axis of a rotation matrix.
void SetAngle(Rotation& rotation)
{
  const Matrix3& m = rotation.Matrix;
  const std::array<double, 3> twist{ m[7] - m[5], m[2] - m[6], m[3] - m[1] };
  const double sine = 0.5 * Norm(twist);
  const double cosine = 0.5 * (m[0] + m[4] + m[8] - 1.0);
  rotation.Angle = std::atan2(sine, cosine);
  if (sine > 1e-8)
  {
    rotation.Axis = Normalized(twist);
  }
  else if (cosine < 0.0)
  {
    // A rotation by pi: m + 1 is twice the projection on the axis.
    int k = 0;
    for (int i = 1; i < 3; ++i)
    {
      k = m[4 * i] > m[4 * k] ? i : k;
    }
    rotation.Axis = { m[k], m[3 + k], m[6 + k] };
    rotation.Axis[k] += 1.0;
    rotation.Axis = Normalized(rotation.Axis);
  }
}

/// Tests candidates, and keeps the one with the smallest angle.
class RotationSearch
{
public:
  RotationSearch(const PartShape& a, const PartShape& b, double tolerance)
    : A(a)
    , B(b)
    , Tolerance(tolerance)
  {
  }

  Rotation Run()
  {
    this->Try({ 1, 0, 0, 0, 1, 0, 0, 0, 1 });
    std::vector<Direction> all;
    for (std::size_t i = 0; i < this->A.Faces.size(); ++i)
    {
      const std::vector<Direction> own = GetDirections(this->A.Faces[i], i, this->B.Radius);
      all.insert(all.end(), own.begin(), own.end());
    }
    if (all.empty() || this->Result.IsFound)
    {
      // The shape is symmetric about every axis, or the identity maps it.
      return this->Result;
    }
    std::vector<std::size_t> counts(this->A.Faces.size());
    const auto getCount = [&](const Direction& direction)
    {
      std::size_t& count = counts[direction.Face];
      count = count > 0 ? count : this->FindFaces(direction.Face).size();
      return static_cast<double>(std::max<std::size_t>(count, 1)) * (direction.Kind >= 2 ? 2.0 : 1.0);
    };
    const auto first = std::max_element(all.begin(), all.end(),
      [&](const Direction& x, const Direction& y)
      { return x.Weight / getCount(x) < y.Weight / getCount(y); });
    const auto getWorth = [&](const Direction& direction)
    { return direction.Weight * Norm(GetAcross(*first, direction)) / getCount(direction); };
    const auto second = std::max_element(all.begin(), all.end(),
      [&](const Direction& x, const Direction& y) { return getWorth(x) < getWorth(y); });
    const bool isRound = second->Weight * Norm(GetAcross(*first, *second)) <= MinWeight;
    for (const Direction& image : this->FindImages(*first))
    {
      if (this->Tried > MaxRotations)
      {
        break;
      }
      if (isRound)
      {
        this->Try(MakeSmallestRotation(first->Vector, image.Vector));
      }
      else
      {
        this->TryImages(*first, image, *second);
      }
    }
    return this->Result;
  }

private:
  /// Returns the faces of B to which the face of A may be mapped.
  std::vector<std::size_t> FindFaces(std::size_t face) const
  {
    std::vector<std::size_t> found;
    const auto [begin, end] = this->B.FindArea(this->A.Faces[face], this->Tolerance);
    std::copy_if(begin, end, std::back_inserter(found),
      [&](std::size_t i) {
        return HaveSameSignature(this->A.Faces[face], this->B.GetFace(i), this->Tolerance, this->B.Radius);
      });
    return found;
  }

  /// Returns the directions of B to which a direction of A may be mapped.
  std::vector<Direction> FindImages(const Direction& direction) const
  {
    std::vector<Direction> images;
    for (const std::size_t face : this->FindFaces(direction.Face))
    {
      for (Direction image : GetDirections(this->B.GetFace(face), face, this->B.Radius))
      {
        if (image.Kind == direction.Kind)
        {
          images.push_back(image);
          if (image.Kind >= 2)
          {
            image.Vector = { -image.Vector[0], -image.Vector[1], -image.Vector[2] };
            images.push_back(image);
          }
        }
      }
    }
    return images;
  }

  void TryImages(const Direction& first, const Direction& firstImage, const Direction& second)
  {
    const std::array<double, 3> across = GetAcross(first, second);
    const double cosine = Dot(first.Vector, second.Vector);
    // The error of a direction is inversely proportional to its weight. Wrong candidates fail the test of the
    // faces.
    const double slack = 10.0 * this->Tolerance / std::min(first.Weight, second.Weight) + 1e-6;
    for (const Direction& image : this->FindImages(second))
    {
      const std::array<double, 3> acrossImage = GetAcross(firstImage, image);
      if (std::abs(Dot(firstImage.Vector, image.Vector) - cosine) <= slack &&
        Norm(acrossImage) > 0.5 * Norm(across))
      {
        this->Try(MakeRotation(first.Vector, across, firstImage.Vector, acrossImage));
      }
    }
  }

  void Try(const Matrix3& matrix)
  {
    Rotation rotation;
    rotation.Matrix = matrix;
    SetAngle(rotation);
    if ((this->Result.IsFound && rotation.Angle >= this->Result.Angle) || ++this->Tried > MaxRotations)
    {
      this->Result.IsComplete = this->Result.IsComplete && this->Tried <= MaxRotations;
      return;
    }
    if (Carries(matrix, this->A, this->B, this->Tolerance))
    {
      rotation.IsFound = true;
      rotation.IsComplete = this->Result.IsComplete;
      this->Result = rotation;
    }
  }

  const PartShape& A;
  SortedShape B;
  double Tolerance;
  int Tried = 0;
  Rotation Result;
};
}

bool MayBeEqual(const PartShape& a, const PartShape& b, double tolerance)
{
  if (!a.Problem.empty() || !b.Problem.empty() || a.IsSolid != b.IsSolid || a.Faces.size() != b.Faces.size())
  {
    return false;
  }
  const double area = a.GetArea();
  double bound = 0.0;
  for (std::size_t i = 0; i < a.Faces.size(); ++i)
  {
    bound += a.Faces[i].AreaBound + b.Faces[i].AreaBound;
  }
  return std::abs(area - b.GetArea()) <= tolerance * area + bound;
}

bool AreParallel(const PartShape& a, const PartShape& b, double tolerance)
{
  return MayBeEqual(a, b, tolerance) && Carries({ 1, 0, 0, 0, 1, 0, 0, 0, 1 }, a, SortedShape(b), tolerance);
}

Rotation FindRotation(const PartShape& a, const PartShape& b, double tolerance)
{
  return MayBeEqual(a, b, tolerance) ? RotationSearch(a, b, tolerance).Run() : Rotation();
}

bool AreMirrored(const PartShape& a, const PartShape& b, double tolerance)
{
  if (!MayBeEqual(a, b, tolerance))
  {
    return false;
  }
  constexpr double reflection[12] = { -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };
  PartShape image = a;
  image.Place(reflection);
  if (!RotationSearch(image, b, tolerance).Run().IsFound)
  {
    return false;
  }
  const Rotation rotation = RotationSearch(a, b, tolerance).Run();
  return !rotation.IsFound && rotation.IsComplete;
}
}
