#include "smWindingTree.h"

#include "smParallelFor.h"

#include <algorithm>
#include <limits>

namespace sm
{
namespace
{
/// A cluster is first parted into triangles that are larger than this fraction of its extent and the others,
/// if either part has at least a 16th of the triangles.
constexpr double LargeShare = 0.5;
constexpr std::ptrdiff_t MinShare = 16;
/// Number of levels from the root that are split with all threads, and of triangles from which on.
constexpr int BranchLevels = 6;
constexpr std::size_t MinBranch = 2048;
/// Number of triangles that a thread reads at a time.
constexpr std::size_t Grain = 4096;

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

/// The longest side of the box.
double GetExtent(const std::array<Vector3, 3>& t)
{
  double extent = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    const auto [low, high] = std::minmax({ t[0][d], t[1][d], t[2][d] });
    extent = std::max(extent, high - low);
  }
  return extent;
}
}

WindingTree::WindingTree(const std::vector<MeshTriangle>& triangles)
{
  if (triangles.empty())
  {
    return;
  }
  Input input{ triangles, std::vector<Item>(triangles.size()) };
  ParallelFor(triangles.size(), Grain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        input.Items[i] = { GetCentroid(triangles[i].Corners), GetExtent(triangles[i].Corners), i };
      }
    });
  this->Join(MakeBranches(input), 0);
  this->Order.reserve(triangles.size());
  for (const Item& item : input.Items)
  {
    this->Order.push_back(item.Index);
  }
  ParallelFor(this->Coordinates.size(), 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t c = begin; c < end; ++c)
      {
        this->Coordinates[c].resize(triangles.size() + LeafSize);
        for (std::size_t i = 0; i < triangles.size(); ++i)
        {
          this->Coordinates[c][i] = triangles[this->Order[i]].Corners[c / 3][c % 3];
        }
      }
    });
  this->Deviations.reserve(triangles.size());
  for (const std::size_t i : this->Order)
  {
    this->Deviations.push_back(triangles[i].Deviation);
  }
}

std::size_t WindingTree::Split(Input& input, std::size_t begin, std::size_t end)
{
  Vector3 low = input.Items[begin].Centroid;
  Vector3 high = low;
  for (std::size_t i = begin; i < end; ++i)
  {
    const Vector3& c = input.Items[i].Centroid;
    for (int d = 0; d < 3; ++d)
    {
      low[d] = std::min(low[d], c[d]);
      high[d] = std::max(high[d], c[d]);
    }
  }
  int axis = 0;
  for (int d = 1; d < 3; ++d)
  {
    axis = high[d] - low[d] > high[axis] - low[axis] ? d : axis;
  }
  const auto first = input.Items.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto last = input.Items.begin() + static_cast<std::ptrdiff_t>(end);
  // Among large triangles no part of the cluster would be far away from anything.
  auto middle = std::stable_partition(first, last,
    [extent = LargeShare * (high[axis] - low[axis])](const Item& item) { return item.Extent > extent; });
  if (std::min(middle - first, last - middle) <= (last - first) / MinShare)
  {
    middle = first + (last - first) / 2;
    std::nth_element(first, middle, last,
      [axis](const Item& a, const Item& b)
      {
        const double x = a.Centroid[axis];
        const double y = b.Centroid[axis];
        return x < y || (x == y && a.Index < b.Index);
      });
  }
  return begin + static_cast<std::size_t>(middle - first);
}

std::size_t WindingTree::Build(Input& input, std::size_t begin, std::size_t end, std::vector<Node>& nodes)
{
  const std::size_t index = nodes.size();
  nodes.emplace_back();
  Node node;
  node.Begin = begin;
  node.End = end;
  if (end - begin <= LeafSize)
  {
    SumTriangles(input, node);
  }
  else
  {
    const std::size_t second = Split(input, begin, end);
    Build(input, begin, second, nodes);
    node.Second = Build(input, second, end, nodes);
    SumChildren(nodes[index + 1], nodes[node.Second], node);
  }
  nodes[index] = node;
  return index;
}

/// Splits level by level, and then builds the subtrees, each with all threads.
std::vector<WindingTree::Branch> WindingTree::MakeBranches(Input& input)
{
  std::vector<Branch> branches(1);
  branches[0].End = input.Items.size();
  std::size_t begin = 0;
  for (int level = 0; level < BranchLevels; ++level)
  {
    const std::size_t end = branches.size();
    std::vector<std::size_t> seconds(end - begin, 0);
    ParallelFor(end - begin, 1,
      [&](std::size_t first, std::size_t last)
      {
        for (std::size_t k = first; k < last; ++k)
        {
          const Branch& branch = branches[begin + k];
          const bool isLarge = branch.End - branch.Begin > MinBranch;
          seconds[k] = isLarge ? Split(input, branch.Begin, branch.End) : 0;
        }
      });
    for (std::size_t k = begin; k < end; ++k)
    {
      if (seconds[k - begin] > 0)
      {
        branches[k].Children[0] = branches.size();
        branches[k].Children[1] = branches.size() + 1;
        branches.push_back({ branches[k].Begin, seconds[k - begin], {}, {} });
        branches.push_back({ seconds[k - begin], branches[k].End, {}, {} });
      }
    }
    begin = end;
  }
  ParallelFor(branches.size(), 1,
    [&](std::size_t first, std::size_t last)
    {
      for (std::size_t k = first; k < last; ++k)
      {
        if (branches[k].Children[0] == 0)
        {
          Build(input, branches[k].Begin, branches[k].End, branches[k].Nodes);
        }
      }
    });
  return branches;
}

