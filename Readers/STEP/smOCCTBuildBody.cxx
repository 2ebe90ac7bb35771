#include "smOCCTBuildBody.h"

#include "smFormat.h"
#include "smOCCTBuildGeometry.h"
#include "smOCCTFailure.h"

#include "vtkTrimmedNURBSModel.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

namespace sm
{
namespace
{
/// Ends of coedges farther apart than that part of the body's size have no vertex in common; as the reader judges loops.
constexpr double VertexTolerance = 1e-5;

/// A boundary that lies farther from its edge, relative to the body's size, is worth a sentence.
constexpr double GapToTell = 1e-5;

/// A jump between coedges of that part of the surface's domain is no rounding: OpenCASCADE's check allows 0.01.
constexpr double JumpFraction = 0.005;

/// Samples of an edge between two of its breaks, and the least number of all: OpenCASCADE's own check takes 23.
constexpr int SamplesPerPiece = 4;
constexpr int LeastSamples = 46;
constexpr int JumpSamples = 16;

double GetDistance(const Vector3& a, const Vector3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

gp_Pnt ToPoint(const Vector3& p)
{
  return { p[0], p[1], p[2] };
}

class BodyBuilder
{
public:
  BodyBuilder(vtkTrimmedNURBSModel* model, const AffineMap& map)
    : Model(model)
    , Map(map)
    , Scale(map.GetScale())
  {
  }

  BuiltBody Build()
  {
    this->CollectEdges();
    this->MeasureSize();
    this->JoinVertices();
    this->MeasureGaps();
    this->BuildVertices();
    this->Result.Faces.resize(this->Model->GetFaces().size());
    for (std::size_t i = 0; i < this->Result.Faces.size(); ++i)
    {
      this->TryFace(i);
    }
    this->Assemble();
    this->AddGapWarning();
    return std::move(this->Result);
  }

private:
  struct EdgeRecord
  {
    std::shared_ptr<const Edge> Source;
    /// Vertices at its start and end, before joining.
    int Nodes[2] = { 0, 0 };
    /// Largest distance of the faces from the curve at equal parameters, in stored lengths.
    double Gap = 0.0;
    /// The same edge once more for a face that uses it twice in one direction.
    std::vector<TopoDS_Edge> Copies;
  };
  struct VertexRecord
  {
    Vector3 Position{};
    double Reach = 0.0;
    TopoDS_Vertex Vertex;
  };

  using Jump = std::pair<const Loop*, std::size_t>;

  void CollectEdges()
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

  /// Diagonal of the body's box; of that of its edges where it has none.
  void MeasureSize()
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

  int Find(int node)
  {
    while (this->Parent[node] != node)
    {
      node = this->Parent[node] = this->Parent[this->Parent[node]];
    }
    return node;
  }

  /// The vertex of the edge that the coedge leads to, or comes from.
  int GetNode(const Coedge& coedge, bool last)
  {
    return this->Edges[this->Index[coedge.Use.get()]].Nodes[last != coedge.Reversed ? 1 : 0];
  }

  void Join(int first, int second)
  {
    const int a = this->Find(first);
    const int b = this->Find(second);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

  void JoinVertices()
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
          if (gap <= VertexTolerance * this->Size)
          {
            this->Join(end, start);
          }
          else
          {
            ++this->OpenLoops;
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

  void Reach(int node, const Vector3& point)
  {
    VertexRecord& vertex = this->Vertices[node];
    vertex.Reach = std::max(vertex.Reach, GetDistance(vertex.Position, point));
  }

  void MeasureGaps()
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

  void MeasureGap(const Face& face, const Coedge& coedge)
  {
    EdgeRecord& edge = this->Edges[this->Index[coedge.Use.get()]];
    const std::vector<double>& breaks = coedge.Curve.Breaks;
    const int pieces = coedge.Curve.GetNumberOfPieces();
    const int samples = std::max(SamplesPerPiece, (LeastSamples + pieces - 1) / pieces);
    for (int piece = 0; piece < pieces; ++piece)
    {
      for (int k = piece == 0 ? 0 : 1; k <= samples; ++k)
      {
        const double t = k == samples ? breaks[piece + 1]
                                      : breaks[piece] + (breaks[piece + 1] - breaks[piece]) * k / samples;
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

  static TrimCurve::Point GetEnd(const Coedge& coedge, bool last)
  {
    return last != coedge.Reversed ? coedge.Curve.GetEndPoint() : coedge.Curve.GetStartPoint();
  }

  /// A straight piece from the end of a coedge to the start of the next one whose image is the vertex between them.
  void FindJumps(const Face& face, const Loop& loop)
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
      if (jumps && extent <= VertexTolerance * this->Size && node == this->GetNode(next, false))
      {
        this->Vertices[node].Reach = std::max(this->Vertices[node].Reach, extent);
        this->Jumps.insert({ &loop, i });
      }
    }
  }

  double GetTolerance(double gap) const
  {
    // One per cent for what lies between the samples.
    return std::max(Precision::Confusion(), 1.01 * this->Scale * gap);
  }

  void BuildVertices()
  {
    for (const EdgeRecord& edge : this->Edges)
    {
      for (const int node : edge.Nodes)
      {
        this->Vertices[node].Reach = std::max(this->Vertices[node].Reach, edge.Gap);
      }
    }
    const BRep_Builder builder;
    for (std::size_t i = 0; i < this->Vertices.size(); ++i)
    {
      if (this->Parent[i] == static_cast<int>(i))
      {
        VertexRecord& vertex = this->Vertices[i];
        const gp_XYZ p = ToPoint(vertex.Position).XYZ();
        builder.MakeVertex(vertex.Vertex, ToPoint(this->Map.MapPoint(p)), this->GetTolerance(vertex.Reach));
      }
    }
  }

  /// The edge, or the copy of it that this face takes when it has used it in this direction already.
  TopoDS_Edge GetEdge(EdgeRecord& record, std::size_t copy)
  {
    while (record.Copies.size() <= copy)
    {
      const BRep_Builder builder;
      const Edge& source = *record.Source;
      TopoDS_Edge edge;
      if (source.Degenerate)
      {
        builder.MakeEdge(edge);
        builder.Degenerated(edge, true);
        builder.UpdateEdge(edge, this->GetTolerance(this->Vertices[record.Nodes[0]].Reach));
      }
      else
      {
        builder.MakeEdge(edge, BuildCurve(source.Curve, this->Map), this->GetTolerance(record.Gap));
        builder.Range(edge, source.Curve.GetStart(), source.Curve.GetEnd());
      }
      builder.SameRange(edge, true);
      builder.SameParameter(edge, true);
      builder.Add(edge, this->Vertices[record.Nodes[0]].Vertex.Oriented(TopAbs_FORWARD));
      builder.Add(edge, this->Vertices[record.Nodes[1]].Vertex.Oriented(TopAbs_REVERSED));
      record.Copies.push_back(edge);
      this->Result.Edges.emplace_back(edge, record.Source);
      this->DoubledEdges += copy > 0 ? 1 : 0;
    }
    return record.Copies[copy];
  }

  void TryFace(std::size_t index)
  {
    const Face& face = *this->Model->GetFaces()[index];
    const std::string problem = CatchFailure([&]() { this->Result.Faces[index] = this->BuildFace(face); });
    if (problem.empty())
    {
      return;
    }
    this->Result.Warnings.push_back((face.FileId > 0 ? "Face #" + std::to_string(face.FileId)
                                                     : "Face number " + std::to_string(index + 1)) +
      " is not saved: " + problem + ".");
  }

  TopoDS_Face BuildFace(const Face& source)
  {
    const Handle(Geom_BSplineSurface) surface = BuildSurface(source.Surface, this->Map);
    const bool reversed = source.Reversed != this->Map.IsMirrored();
    const TopAbs_Orientation orientation = reversed ? TopAbs_REVERSED : TopAbs_FORWARD;
    if (source.Loops.empty())
    {
      BRepBuilderAPI_MakeFace maker(surface, Precision::Confusion());
      if (!maker.IsDone())
      {
        throw std::runtime_error("OpenCASCADE finds no borders of its surface");
      }
      return TopoDS::Face(maker.Face().Oriented(orientation));
    }
    struct Use
    {
      Handle(Geom2d_BSplineCurve) Curves[2];
      EdgeRecord* Record = nullptr;
    };
    // Curves first: a face that fails leaves no trace on its edges.
    std::map<std::pair<const Edge*, std::size_t>, Use> uses;
    std::vector<std::vector<std::pair<const Edge*, std::size_t>>> keys;
    for (const Loop& loop : source.Loops)
    {
      keys.emplace_back();
      for (const Coedge& coedge : loop.Coedges)
      {
        const int way = coedge.Reversed ? 1 : 0;
        auto key = std::make_pair(static_cast<const Edge*>(coedge.Use.get()), std::size_t(0));
        while (!uses[key].Curves[way].IsNull())
        {
          ++key.second;
        }
        uses[key].Curves[way] = BuildTrim(coedge.Curve);
        uses[key].Record = &this->Edges[this->Index[coedge.Use.get()]];
        keys.back().push_back(key);
      }
    }
    const BRep_Builder builder;
    TopoDS_Face face;
    builder.MakeFace(face, surface, TopLoc_Location(), Precision::Confusion());
    for (const auto& [key, use] : uses)
    {
      const TopoDS_Edge edge = this->GetEdge(*use.Record, key.second);
      const double tolerance = BRep_Tool::Tolerance(edge);
      const bool seam = !use.Curves[0].IsNull() && !use.Curves[1].IsNull();
      if (seam)
      {
        builder.UpdateEdge(edge, use.Curves[0], use.Curves[1], surface, TopLoc_Location(), tolerance);
      }
      else
      {
        builder.UpdateEdge(
          edge, use.Curves[use.Curves[0].IsNull() ? 1 : 0], surface, TopLoc_Location(), tolerance);
      }
      const EdgeCurve& curve = use.Record->Source->Curve;
      builder.Range(edge, surface, TopLoc_Location(), curve.GetStart(), curve.GetEnd());
    }
    for (std::size_t l = 0; l < source.Loops.size(); ++l)
    {
      TopoDS_Wire wire;
      builder.MakeWire(wire);
      for (std::size_t i = 0; i < keys[l].size(); ++i)
      {
        const TopoDS_Edge edge = uses[keys[l][i]].Record->Copies[keys[l][i].second];
        builder.Add(
          wire, edge.Oriented(source.Loops[l].Coedges[i].Reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
        if (this->Jumps.count({ &source.Loops[l], i }) > 0)
        {
          builder.Add(wire, this->BuildJump(source.Loops[l], i, surface));
        }
      }
      wire.Closed(BRep_Tool::IsClosed(wire));
      builder.Add(face, wire);
    }
    return TopoDS::Face(face.Oriented(orientation));
  }

  TopoDS_Edge BuildJump(const Loop& loop, std::size_t i, const Handle(Geom_BSplineSurface) & surface)
  {
    const TrimCurve::Point ends[2] = { GetEnd(loop.Coedges[i], true),
      GetEnd(loop.Coedges[(i + 1) % loop.Coedges.size()], false) };
    TrimCurve straight;
    straight.Breaks.push_back(0.0);
    straight.AppendPiece(1.0, ends, 1);
    const VertexRecord& vertex = this->Vertices[this->GetNode(loop.Coedges[i], true)];
    const BRep_Builder builder;
    TopoDS_Edge edge;
    builder.MakeEdge(edge);
    builder.Degenerated(edge, true);
    builder.UpdateEdge(
      edge, BuildTrim(straight), surface, TopLoc_Location(), this->GetTolerance(vertex.Reach));
    builder.Range(edge, surface, TopLoc_Location(), 0.0, 1.0);
    builder.SameRange(edge, true);
    builder.SameParameter(edge, true);
    builder.Add(edge, vertex.Vertex.Oriented(TopAbs_FORWARD));
    builder.Add(edge, vertex.Vertex.Oriented(TopAbs_REVERSED));
    return edge;
  }

  void Assemble()
  {
    const BRep_Builder builder;
    std::vector<std::vector<int>> lists = this->Model->GetShells();
    if (lists.empty())
    {
      lists.emplace_back(this->Result.Faces.size());
      std::iota(lists[0].begin(), lists[0].end(), 0);
    }
    std::vector<TopoDS_Shell> shells;
    for (const std::vector<int>& list : lists)
    {
      TopoDS_Shell shell;
      builder.MakeShell(shell);
      bool any = false;
      for (const int index : list)
      {
        if (index >= 0 && index < static_cast<int>(this->Result.Faces.size()) &&
          !this->Result.Faces[index].IsNull())
        {
          builder.Add(shell, this->Result.Faces[index]);
          any = true;
        }
      }
      if (any)
      {
        shell.Closed(BRep_Tool::IsClosed(shell));
        shells.push_back(shell);
      }
    }
    if (shells.empty())
    {
      return;
    }
    const bool solid = this->Model->GetBody() == vtkTrimmedNURBSModel::SOLID;
    if (!solid && shells.size() == 1)
    {
      this->Result.Shape = shells[0];
      return;
    }
    TopoDS_Compound compound;
    TopoDS_Solid body;
    TopoDS_Shape& whole = solid ? static_cast<TopoDS_Shape&>(body) : static_cast<TopoDS_Shape&>(compound);
    solid ? builder.MakeSolid(body) : builder.MakeCompound(compound);
    int open = 0;
    for (const TopoDS_Shell& shell : shells)
    {
      builder.Add(whole, shell);
      open += shell.Closed() ? 0 : 1;
    }
    if (solid && open > 0)
    {
      this->Result.Warnings.push_back(
        "The solid is open: not every edge has its two faces. It is saved as it is.");
    }
    this->Result.Shape = whole;
  }

  void AddGapWarning()
  {
    int wide = 0;
    const EdgeRecord* widest = nullptr;
    for (const EdgeRecord& edge : this->Edges)
    {
      if (!edge.Source->Degenerate)
      {
        const std::vector<Vector3>& points = edge.Source->Curve.Coefficients;
        double length = 0.0;
        for (const Vector3& p : points)
        {
          length = std::max(length, GetDistance(p, points.front()));
        }
        length *= this->Scale;
        double& shortest = this->Result.ShortestEdge;
        shortest = shortest == 0.0 ? length : std::min(shortest, length);
        this->Result.Tolerance = std::max(this->Result.Tolerance, this->GetTolerance(edge.Gap));
      }
      wide += edge.Gap > GapToTell * this->Size ? 1 : 0;
      widest = !widest || edge.Gap > widest->Gap ? &edge : widest;
    }
    if (wide > 0)
    {
      const int id = widest->Source->FileId;
      this->Result.Warnings.push_back("Faces lie off " + std::to_string(wide) + " of their edges, by up to " +
        FormatDistance(widest->Gap) + " " + this->Model->GetLengthUnit() +
        (id > 0 ? " at edge #" + std::to_string(id) : std::string()) +
        ". They are saved as they are; programs that heal what they read may change them.");
    }
    if (this->OpenLoops > 0)
    {
      this->Result.Warnings.push_back(std::to_string(this->OpenLoops) +
        " corners of loops do not close: their edges end at different vertices, and are saved so.");
    }
    if (this->DoubledEdges > 0)
    {
      this->Result.Warnings.push_back(std::to_string(this->DoubledEdges) +
        " edges that one face uses twice in the same direction are saved twice.");
    }
  }

  vtkTrimmedNURBSModel* Model;
  const AffineMap& Map;
  double Scale;
  double Size = 0.0;
  std::vector<EdgeRecord> Edges;
  std::unordered_map<const Edge*, std::size_t> Index;
  std::vector<VertexRecord> Vertices;
  std::vector<int> Parent;
  /// Corners, by loop and coedge before them, that a degenerate edge closes.
  std::set<Jump> Jumps;
  int OpenLoops = 0;
  int DoubledEdges = 0;
  BuiltBody Result;
};
}

BuiltBody BuildBody(vtkTrimmedNURBSModel* model, const AffineMap& map)
{
  return BodyBuilder(model, map).Build();
}
}
