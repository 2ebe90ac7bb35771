#include "smExportTopology.h"

#include "smVector.h"

#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sm
{
namespace
{
/// Ends of coedges that are farther apart than this, relative to the body's size, do not share a vertex; the
/// reader's limit for closed loops.
constexpr double SameVertex = 1e-5;

/// A jump in (u,v) between coedges above this fraction of the surface's domain is not rounding; OpenCASCADE's
/// check allows 0.01.
constexpr double JumpFraction = 0.005;

/// Number of samples of an edge between two of its breaks, and the smallest total number. OpenCASCADE's check
/// takes 23.
constexpr int SamplesPerPiece = 4;
constexpr int MinSamples = 46;
constexpr int JumpSamples = 16;
}

ExportTopology::ExportTopology(vtkTrimmedNURBSModel* model)
  : Model(model)
{
  this->CollectEdges();
  this->MeasureSize();
  this->JoinVertices();
  this->MeasureGaps();
  for (const EdgeRecord& edge : this->Edges)
  {
    for (const int node : edge.Nodes)
    {
      this->Vertices[node].Reach = std::max(this->Vertices[node].Reach, edge.Gap);
      this->Vertices[node].IsUsed = true;
    }
  }
}

void ExportTopology::CollectEdges()
{
  for (const FacePointer& face : this->Model->GetFaces())
  {
    for (const Loop& loop : face->Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        if (this->Index.emplace(coedge.Use.get(), this->Edges.size()).second)
        {
          EdgeRecord record;
          record.Source = coedge.Use;
          for (int end = 0; end < 2; ++end)
          {
            record.Nodes[end] = static_cast<int>(this->Vertices.size());
            this->Vertices.emplace_back();
            this->Vertices.back().Position = end == 0 ? coedge.Use->StartVertex : coedge.Use->EndVertex;
          }
          this->Edges.push_back(record);
        }
      }
    }
  }
  this->Parent.resize(this->Vertices.size());
  std::iota(this->Parent.begin(), this->Parent.end(), 0);
}

void ExportTopology::MeasureSize()
{
  const double* b = this->Model->GetLocalBounds();
  this->Size = std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  Vector3 low{ 1e300, 1e300, 1e300 };
  Vector3 high{ -1e300, -1e300, -1e300 };
  for (std::size_t i = 0; this->Size == 0.0 && i < this->Edges.size(); ++i)
  {
    for (const Vector3& p : this->Edges[i].Source->Curve.Coefficients)
    {
      for (int c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], p[c]);
        high[c] = std::max(high[c], p[c]);
      }
    }
  }
  this->Size = low[0] <= high[0] ? GetDistance(low, high) : this->Size;
}

int ExportTopology::Find(int node)
{
  while (this->Parent[node] != node)
  {
    node = this->Parent[node] = this->Parent[this->Parent[node]];
  }
  return node;
}

void ExportTopology::Join(int first, int second)
{
  const int a = this->Find(first);
  const int b = this->Find(second);
  this->Parent[std::max(a, b)] = std::min(a, b);
}

void ExportTopology::JoinVertices()
{
  for (const EdgeRecord& edge : this->Edges)
  {
    if (edge.Source->Degenerate)
    {
      this->Join(edge.Nodes[0], edge.Nodes[1]);
    }
  }
  for (const FacePointer& face : this->Model->GetFaces())
  {
    for (const Loop& loop : face->Loops)
    {
      for (std::size_t i = 0; i < loop.Coedges.size(); ++i)
      {
        const int end = this->GetNode(loop.Coedges[i], true);
        const int start = this->GetNode(loop.Coedges[(i + 1) % loop.Coedges.size()], false);
        const double gap = GetDistance(this->Vertices[end].Position, this->Vertices[start].Position);
        if (gap <= SameVertex * this->Size)
        {
          this->Join(end, start);
        }
        else
        {
          ++this->OpenCorners;
        }
      }
    }
  }
  for (EdgeRecord& edge : this->Edges)
  {
    for (int& node : edge.Nodes)
    {
      const int root = this->Find(node);
      this->Reach(root, this->Vertices[node].Position);
      node = root;
    }
  }
}

void ExportTopology::Reach(int node, const Vector3& point)
{
  VertexRecord& vertex = this->Vertices[node];
  vertex.Reach = std::max(vertex.Reach, GetDistance(vertex.Position, point));
}

void ExportTopology::MeasureGaps()
{
  for (EdgeRecord& edge : this->Edges)
  {
    this->Reach(edge.Nodes[0], edge.Source->Curve.GetStartPoint());
    this->Reach(edge.Nodes[1], edge.Source->Curve.GetEndPoint());
  }
  for (const FacePointer& face : this->Model->GetFaces())
  {
    for (const Loop& loop : face->Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        this->MeasureGap(*face, coedge);
      }
      this->FindJumps(*face, loop);
    }
  }
}

void ExportTopology::MeasureGap(const Face& face, const Coedge& coedge)
{
  EdgeRecord& edge = this->Edges[this->GetEdge(coedge)];
  const std::vector<double>& breaks = coedge.Curve.Breaks;
  const int pieces = coedge.Curve.GetNumberOfPieces();
  const int samples = std::max(SamplesPerPiece, (MinSamples + pieces - 1) / pieces);
  for (int piece = 0; piece < pieces; ++piece)
  {
    for (int k = piece == 0 ? 0 : 1; k <= samples; ++k)
    {
      const double t =
        k == samples ? breaks[piece + 1] : breaks[piece] + (breaks[piece + 1] - breaks[piece]) * k / samples;
      const auto uv = coedge.Curve.Evaluate(t);
      Vector3 p;
      face.Surface.Evaluate(uv[0], uv[1], p.data());
      if (edge.Source->Degenerate)
      {
        this->Reach(edge.Nodes[0], p);
        continue;
      }
      edge.Gap = std::max(edge.Gap, GetDistance(p, edge.Source->Curve.Evaluate(t)));
      if (t == breaks.front() || t == breaks.back())
      {
        this->Reach(edge.Nodes[t == breaks.front() ? 0 : 1], p);
      }
    }
  }
}

/// Finds the places where a loop jumps in (u,v) but not in space: the image of the straight piece between two
/// coedges is the vertex between them.
void ExportTopology::FindJumps(const Face& face, const Loop& loop)
{
  for (std::size_t i = 0; i < loop.Coedges.size(); ++i)
  {
    const Coedge& next = loop.Coedges[(i + 1) % loop.Coedges.size()];
    const int node = this->GetNode(loop.Coedges[i], true);
    const TrimCurve::Point a = GetEnd(loop.Coedges[i], true);
    const TrimCurve::Point b = GetEnd(next, false);
    bool jumps = false;
    for (int d = 0; d < 2; ++d)
    {
      const double width = face.Surface.GetDomainEnd(d) - face.Surface.GetDomainStart(d);
      jumps = jumps || std::abs(b[d] - a[d]) > JumpFraction * width;
    }
    double extent = 0.0;
    for (int k = 0; jumps && k <= JumpSamples; ++k)
    {
      Vector3 p;
      const double x = static_cast<double>(k) / JumpSamples;
      face.Surface.Evaluate(a[0] + x * (b[0] - a[0]), a[1] + x * (b[1] - a[1]), p.data());
      extent = std::max(extent, GetDistance(p, this->Vertices[node].Position));
    }
    if (jumps && extent <= SameVertex * this->Size && node == this->GetNode(next, false))
    {
      this->Vertices[node].Reach = std::max(this->Vertices[node].Reach, extent);
      this->Jumps.insert({ &loop, i });
    }
  }
}
}