/// Appends the nodes of a branch; returns the index of its first one.
std::size_t WindingTree::Join(const std::vector<Branch>& branches, std::size_t index)
{
  const Branch& branch = branches[index];
  const std::size_t root = this->Nodes.size();
  if (branch.Children[0] == 0)
  {
    this->Nodes.insert(this->Nodes.end(), branch.Nodes.begin(), branch.Nodes.end());
    for (std::size_t i = root; i < this->Nodes.size(); ++i)
    {
      this->Nodes[i].Second += this->Nodes[i].Second > 0 ? root : 0;
    }
    return root;
  }
  Node node;
  node.Begin = branch.Begin;
  node.End = branch.End;
  this->Nodes.emplace_back();
  this->Join(branches, branch.Children[0]);
  node.Second = this->Join(branches, branch.Children[1]);
  SumChildren(this->Nodes[root + 1], this->Nodes[node.Second], node);
  this->Nodes[root] = node;
  return root;
}

void WindingTree::SumTriangles(const Input& input, Node& node)
{
  const double largest = std::numeric_limits<double>::max();
  node.Low.fill(largest);
  node.High.fill(-largest);
  std::array<Vector3, LeafSize> areas;
  Vector3 mean{};
  for (std::size_t i = node.Begin; i < node.End; ++i)
  {
    const MeshTriangle& triangle = input.Triangles[input.Items[i].Index];
    const Vector3 vector = GetAreaVector(triangle.Corners);
    areas[i - node.Begin] = vector;
    const double area = Norm(vector);
    node.Weight += area;
    node.Deviation = std::max(node.Deviation, triangle.Deviation);
    for (int d = 0; d < 3; ++d)
    {
      for (const Vector3& corner : triangle.Corners)
      {
        node.Low[d] = std::min(node.Low[d], corner[d]);
        node.High[d] = std::max(node.High[d], corner[d]);
      }
      mean[d] += area * input.Items[i].Centroid[d];
      node.Area[d] += vector[d];
    }
  }
  node.SetCenter(mean);
  for (std::size_t i = node.Begin; i < node.End; ++i)
  {
    node.AddMoment(areas[i - node.Begin], input.Items[i].Centroid);
    for (const Vector3& corner : input.Triangles[input.Items[i].Index].Corners)
    {
      node.Radius = std::max(node.Radius, Norm(Subtract(corner, node.Center)));
    }
  }
}

void WindingTree::SumChildren(const Node& first, const Node& second, Node& node)
{
  Vector3 mean{};
  Vector3 far{};
  node.Weight = first.Weight + second.Weight;
  node.Deviation = std::max(first.Deviation, second.Deviation);
  for (int d = 0; d < 3; ++d)
  {
    node.Low[d] = std::min(first.Low[d], second.Low[d]);
    node.High[d] = std::max(first.High[d], second.High[d]);
    node.Area[d] = first.Area[d] + second.Area[d];
    mean[d] = first.Weight * first.Center[d] + second.Weight * second.Center[d];
  }
  node.SetCenter(mean);
  for (int i = 0; i < 6; ++i)
  {
    node.Moment[i] = first.Moment[i] + second.Moment[i];
  }
  node.AddMoment(first.Area, first.Center);
  node.AddMoment(second.Area, second.Center);
  for (int d = 0; d < 3; ++d)
  {
    far[d] = std::max(node.High[d] - node.Center[d], node.Center[d] - node.Low[d]);
  }
  // No corner is farther away than that of the box, nor than those of the children.
  node.Radius = std::min(Norm(far),
    std::max(Norm(Subtract(first.Center, node.Center)) + first.Radius,
      Norm(Subtract(second.Center, node.Center)) + second.Radius));
}

void WindingTree::Node::SetCenter(const Vector3& mean)
{
  for (int d = 0; d < 3; ++d)
  {
    this->Center[d] = this->Weight > 0.0 ? mean[d] / this->Weight : 0.5 * (this->Low[d] + this->High[d]);
  }
}

void WindingTree::Node::AddMoment(const Vector3& area, const Vector3& at)
{
  const Vector3 c = Subtract(at, this->Center);
  for (int d = 0; d < 3; ++d)
  {
    const int e = (d + 1) % 3;
    this->Moment[d] += area[d] * c[d];
    this->Moment[3 + d] += 0.5 * (area[d] * c[e] + area[e] * c[d]);
  }
}
}
