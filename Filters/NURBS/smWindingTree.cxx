#include "smWindingTree.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sm
{
namespace
{
/// Largest number of triangles of a leaf.
constexpr std::size_t LeafSize = 8;
/// Halving reaches leaves of any mesh that fits into memory.
constexpr int MaximumStack = 96;

Vector3 GetAreaVector(const std::array<Vector3, 3>& t)
{
  const Vector3 twice = Cross(Subtract(t[1], t[0]), Subtract(t[2], t[0]));
  return { 0.5 * twice[0], 0.5 * twice[1], 0.5 * twice[2] };
}

Vector3 GetCentroid(const std::array<Vector3, 3>& t)
{
  Vector3 c;
  for (int d = 0; d < 3; ++d)
  {
    c[d] = (t[0][d] + t[1][d] + t[2][d]) / 3.0;
  }
  return c;
}

double GetDistanceToSegment(const Vector3& p, const Vector3& a, const Vector3& b)
{
  const Vector3 along = Subtract(b, a);
  const Vector3 toPoint = Subtract(p, a);
  const double squared = Dot(along, along);
  const double x = squared > 0.0 ? std::clamp(Dot(toPoint, along) / squared, 0.0, 1.0) : 0.0;
  return Norm(Vector3{ toPoint[0] - x * along[0], toPoint[1] - x * along[1], toPoint[2] - x * along[2] });
}

/// Returns the dipole and its first moment at the vector r from the point to the cluster's centre, without the factor 1/(4 pi).
double EvaluateExpansion(const Vector3& r, const Vector3& area, const std::array<double, 6>& m)
{
  // The integral of n.f(x-p) over the cluster with f(r) = r/|r|^3, expanded at its centre: df_i/dr_j = d_ij/|r|^3 - 3 r_i r_j/|r|^5.
  const double squared = Dot(r, r);
  const double quadratic = m[0] * r[0] * r[0] + m[1] * r[1] * r[1] + m[2] * r[2] * r[2] +
    2.0 * (m[3] * r[0] * r[1] + m[4] * r[1] * r[2] + m[5] * r[0] * r[2]);
  return (Dot(area, r) + m[0] + m[1] + m[2] - 3.0 * quadratic / squared) / (squared * std::sqrt(squared));
}
}

double EstimateDeviation(const std::array<Vector3, 3>& corners, const std::array<Vector3, 3>& normals)
{
  // A surface that is inclined by the angle a against a chord of length h at the chord's ends deviates from it by about h a / 4
  // at most; twice this distance is assumed.
  const Vector3 own = Cross(Subtract(corners[1], corners[0]), Subtract(corners[2], corners[0]));
  const double area = Norm(own);
  double longest = 0.0;
  double sine = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    longest = std::max(longest, Norm(Subtract(corners[(i + 1) % 3], corners[i])));
    sine = std::max(sine, area > 0.0 ? Norm(Cross(own, normals[i])) / area : 1.0);
  }
  return 0.5 * longest * std::min(sine, 1.0);
}

double GetSolidAngle(const Vector3& p, const std::array<Vector3, 3>& t)
{
  const Vector3 a = Subtract(t[0], p);
  const Vector3 b = Subtract(t[1], p);
  const Vector3 c = Subtract(t[2], p);
  const double la = Norm(a);
  const double lb = Norm(b);
  const double lc = Norm(c);
  const double below = la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb;
  return 2.0 * std::atan2(Dot(a, Cross(b, c)), below);
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

WindingTree::WindingTree(const std::vector<MeshTriangle>& triangles)
  : Triangles(triangles)
  , Order(triangles.size())
{
  std::iota(this->Order.begin(), this->Order.end(), std::size_t{ 0 });
  if (triangles.empty())
  {
    return;
  }
  this->Nodes.reserve(4 * triangles.size() / LeafSize + 1);
  // Build() orders the indices, and takes its sums of the triangles as they are given.
  this->Build(0, triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    this->Triangles[i] = triangles[this->Order[i]];
  }
}

std::size_t WindingTree::Build(std::size_t begin, std::size_t end)
{
  const std::size_t index = this->Nodes.size();
  this->Nodes.emplace_back();
  Node node;
  node.Begin = begin;
  node.End = end;
  this->Summarize(node);
  if (end - begin > LeafSize)
  {
    int axis = 0;
    for (int d = 1; d < 3; ++d)
    {
      axis = node.High[d] - node.Low[d] > node.High[axis] - node.Low[axis] ? d : axis;
    }
    const auto getPlace = [this, axis](std::size_t i)
    {
      const std::array<Vector3, 3>& t = this->Triangles[i].Corners;
      return t[0][axis] + t[1][axis] + t[2][axis];
    };
    const auto first = this->Order.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = this->Order.begin() + static_cast<std::ptrdiff_t>(end);
    const std::size_t middle = (begin + end) / 2;
    std::nth_element(first, this->Order.begin() + static_cast<std::ptrdiff_t>(middle), last,
      [&getPlace](std::size_t a, std::size_t b)
      {
        const double x = getPlace(a);
        const double y = getPlace(b);
        return x < y || (x == y && a < b);
      });
    this->Build(begin, middle);
    node.Second = this->Build(middle, end);
  }
  this->Nodes[index] = node;
  return index;
}

void WindingTree::Summarize(Node& node) const
{
  const double largest = std::numeric_limits<double>::max();
  node.Low.fill(largest);
  node.High.fill(-largest);
  double weight = 0.0;
  Vector3 mean{};
  for (std::size_t i = node.Begin; i < node.End; ++i)
  {
    const MeshTriangle& triangle = this->Triangles[this->Order[i]];
    const Vector3 centroid = GetCentroid(triangle.Corners);
    const Vector3 vector = GetAreaVector(triangle.Corners);
    const double area = Norm(vector);
    weight += area;
    node.Deviation = std::max(node.Deviation, triangle.Deviation);
    for (int d = 0; d < 3; ++d)
    {
      for (const Vector3& corner : triangle.Corners)
      {
        node.Low[d] = std::min(node.Low[d], corner[d]);
        node.High[d] = std::max(node.High[d], corner[d]);
      }
      mean[d] += area * centroid[d];
      node.Area[d] += vector[d];
    }
  }
  for (int d = 0; d < 3; ++d)
  {
    node.Center[d] = weight > 0.0 ? mean[d] / weight : 0.5 * (node.Low[d] + node.High[d]);
  }
  for (std::size_t i = node.Begin; i < node.End; ++i)
  {
    const std::array<Vector3, 3>& corners = this->Triangles[this->Order[i]].Corners;
    const Vector3 c = Subtract(GetCentroid(corners), node.Center);
    const Vector3 a = GetAreaVector(corners);
    for (int d = 0; d < 3; ++d)
    {
      const int e = (d + 1) % 3;
      node.Moment[d] += a[d] * c[d];
      node.Moment[3 + d] += 0.5 * (a[d] * c[e] + a[e] * c[d]);
      node.Radius = std::max(node.Radius, Norm(Subtract(corners[d], node.Center)));
    }
  }
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
      for (std::size_t i = node.Begin; i < node.End; ++i)
      {
        sum += this->Order[i] == without ? 0.0 : GetSolidAngle(p, this->Triangles[i].Corners);
      }
    }
  }
  return sum / (4.0 * vtkMath::Pi());
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
      if (!(GetDistance(p, this->Triangles[i].Corners) > this->Triangles[i].Deviation + slack))
      {
        return false;
      }
    }
  }
  return true;
}
}
