/**
 * @file smPlacedBox.h
 * @brief A box in a placement that was read: its integrals in closed form for every placement that rounds to
 * the same
 */
#ifndef smPlacedBox_h
#define smPlacedBox_h

#include "smLatticeBody.h"
#include "smPlacementError.h"

#include <vtkMatrix4x4.h>

#include <cmath>
#include <random>

namespace smtest
{
struct PlacedBox
{
  using Real = long double;
  using Vector = std::array<Real, 3>;

  /// Edges[d] is the vector from Corner along the edge d, in world coordinates.
  Vector Edges[3];
  Vector Corner;

  static constexpr double Size[3] = { 2.0, 3.0, 5.0 };

  /// Returns the box as a leaf with this placement. The faces are marked as read from a file by a small
  /// Rounding, far below that of the placement, for only then the filters take the placement as rounded.
  static vtkSmartPointer<vtkNURBSDataSet> MakeLeaf(vtkMatrix4x4* placement)
  {
    LatticeBody body;
    body.Degree = 1;
    body.Knots = { 0.0, 0.0, 1.0, 1.0 };
    const auto leaf = body.Make();
    for (int f = 0; f < 6; ++f)
    {
      auto face = std::make_shared<sm::Face>(*leaf->GetModel()->GetFaces()[f]);
      face->Surface.Rounding = { 1e-25, 1e-25, 1e-25 };
      leaf->GetModel()->SetFace(f, face);
    }
    leaf->SetPlacement(placement);
    return leaf;
  }

  /// Sets a rotation about (1, 2, 2) and a translation by (-distance, distance, distance).
  static void SetPlacement(double distance, vtkMatrix4x4* placement)
  {
    // By 90 degrees about a unit vector n: n n^T + [n]x, all entries are ninths.
    const double ninths[3][3] = { { 1, -4, 8 }, { 8, 4, 1 }, { -4, 7, 4 } };
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        placement->SetElement(i, j, ninths[i][j] / 9.0);
      }
      placement->SetElement(i, 3, i == 0 ? -distance : distance);
    }
  }

  /// Makes the box in a placement whose every entry is off by as much as PlacementError allows, up or down at
  /// random.
  template <class Random>
  PlacedBox(vtkMatrix4x4* placement, Random& random)
  {
    std::bernoulli_distribution coin;
    const auto off = [&]()
    { return (coin(random) ? 1 : -1) * static_cast<Real>(sm::PlacementError::Rounding); };
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        this->Edges[j][i] = (placement->GetElement(i, j) + off()) * Size[j];
      }
      this->Corner[i] = placement->GetElement(i, 3) * (1 + off());
    }
  }

  static Vector Cross(const Vector& a, const Vector& b)
  {
    return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
  }
  Real GetVolume() const
  {
    const Vector n = Cross(this->Edges[0], this->Edges[1]);
    return n[0] * this->Edges[2][0] + n[1] * this->Edges[2][1] + n[2] * this->Edges[2][2];
  }
  Vector GetMiddle() const
  {
    Vector middle = this->Corner;
    for (int c = 0; c < 3; ++c)
    {
      middle[c] += (this->Edges[0][c] + this->Edges[1][c] + this->Edges[2][c]) / 2;
    }
    return middle;
  }
  Real GetArea() const
  {
    Real area = 0;
    for (int i = 0; i < 3; ++i)
    {
      const Vector n = Cross(this->Edges[i], this->Edges[(i + 1) % 3]);
      area += 2 * std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    }
    return area;
  }
  /// Volume of the part below a plane that cuts the four edges along Edges[2].
  Real GetVolumeBelow(const double point[3], const double up[3]) const
  {
    const auto dot = [up](const Vector& a) { return up[0] * a[0] + up[1] * a[1] + up[2] * a[2]; };
    const Vector depth{ point[0] - this->Corner[0], point[1] - this->Corner[1], point[2] - this->Corner[2] };
    return this->GetVolume() * (dot(depth) - (dot(this->Edges[0]) + dot(this->Edges[1])) / 2) /
      dot(this->Edges[2]);
  }
};
}

#endif
