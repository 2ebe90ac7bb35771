#include "smWindingTree.h"

#include "smUnitRoundoff.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sm
{
namespace
{
/// Each child has at most 15/16 of the triangles of its parent, so this depth reaches the leaves of any mesh
/// that fits into memory.
constexpr int MaximumStack = 512;

double GetDistanceToSegment(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 along = Subtract(b, a);
  const Vector3 toPoint = Subtract(p, a);
  const double squared = Dot(along, along);
  const double x = squared > 0.0 ? std::clamp(Dot(toPoint, along) / squared, 0.0, 1.0) : 0.0;
  return Norm(Vector3{ toPoint[0] - x * along[0], toPoint[1] - x * along[1], toPoint[2] - x * along[2] });
}

/// Returns the dipole and its first moment at the vector r from the point to the cluster's centre, without
/// the factor 1/(4 pi).
double EvaluateExpansion(const Vector3& r, const Vector3& area, const std::array<double, 6>& m)
{
  // The integral of n.f(x-p) over the cluster with f(r) = r/|r|^3, expanded at its centre: df_i/dr_j =
  // d_ij/|r|^3 - 3 r_i r_j/|r|^5.
  const double squared = Dot(r, r);
  const double quadratic = m[0] * r[0] * r[0] + m[1] * r[1] * r[1] + m[2] * r[2] * r[2] +
    2.0 * (m[3] * r[0] * r[1] + m[4] * r[1] * r[2] + m[5] * r[0] * r[2]);
  return (Dot(area, r) + m[0] + m[1] + m[2] - 3.0 * quadratic / squared) / (squared * std::sqrt(squared));
}

/// Half the solid angle of a triangle seen from p is the argument of Below + i Above.
struct HalfAngle
{
  double Above;
  double Below;
  /// No less than a quarter of |Below + i Above|; 0 in a corner.
  double Scale;

  HalfAngle(const Vector3& p, const Vector3& first, const Vector3& second, const Vector3& third)
  {
    const Vector3 a = Subtract(first, p);
    const Vector3 b = Subtract(second, p);
    const Vector3 c = Subtract(third, p);
    const double la = Norm(a);
    const double lb = Norm(b);
    const double lc = Norm(c);
    this->Above = Dot(a, Cross(b, c));
    this->Scale = la * lb * lc;
    this->Below = this->Scale + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb;
  }
};
}

double GetSolidAngle(const Vector3& p, const std::array<Vector3, 3>& t)
{
  const HalfAngle angle(p, t[0], t[1], t[2]);
  return 2.0 * std::atan2(angle.Above, angle.Below);
}

double GetDistance(const Vector3& p, const std::array<Vector3, 3>& t)
{
  const Vector3 normal = Cross(Subtract(t[1], t[0]), Subtract(t[2], t[0]));
  const double length = Norm(normal);
  bool above = length > 0.0;
  double border = 1e300;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3& a = t[i];
    const Vector3& b = t[(i + 1) % 3];
    above = above && Dot(Cross(Subtract(b, a), Subtract(p, a)), normal) >= 0.0;
    border = std::min(border, GetDistanceToSegment(p, a, b));
  }
  return above ? std::abs(Dot(Subtract(p, t[0]), normal)) / length : border;
}

std::array<Vector3, 3> WindingTree::GetTriangle(std::size_t i) const
{
  std::array<Vector3, 3> corners;
  for (std::size_t c = 0; c < this->Coordinates.size(); ++c)
  {
    corners[c / 3][c % 3] = this->Coordinates[c][i];
  }
  return corners;
}

