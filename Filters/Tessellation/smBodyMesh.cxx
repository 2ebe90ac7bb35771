#include "smBodyMesh.h"

#include "smParallelFor.h"
#include "smVector.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <unordered_map>

namespace sm
{
namespace
{
/// Rounds in which chords are halved because faces ask for it.
constexpr int MostRounds = 7;
/// Faces between two questions whether to stop.
constexpr std::size_t Chunk = 512;
/// Ends of coedges that are one vertex and nearer than this part of the face in u and v are one point.
constexpr double MeetingShare = 1e-2;
/// Wider angles would leave too few chords to a circle.
constexpr double WidestAngle = 1.2;

bool IsUsable(const Coedge& coedge)
{
  return coedge.Use && coedge.Curve.GetNumberOfPieces() > 0 && coedge.Use->Curve.GetNumberOfPieces() > 0;
}

class BodyMesher
{
public:
  BodyMesher(
    const std::vector<FacePointer>& faces, const MeshLimits& limits, const ProgressCallback& progress)
    : Faces(faces)
    , Limits(limits)
    , Progress(progress)
  {
    this->Limits.Angle = std::min(limits.Angle, WidestAngle);
  }

  std::vector<FaceMesh> Run()
  {
    this->Meshes.resize(this->Faces.size());
    this->GatherEdges();
    this->JoinVertices();
    this->Blocks.resize(this->Faces.size());
    ParallelFor(this->Faces.size(), 4,
      [this](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          this->MakeBlocks(i);
        }
      });
    this->SampleEdges();
    std::vector<std::size_t> open(this->Faces.size());
    std::iota(open.begin(), open.end(), std::size_t(0));
    for (int round = 0; !open.empty() && round <= MostRounds; ++round)
    {
      open = this->MeshAll(open, round < MostRounds);
    }
    this->Report(1.0);
    return std::move(this->Meshes);
  }

private:
  struct SharedEdge
  {
    const Edge* Source;
    std::vector<EdgeUse> Uses;
    std::vector<std::size_t> Faces;
    std::vector<double> T;
    std::vector<Vector3> Points;
    /// Index of the first inner point among all shared points.
    int First = 0;
    /// Indices of its vertices, after JoinVertices() of their representatives.
    int Vertices[2];
  };

  bool Report(double share) const { return !this->Progress || this->Progress(share); }

  void GatherEdges()
  {
    for (std::size_t f = 0; f < this->Faces.size(); ++f)
    {
      for (const Loop& loop : this->Faces[f]->Loops)
      {
        for (const Coedge& coedge : loop.Coedges)
        {
          if (!IsUsable(coedge))
          {
            continue;
          }
          const auto entry = this->Index.emplace(coedge.Use.get(), this->Edges.size());
          if (entry.second)
          {
            this->Edges.emplace_back();
            this->Edges.back().Source = coedge.Use.get();
          }
          this->Edges[entry.first->second].Faces.push_back(f);
        }
      }
    }
  }

  int Find(int vertex)
  {
    while (this->Parent[vertex] != vertex)
    {
      vertex = this->Parent[vertex] = this->Parent[this->Parent[vertex]];
    }
    return vertex;
  }

  /// The end of edge e: its vertex where that is near.
  Vector3 GetEnd(const Edge& edge, int end) const
  {
    const Vector3& vertex = end == 0 ? edge.StartVertex : edge.EndVertex;
    const Vector3& point = end == 0 ? edge.Curve.GetStartPoint() : edge.Curve.GetEndPoint();
    const double limit = std::max(2.0 * edge.Tolerance, 0.5 * this->Limits.Deflection);
    return Norm(Subtract(vertex, point)) <= limit ? vertex : point;
  }

