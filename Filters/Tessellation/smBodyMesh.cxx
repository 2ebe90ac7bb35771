#include "smBodyMesh.h"

#include "smBernstein.h"
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
constexpr int MaxRounds = 7;
/// Faces between two questions whether to stop.
constexpr std::size_t Chunk = 512;
/// Ends of coedges that are one vertex and nearer than this part of the face in u and v are one point.
constexpr double MeetingShare = 1e-2;
/// Wider angles would leave too few chords to a circle.
constexpr double MaxAngle = 1.2;

/// Steps of a grid around a whole sphere.
constexpr int SphereSteps = 8;

FaceMesh MeshSphere(const Face& face, const WholeSphere& sphere)
{
  SphereGrid grid = MakeSphereGrid(face, sphere, SphereSteps);
  FaceMesh mesh;
  mesh.Points = std::move(grid.Points);
  mesh.Normals = std::move(grid.Normals);
  mesh.Parameters = std::move(grid.Parameters);
  mesh.Triangles = std::move(grid.Triangles);
  mesh.Deviation = grid.Deviation;
  mesh.NormalTurn = grid.NormalTurn;
  mesh.Sphere = sphere;
  return mesh;
}

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
    this->Limits.Angle = std::min(limits.Angle, MaxAngle);
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
    for (int round = 0; !open.empty() && round <= MaxRounds; ++round)
    {
      open = this->MeshAll(open, round < MaxRounds);
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
    EdgeSamples Samples;
    /// At Samples.T.
    std::vector<Vector3> Points;
    /// Index of the first inner point among all shared points.
    int First = 0;
    /// Indices of its vertices, after JoinVertices() of their representatives.
    int Vertices[2];
  };

  /// A coedge that can be used, its edge, its number among the edge's uses, and its loop.
  struct SharedCoedge
  {
    const Coedge* Source;
    int Edge;
    int Use;
    int Loop;
  };

  bool Report(double share) const { return !this->Progress || this->Progress(share); }

  void GatherEdges()
  {
    std::unordered_map<const Edge*, int> numbers;
    this->Coedges.resize(this->Faces.size());
    for (std::size_t f = 0; f < this->Faces.size(); ++f)
    {
      int number = 0;
      for (const Loop& loop : this->Faces[f]->Loops)
      {
        for (const Coedge& coedge : loop.Coedges)
        {
          if (!IsUsable(coedge))
          {
            continue;
          }
          const auto entry = numbers.emplace(coedge.Use.get(), static_cast<int>(this->Edges.size()));
          if (entry.second)
          {
            this->Edges.emplace_back();
            this->Edges.back().Source = coedge.Use.get();
          }
          SharedEdge& edge = this->Edges[entry.first->second];
          this->Coedges[f].push_back(
            { &coedge, entry.first->second, static_cast<int>(edge.Faces.size()), number });
          edge.Faces.push_back(f);
        }
        ++number;
      }
    }
  }

  /// One past the last coedge of a face that is in the loop of coedge `first`.
  static std::size_t FindLoopEnd(const std::vector<SharedCoedge>& coedges, std::size_t first)
  {
    std::size_t last = first;
    while (last < coedges.size() && coedges[last].Loop == coedges[first].Loop)
    {
      ++last;
    }
    return last;
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
    for (const std::vector<SharedCoedge>& coedges : this->Coedges)
    {
      std::size_t last = 0;
      for (std::size_t first = 0; first < coedges.size(); first = last)
      {
        last = FindLoopEnd(coedges, first);
        for (std::size_t i = first; i < last; ++i)
        {
          this->JoinEnds(coedges[i], coedges[i + 1 < last ? i + 1 : first]);
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

  /// Makes the end of a coedge and the start of the next one vertex, where they are near.
  void JoinEnds(const SharedCoedge& a, const SharedCoedge& b)
  {
    int from = 2 * a.Edge + (a.Source->Reversed ? 0 : 1);
    int to = 2 * b.Edge + (b.Source->Reversed ? 1 : 0);
    const double limit =
      std::max(2.0 * (a.Source->Use->Tolerance + b.Source->Use->Tolerance), this->Limits.Deflection);
    if (Norm(Subtract(this->Vertices[from], this->Vertices[to])) <= limit)
    {
      from = this->Find(from);
      to = this->Find(to);
      this->Parent[std::max(from, to)] = std::min(from, to);
    }
  }

  void MakeBlocks(std::size_t index)
  {
    const Face& face = *this->Faces[index];
    ParameterBox box;
    bool any = false;
    for (const SharedCoedge& coedge : this->Coedges[index])
    {
      for (const auto& c : coedge.Source->Curve.Coefficients)
      {
        box = any ? box : ParameterBox{ c, c };
        box.Add(c);
        any = true;
      }
    }
    if (!any)
    {
      box = { { face.Surface.GetDomainStart(0), face.Surface.GetDomainStart(1) },
        { face.Surface.GetDomainEnd(0), face.Surface.GetDomainEnd(1) } };
    }
    this->Blocks[index] = std::make_unique<SurfaceBlocks>(face.Surface, box, this->Limits);
  }

  void SampleEdges()
  {
    for (std::size_t f = 0; f < this->Faces.size(); ++f)
    {
      for (const SharedCoedge& coedge : this->Coedges[f])
      {
        this->Edges[coedge.Edge].Uses.push_back({ this->Blocks[f].get(), &coedge.Source->Curve });
      }
    }
    ParallelFor(this->Edges.size(), 16,
      [this](std::size_t begin, std::size_t end)
      {
        for (std::size_t e = begin; e < end; ++e)
        {
          SharedEdge& edge = this->Edges[e];
          const bool closed = edge.Vertices[0] == edge.Vertices[1] && !edge.Source->Degenerate;
          edge.Samples = SampleEdge(*edge.Source, edge.Uses, this->Limits, closed ? 3 : 1);
          this->PlacePoints(edge);
        }
      });
    this->CountPoints();
  }

  void PlacePoints(SharedEdge& edge) const
  {
    edge.Points.clear();
    edge.Points.reserve(edge.Samples.T.size());
    for (const double t : edge.Samples.T)
    {
      edge.Points.push_back(
        edge.Source->Degenerate ? this->Vertices[edge.Vertices[0]] : EvaluateByBasis(edge.Source->Curve, t));
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
      next += static_cast<int>(edge.Samples.T.size()) - 2;
    }
  }

  /// The points of a coedge in loop direction.
  void AppendCoedge(const SharedCoedge& coedge, BoundaryLoop& loop) const
  {
    const SharedEdge& edge = this->Edges[coedge.Edge];
    const bool reversed = coedge.Source->Reversed;
    const int count = static_cast<int>(edge.Samples.T.size());
    const std::array<double, 2>* const at =
      edge.Samples.At.data() + static_cast<std::size_t>(coedge.Use) * count;
    for (int i = 0; i < count; ++i)
    {
      const int k = reversed ? count - 1 - i : i;
      BoundaryPoint p;
      p.Parameters = at[k];
      p.Position = edge.Points[k];
      p.Shared = edge.Source->Degenerate || k == 0 ? edge.Vertices[0]
                                                   : (k + 1 == count ? edge.Vertices[1] : edge.First + k - 1);
      if (i + 1 < count)
      {
        p.Edge = coedge.Edge;
        p.Chord = reversed ? k - 1 : k;
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
      const EdgeSamples samples =
        SampleEdge(edge, { { this->Blocks[f].get(), &coedge.Curve } }, this->Limits, 1);
      for (std::size_t i = 0; i + 1 < samples.T.size(); ++i)
      {
        BoundaryPoint p;
        p.Parameters = samples.At[i];
        this->Faces[f]->Surface.Evaluate(p.Parameters[0], p.Parameters[1], p.Position.data());
        loop.push_back(p);
      }
    }
    return loop;
  }

  std::vector<BoundaryLoop> MakeLoops(std::size_t f) const
  {
    std::vector<BoundaryLoop> loops;
    const std::vector<SharedCoedge>& coedges = this->Coedges[f];
    BoundaryLoop all;
    std::size_t last = 0;
    for (std::size_t first = 0; first < coedges.size(); first = last)
    {
      last = FindLoopEnd(coedges, first);
      all.clear();
      for (std::size_t i = first; i < last; ++i)
      {
        this->AppendCoedge(coedges[i], all);
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
      std::vector<double>& t = edge.Samples.T;
      t.insert(t.begin() + it->second + 1, 0.5 * (t[it->second] + t[it->second + 1]));
      again.insert(again.end(), edge.Faces.begin(), edge.Faces.end());
    }
    for (std::size_t i = 0; i < chords.size(); ++i)
    {
      SharedEdge& edge = this->Edges[chords[i].first];
      if (i == 0 || chords[i].first != chords[i - 1].first)
      {
        EvaluateTrims(edge.Uses, edge.Samples);
        this->PlacePoints(edge);
      }
    }
    this->CountPoints();
    std::sort(again.begin(), again.end());
    again.erase(std::unique(again.begin(), again.end()), again.end());
    return again;
  }

  const std::vector<FacePointer>& Faces;
  MeshLimits Limits;
  const ProgressCallback& Progress;
  std::vector<SharedEdge> Edges;
  /// The coedges of every face.
  std::vector<std::vector<SharedCoedge>> Coedges;
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

std::vector<FaceMesh> MeshForScales(
  const std::vector<FacePointer>& faces, const MeshLimits& limits, const ProgressCallback& progress)
{
  const std::vector<WholeSphere> spheres = FindWholeSpheres(faces);
  if (spheres.empty())
  {
    return MeshFaces(faces, limits, progress);
  }
  std::vector<FacePointer> others;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (!spheres[f])
    {
      others.push_back(faces[f]);
    }
  }
  std::vector<FaceMesh> meshed = MeshFaces(others, limits, progress);
  std::vector<FaceMesh> meshes;
  std::size_t next = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    meshes.push_back(spheres[f] ? MeshSphere(*faces[f], spheres[f]) : std::move(meshed[next++]));
  }
  return meshes;
}
}