/// The sum of the solid angles of a leaf's triangles, by the argument of a product of complex numbers.
double WindingTree::SumAngles(const Vector3& p, const Node& node, std::size_t without) const
{
  // Triangles behind the leaf fill up the lanes.
  const double* coordinates[9];
  for (std::size_t c = 0; c < this->Coordinates.size(); ++c)
  {
    coordinates[c] = this->Coordinates[c].data() + node.Begin;
  }
  double above[LeafSize];
  double below[LeafSize];
  double scales[LeafSize];
  for (std::size_t i = 0; i < LeafSize; ++i)
  {
    const auto getCorner = [&coordinates, i](int k) {
      return Vector3{ coordinates[3 * k][i], coordinates[3 * k + 1][i], coordinates[3 * k + 2][i] };
    };
    const HalfAngle angle(p, getCorner(0), getCorner(1), getCorner(2));
    above[i] = angle.Above / angle.Scale;
    below[i] = angle.Below / angle.Scale;
    scales[i] = angle.Scale;
  }
  double re = 1.0;
  double im = 0.0;
  double turns = 0.0;
  for (std::size_t i = 0; i < node.End - node.Begin; ++i)
  {
    if (this->Order[node.Begin + i] == without || !(scales[i] > 0.0))
    {
      continue;
    }
    const double x = below[i];
    const double y = above[i];
    const double before = im;
    im = re * y + im * x;
    re = re * x - before * y;
    // Two angles of one sign whose sum is of the other one have passed pi.
    turns += before >= 0.0 && y >= 0.0 && im < 0.0 ? 1.0 : before < 0.0 && y < 0.0 && im >= 0.0 ? -1.0 : 0.0;
  }
  return 2.0 * (std::atan2(im, re) + turns * 2.0 * vtkMath::Pi());
}

double WindingTree::EvaluateExactWindingNumber(const Vector3& p, std::size_t without) const
{
  return this->Evaluate(p, without, std::numeric_limits<double>::infinity());
}

double WindingTree::Evaluate(const Vector3& p, std::size_t without, double farRatio) const
{
  double sum = 0.0;
  std::size_t stack[MaximumStack];
  int size = 0;
  if (!this->Nodes.empty())
  {
    stack[size++] = 0;
  }
  while (size > 0)
  {
    const std::size_t index = stack[--size];
    const Node& node = this->Nodes[index];
    const Vector3 r = Subtract(node.Center, p);
    if (Norm(r) > farRatio * node.Radius)
    {
      sum += EvaluateExpansion(r, node.Area, node.Moment);
    }
    else if (node.Second > 0)
    {
      stack[size++] = node.Second;
      stack[size++] = index + 1;
    }
    else
    {
      sum += this->SumAngles(p, node, without);
    }
  }
  return sum / (4.0 * vtkMath::Pi());
}

/// Decides for the triangles of a leaf by the signs of three determinants, the projected areas of p with the
/// sides of a triangle. All of them have one sign if the ray's line crosses it, and that of the sum is the
/// side from which. No determinant, nor the height of the crossing over p, may be below its rounding.
bool WindingTree::CountInLeaf(
  const Vector3& p, const Node& node, int axis, double direction, int& number) const
{
  // Differences of coordinates round once, products and their difference three times.
  constexpr double roundings = 8.0 * UnitRoundoff;
  const int b = (axis + 1) % 3;
  const int c = (axis + 2) % 3;
  double area[3][LeafSize];
  double limit[3][LeafSize];
  // Triangles behind the leaf fill up the lanes.
  for (int k = 0; k < 3; ++k)
  {
    const int from = 3 * ((k + 1) % 3);
    const int to = 3 * ((k + 2) % 3);
    const double* const x0 = this->Coordinates[from + b].data() + node.Begin;
    const double* const y0 = this->Coordinates[from + c].data() + node.Begin;
    const double* const x1 = this->Coordinates[to + b].data() + node.Begin;
    const double* const y1 = this->Coordinates[to + c].data() + node.Begin;
    for (std::size_t i = 0; i < LeafSize; ++i)
    {
      const double first = (x0[i] - p[b]) * (y1[i] - p[c]);
      const double second = (x1[i] - p[b]) * (y0[i] - p[c]);
      area[k][i] = first - second;
      limit[k][i] = roundings * (std::abs(first) + std::abs(second));
    }
  }
  for (std::size_t i = 0; i < node.End - node.Begin; ++i)
  {
    bool mayBePositive = true;
    bool mayBeNegative = true;
    bool isCertain = true;
    for (int k = 0; k < 3; ++k)
    {
      mayBePositive = mayBePositive && area[k][i] >= -limit[k][i];
      mayBeNegative = mayBeNegative && area[k][i] <= limit[k][i];
      isCertain = isCertain && std::abs(area[k][i]) > limit[k][i];
    }
    if (!mayBePositive && !mayBeNegative)
    {
      continue;
    }
    // The height of the crossing over p, times the area, and its rounding.
    double sum = 0.0;
    double rounding = 0.0;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (int k = 0; k < 3; ++k)
    {
      const double height = direction * (this->Coordinates[3 * k + axis][node.Begin + i] - p[axis]);
      low = std::min(low, height);
      high = std::max(high, height);
      sum += area[k][i] * height;
      rounding += (limit[k][i] + 4.0 * roundings * std::abs(area[k][i])) * std::abs(height);
    }
    if (high < 0.0)
    {
      continue;
    }
    const bool isAhead = low > 0.0;
    if (!isCertain || (!isAhead && !(std::abs(sum) > 1.01 * rounding)))
    {
      return false;
    }
    const bool isPositive = area[0][i] > 0.0;
    if (isAhead || (sum > 0.0) == isPositive)
    {
      // The triangle's normal has the sign of the area along the axis.
      number += (direction > 0.0) == isPositive ? 1 : -1;
    }
  }
  return true;
}