  void JoinVertices()
  {
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      for (int end = 0; end < 2; ++end)
      {
        this->Vertices.push_back(this->GetEnd(*this->Edges[e].Source, end));
        this->Parent.push_back(static_cast<int>(this->Parent.size()));
      }
      if (this->Edges[e].Source->Degenerate)
      {
        this->Parent.back() = this->Parent.back() - 1;
      }
    }
    for (const FacePointer& face : this->Faces)
    {
      for (const Loop& loop : face->Loops)
      {
        std::vector<const Coedge*> used;
        for (const Coedge& coedge : loop.Coedges)
        {
          if (IsUsable(coedge))
          {
            used.push_back(&coedge);
          }
        }
        for (std::size_t i = 0; i < used.size(); ++i)
        {
          const Coedge& a = *used[i];
          const Coedge& b = *used[(i + 1) % used.size()];
          int from = 2 * static_cast<int>(this->Index[a.Use.get()]) + (a.Reversed ? 0 : 1);
          int to = 2 * static_cast<int>(this->Index[b.Use.get()]) + (b.Reversed ? 1 : 0);
          const double limit = std::max(2.0 * (a.Use->Tolerance + b.Use->Tolerance), this->Limits.Deflection);
          if (Norm(Subtract(this->Vertices[from], this->Vertices[to])) <= limit)
          {
            from = this->Find(from);
            to = this->Find(to);
            this->Parent[std::max(from, to)] = std::min(from, to);
          }
        }
      }
    }
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      for (int end = 0; end < 2; ++end)
      {
        this->Edges[e].Vertices[end] = this->Find(2 * static_cast<int>(e) + end);
      }
    }
  }

  void MakeBlocks(std::size_t index)
  {
    const Face& face = *this->Faces[index];
    ParameterBox box;
    bool any = false;
    for (const Loop& loop : face.Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        if (!IsUsable(coedge))
        {
          continue;
        }
        for (const auto& c : coedge.Curve.Coefficients)
        {
          box = any ? box : ParameterBox{ c, c };
          box.Add(c);
          any = true;
        }
      }
    }
    if (!any)
    {
      box = { { face.Surface.GetDomainStart(0), face.Surface.GetDomainStart(1) },
        { face.Surface.GetDomainEnd(0), face.Surface.GetDomainEnd(1) } };
    }
    this->Blocks[index] = std::make_unique<SurfaceBlocks>(face.Surface, box);
  }

  void SampleEdges()
  {
    for (std::size_t f = 0; f < this->Faces.size(); ++f)
    {
      for (const Loop& loop : this->Faces[f]->Loops)
      {
        for (const Coedge& coedge : loop.Coedges)
        {
          if (IsUsable(coedge))
          {
            this->Edges[this->Index[coedge.Use.get()]].Uses.push_back(
              { this->Blocks[f].get(), &coedge.Curve });
          }
        }
      }
    }
    ParallelFor(this->Edges.size(), 16,
      [this](std::size_t begin, std::size_t end)
      {
        for (std::size_t e = begin; e < end; ++e)
        {
          SharedEdge& edge = this->Edges[e];
          const bool closed = edge.Vertices[0] == edge.Vertices[1] && !edge.Source->Degenerate;
          edge.T = SampleEdge(*edge.Source, edge.Uses, this->Limits, closed ? 3 : 1);
          this->PlacePoints(edge);
        }
      });
    this->CountPoints();
  }

  void PlacePoints(SharedEdge& edge) const
  {
    edge.Points.clear();
    for (const double t : edge.T)
    {
      edge.Points.push_back(
        edge.Source->Degenerate ? this->Vertices[edge.Vertices[0]] : edge.Source->Curve.Evaluate(t));
    }
    edge.Points.front() = this->Vertices[edge.Vertices[0]];
    edge.Points.back() = this->Vertices[edge.Vertices[1]];
  }

  void CountPoints()
  {
    int next = static_cast<int>(this->Vertices.size());
    for (SharedEdge& edge : this->Edges)
    {
      edge.First = next;
      next += static_cast<int>(edge.T.size()) - 2;
    }
  }

  /// The points of a coedge in loop direction.
  void AppendCoedge(const Coedge& coedge, BoundaryLoop& loop) const
  {
    const int index = static_cast<int>(this->Index.at(coedge.Use.get()));
    const SharedEdge& edge = this->Edges[index];
    const int count = static_cast<int>(edge.T.size());
    loop.reserve(loop.size() + count);
    for (int i = 0; i < count; ++i)
    {
      const int k = coedge.Reversed ? count - 1 - i : i;
      BoundaryPoint p;
      p.Parameters = coedge.Curve.Evaluate(edge.T[k]);
      p.Position = edge.Points[k];
      p.Shared = edge.Source->Degenerate || k == 0 ? edge.Vertices[0]
                                                   : (k + 1 == count ? edge.Vertices[1] : edge.First + k - 1);
      if (i + 1 < count)
      {
        p.Edge = index;
        p.Chord = coedge.Reversed ? k - 1 : k;
      }
      loop.push_back(p);
    }
  }

  /// The borders of the domain, for a face without loops.
  BoundaryLoop MakeBorder(std::size_t f) const
  {
    const ParameterBox& box = this->Blocks[f]->GetCovered();
    const std::array<double, 2> corners[5] = { box.Low, { box.High[0], box.Low[1] }, box.High,
      { box.Low[0], box.High[1] }, box.Low };
    BoundaryLoop loop;
    for (int side = 0; side < 4; ++side)
    {
      Coedge coedge;
      coedge.Curve.Breaks.push_back(0.0);
      coedge.Curve.AppendPiece(1.0, corners + side, 1);
      Edge edge;
      edge.Degenerate = true;
      edge.Curve.Breaks.push_back(0.0);
      edge.Curve.AppendPiece(1.0, &edge.StartVertex, 0);
      const std::vector<double> t =
        SampleEdge(edge, { { this->Blocks[f].get(), &coedge.Curve } }, this->Limits, 1);
      for (std::size_t i = 0; i + 1 < t.size(); ++i)
      {
        BoundaryPoint p;
        p.Parameters = coedge.Curve.Evaluate(t[i]);
        this->Faces[f]->Surface.Evaluate(p.Parameters[0], p.Parameters[1], p.Position.data());
        loop.push_back(p);
      }
    }
    return loop;
  }

  std::vector<BoundaryLoop> MakeLoops(std::size_t f) const
  {
    std::vector<BoundaryLoop> loops;
    for (const Loop& from : this->Faces[f]->Loops)
    {
      BoundaryLoop all;
      for (const Coedge& coedge : from.Coedges)
      {
        if (IsUsable(coedge))
        {
          this->AppendCoedge(coedge, all);
        }
      }
      // Where coedges meet, one point is enough.
      const ParameterBox& box = this->Blocks[f]->GetCovered();
      BoundaryLoop loop;
      loop.reserve(all.size());
      for (std::size_t i = 0; i < all.size(); ++i)
      {
        const BoundaryPoint& next = all[(i + 1) % all.size()];
        bool meets = all[i].Shared == next.Shared;
        for (int d = 0; d < 2; ++d)
        {
          meets = meets &&
            std::abs(all[i].Parameters[d] - next.Parameters[d]) <= MeetingShare * (box.High[d] - box.Low[d]);
        }
        if (all[i].Edge >= 0 || !meets)
        {
          loop.push_back(all[i]);
        }
      }
      if (loop.size() > 1)
      {
        loops.push_back(std::move(loop));
      }
    }
    if (loops.empty())
    {
      loops.push_back(this->MakeBorder(f));
    }
    return loops;
  }

  /// Meshes faces; returns those that have to be meshed again.
  std::vector<std::size_t> MeshAll(const std::vector<std::size_t>& open, bool mayHalve)
  {
    std::vector<std::vector<std::pair<int, int>>> halve(open.size());
    for (std::size_t start = 0; start < open.size(); start += Chunk)
    {
      if (!this->Report(open.size() < this->Faces.size()
              ? 1.0
              : static_cast<double>(start) / static_cast<double>(open.size())))
      {
        return {};
      }
      ParallelFor(std::min(open.size() - start, Chunk), 2,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = start + begin; i < start + end; ++i)
          {
            const std::size_t f = open[i];
            this->Meshes[f] = MeshFace(*this->Faces[f], *this->Blocks[f], this->MakeLoops(f), this->Limits,
              mayHalve ? &halve[i] : nullptr);
          }
        });
    }
    return this->Halve(halve);
  }

  std::vector<std::size_t> Halve(const std::vector<std::vector<std::pair<int, int>>>& asked)
  {
    std::vector<std::pair<int, int>> chords;
    for (const auto& list : asked)
    {
      chords.insert(chords.end(), list.begin(), list.end());
    }
    std::sort(chords.begin(), chords.end());
    chords.erase(std::unique(chords.begin(), chords.end()), chords.end());
    std::vector<std::size_t> again;
    // From the last chord of an edge to its first, so that numbers stay.
    for (auto it = chords.rbegin(); it != chords.rend(); ++it)
    {
      SharedEdge& edge = this->Edges[it->first];
      edge.T.insert(edge.T.begin() + it->second + 1, 0.5 * (edge.T[it->second] + edge.T[it->second + 1]));
      again.insert(again.end(), edge.Faces.begin(), edge.Faces.end());
    }
    for (const auto& chord : chords)
    {
      this->PlacePoints(this->Edges[chord.first]);
    }
    this->CountPoints();
    std::sort(again.begin(), again.end());
    again.erase(std::unique(again.begin(), again.end()), again.end());
    return again;
  }

  const std::vector<FacePointer>& Faces;
  MeshLimits Limits;
  const ProgressCallback& Progress;
  std::unordered_map<const Edge*, std::size_t> Index;
  std::vector<SharedEdge> Edges;
  /// Ends of edges, two for each, and the union of those that are one.
  std::vector<Vector3> Vertices;
  std::vector<int> Parent;
  std::vector<std::unique_ptr<SurfaceBlocks>> Blocks;
  std::vector<FaceMesh> Meshes;
};
}

std::vector<FaceMesh> MeshFaces(
  const std::vector<FacePointer>& faces, const MeshLimits& limits, const ProgressCallback& progress)
{
  return BodyMesher(faces, limits, progress).Run();
}
}