bool WindingTree::CountAlong(const Vector3& p, int axis, bool upwards, int& number) const
{
  const int b = (axis + 1) % 3;
  const int c = (axis + 2) % 3;
  number = 0;
  std::size_t stack[MaximumStack];
  int size = 0;
  if (!this->Nodes.empty())
  {
    stack[size++] = 0;
  }
  while (size > 0)
  {
    const std::size_t index = stack[--size];
    const Node& node = this->Nodes[index];
    if (node.Low[b] > p[b] || node.High[b] < p[b] || node.Low[c] > p[c] || node.High[c] < p[c] ||
      (upwards ? node.High[axis] < p[axis] : node.Low[axis] > p[axis]))
    {
      continue;
    }
    if (node.Second > 0)
    {
      stack[size++] = node.Second;
      stack[size++] = index + 1;
    }
    else if (!this->CountInLeaf(p, node, axis, upwards ? 1.0 : -1.0, number))
    {
      return false;
    }
  }
  return true;
}

bool WindingTree::CountCrossings(const Vector3& p, int& number) const
{
  number = 0;
  int axis = 0;
  bool upwards = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (int d = 0; d < 3 && !this->Nodes.empty(); ++d)
  {
    for (const bool isUp : { true, false })
    {
      const double distance = isUp ? this->Nodes[0].High[d] - p[d] : p[d] - this->Nodes[0].Low[d];
      if (distance < nearest)
      {
        nearest = distance;
        axis = d;
        upwards = isUp;
      }
    }
  }
  return this->CountAlong(p, axis, upwards, number);
}

bool WindingTree::IsFarFrom(const Vector3& p, double slack) const
{
  std::size_t stack[MaximumStack];
  int size = 0;
  if (!this->Nodes.empty())
  {
    stack[size++] = 0;
  }
  while (size > 0)
  {
    const std::size_t index = stack[--size];
    const Node& node = this->Nodes[index];
    Vector3 out;
    for (int d = 0; d < 3; ++d)
    {
      out[d] = std::max({ node.Low[d] - p[d], p[d] - node.High[d], 0.0 });
    }
    if (Norm(out) > node.Deviation + slack)
    {
      continue;
    }
    if (node.Second > 0)
    {
      stack[size++] = node.Second;
      stack[size++] = index + 1;
      continue;
    }
    for (std::size_t i = node.Begin; i < node.End; ++i)
    {
      if (!(GetDistance(p, this->GetTriangle(i)) > this->Deviations[i] + slack))
      {
        return false;
      }
    }
  }
  return true;
}
}
